// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/angles.h"
#include "core/camera/head_model.h"
#include "core/vsystem/snapshot.h"

namespace kambara::ui {

/// A head position to take a view at, and from which side to come to it.
struct HeadStep {
    HeadAngles from;  ///< gone to first
    HeadAngles goal;
    HeadApproach approach;
};

/// Positions over 26 degrees of pan and 13 of tilt about where the target is seen in the middle,
/// each come to from below or from above in turn and then again from the other side; those that
/// the head does not reach are left out.
std::vector<HeadStep> head_steps_about(const HeadAngles& towards, const HeadLimits& limits);

/// Leads the head from position to position. Knows no clock and no device: it is told snapshots
/// with the time they came, and says what is to be done.
///
///     approaching --there--> arriving --there--> settling --still so long--> view due
///          ^------------------------- next() -------------------------------------+
class HeadSequence {
  public:
    enum class Asks { nothing, move, view, give_up };
    struct Request {
        Asks asks = Asks::nothing;
        HeadAngles angles;  ///< to move to, or where the head stands
    };

    void begin(std::vector<HeadStep> steps);
    void end() { steps_.clear(); }
    bool going() const { return at_ < steps_.size(); }
    std::size_t number() const { return at_; }  ///< of the step, from 0
    std::size_t count() const { return steps_.size(); }
    const HeadStep& step() const { return steps_.at(at_); }

    /// A view is asked for once; next() then goes on.
    Request see(const HeadSnapshot& head, std::int64_t now_ms);
    void next();

  private:
    enum class Phase { to_approach, approaching, to_arrive, arriving, settling, viewing };

    std::vector<HeadStep> steps_;
    std::size_t at_ = 0;
    Phase phase_ = Phase::to_approach;
    std::int64_t since_ms_ = 0;
};

}  // namespace kambara::ui
