// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "core/base/angles.h"
#include "core/base/result.h"

namespace kambara {

/// Where a head is and what it is doing.
struct HeadStatus {
    HeadAngles angles;  ///< where it looks now, not where it was told to look
    bool moving = false;
    std::int64_t time_ns = 0;  ///< when that was so, on the head's clock
    bool operator==(const HeadStatus&) const = default;
};

/// A camera on a pan-tilt head. Calls may wait for the device, so they are made from a thread that
/// may wait, never from the pipeline's; they may come from any thread, one at a time or not.
class PanTiltCamera {
  public:
    virtual ~PanTiltCamera() = default;

    virtual std::string name() const = 0;
    virtual HeadLimits limits() const = 0;

    /// Starts towards the angles at full speed and returns at once; a newer call replaces an older.
    /// Refuses angles that are not finite or beyond the limits, and then keeps to what it was
    /// doing.
    virtual Result<Done> move_to(const HeadAngles& angles) = 0;

    /// Stops where it is.
    virtual Result<Done> halt() = 0;

    virtual Result<HeadStatus> status() = 0;
};

}  // namespace kambara
