// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/vehicle_motion.h"

namespace kambara {

/// A vehicle's state estimator, as far as the vision system wants it. Asked once a pair by the
/// pipeline's thread: it never waits.
class VehicleFeed {
  public:
    virtual ~VehicleFeed() = default;

    /// What has come since the last call, oldest first; `now_ns` on the pictures' clock is the
    /// newest pair's time.
    virtual std::vector<VehicleMotion> take(std::int64_t now_ns) = 0;
};

}  // namespace kambara
