// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>
#include <variant>

#include "core/base/clock.h"
#include "core/base/result.h"
#include "core/devices/grabber_base.h"
#include "core/vsystem/snapshot.h"

namespace kambara {

struct EndOfSource {};
struct NothingYet {};
using NextImages = std::variant<ImageSet, EndOfSource, NothingYet>;

/// Brings the pictures of all cameras together, pair by pair. Used by the pipeline's thread.
class FrameSource {
  public:
    virtual ~FrameSource() = default;
    /// Waits for the next set, but not for long: NothingYet lets the caller see to other things.
    virtual Result<NextImages> next(std::stop_token stop) = 0;
    /// Frames dropped because a newer one was there, and frames without a partner.
    virtual std::uint64_t frames_lost() const = 0;
    /// A fault that does not keep pairs from coming, once.
    virtual std::optional<Error> take_fault() { return std::nullopt; }
    /// How many pairs there are; -1 where that is not known or never ends.
    virtual std::int64_t frames() const { return -1; }
    /// Goes on with that frame. Refused by sources that can't be wound, which then stay as they
    /// were.
    virtual Result<Done> seek(std::int64_t /*frame*/) {
        return Error{"Live pictures can't be wound to another frame.", "Open a recording."};
    }
};

/// The grabbers of a system. `right` and `pan_tilt` may be null.
struct Grabbers {
    std::unique_ptr<GrabberBase> left;
    std::unique_ptr<GrabberBase> right;
    std::unique_ptr<GrabberBase> pan_tilt;
};

/// For recordings: takes every frame of each, in step, on the caller's thread. A left and a right
/// recording of different length is an error that says which ended first and where.
std::unique_ptr<FrameSource> make_sequential_source(Grabbers grabbers);

/// For live cameras: a thread each; pairs left and right by time (within half a frame's time),
/// gives the newest pair and counts what it passed over.
/// `clock` tells when they arrive and outlives the source.
std::unique_ptr<FrameSource> make_live_source(Grabbers grabbers, const Clock& clock);

/// Lets the sets of another source come no sooner than their time stamps say, on `clock`, which
/// outlives it. After a break (a hold, a seek, a source that was late) it goes on from there
/// without making up for the time.
std::unique_ptr<FrameSource> make_paced_source(std::unique_ptr<FrameSource> source, Clock& clock);

}  // namespace kambara
