// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/angles.h"
#include "core/base/result.h"
#include "core/devices/head_state.h"

namespace kambara {

/// Where a head is and what it is doing.
struct HeadStatus {
    HeadAngles angles;  ///< where it looks now, not where it was told to look
    bool moving = false;
    std::int64_t time_ns = 0;  ///< when that was so, on the head's clock
    bool operator==(const HeadStatus&) const = default;
};

/// What happened to a head that an operator should be able to read later: an unplugged line, a
/// refused command.
struct HeadNote {
    enum class Kind { note, warning, fault };
    Kind kind = Kind::note;
    std::string text;
    bool operator==(const HeadNote&) const = default;
};

/// A camera on a pan-tilt head. Calls may wait for the device, so they are made from a thread that
/// may wait, never from the pipeline's; they may come from any thread, one at a time or not.
class PanTiltCamera {
  public:
    virtual ~PanTiltCamera() = default;

    virtual std::string name() const = 0;
    virtual HeadLimits limits() const = 0;
    /// What of the below it does not refuse as lacking.
    virtual HeadAbilities abilities() const { return {}; }

    /// Starts towards the angles at full speed and returns at once; a newer call replaces an older.
    /// Refuses angles that are not finite or beyond the limits, and then keeps to what it was
    /// doing.
    virtual Result<Done> move_to(const HeadAngles& angles) = 0;

    /// Steering's way to move a head that follows something: a head that knows its own delays looks
    /// where the target will be when it gets there, and drops an aim that has become old before it
    /// could be told.
    virtual Result<Done> follow(const HeadAim& aim) { return move_to(aim.angles); }
    /// From a call of `follow` to the head's being where it was told, beside the way itself.
    virtual double lag_s() const { return 0.0; }

    /// The same as move_to by an operator's hand: it comes before what steering asked for and did
    /// not yet get.
    virtual Result<Done> move_by_hand(const HeadAngles& angles) { return move_to(angles); }

    /// Stops where it is.
    virtual Result<Done> halt() = 0;

    virtual Result<HeadStatus> status() = 0;

    /// What follows is an operator's, too. A head without it refuses.

    /// Turns at these speeds (right and up positive) until told otherwise or at its limits.
    virtual Result<Done> drive(double /*pan_rad_s*/, double /*tilt_rad_s*/) {
        return lacking("can't be turned at a speed");
    }
    /// Straight ahead.
    virtual Result<Done> home() { return move_by_hand({}); }
    /// Finds its home position anew, as after it was turned by force.
    virtual Result<Done> reset() { return lacking("can't be reset"); }
    /// 0 wide to 1 tele.
    virtual Result<Done> zoom_to(double /*share*/) { return lacking("has no zoom"); }
    /// 0 far to 1 near; autofocus ends with it.
    virtual Result<Done> focus_to(double /*share*/) { return lacking("has no focus"); }
    virtual Result<Done> autofocus() { return lacking("has no autofocus"); }
    virtual Result<LensStatus> lens() { return lacking("does not tell of its lens").error(); }
    /// Presets are numbered from 0.
    virtual Result<Done> keep_preset(int /*number*/) { return lacking("has no presets"); }
    virtual Result<Done> recall_preset(int /*number*/) { return lacking("has no presets"); }

    /// What happened since the last call; never waits for the device.
    virtual std::vector<HeadNote> take_notes() { return {}; }

  private:
    Result<Done> lacking(const std::string& what) const {
        return Error{"The head (" + name() + ") " + what + ".", "Use another head."};
    }
};

}  // namespace kambara
