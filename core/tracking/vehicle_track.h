// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <deque>
#include <optional>

#include "core/base/vehicle_motion.h"
#include "core/geometry/rigid_transform.h"

namespace kambara {

/// What a vehicle's motion makes of a point that stands still, between two times.
struct RigChange {
    RigidTransform T_now_from_then;  ///< in the rig's frame
    double turn_sigma_rad = 0.0;     ///< of its rotation
    double way_sigma_mm = 0.0;       ///< of its translation
};

/// The last seconds of a vehicle's motion, from samples that come late and are noisy. Between
/// samples it is interpolated; after the last one it is carried on, with the change of turn rate of
/// the last hundredths of a second, for a quarter of a second at most. Used by one thread at a
/// time.
class VehicleTrack {
  public:
    static constexpr double stale_after_s = 0.25;

    /// A sample older than the newest one is passed over. False where it, or a deviation, is no
    /// number: nothing is taken.
    bool add(const VehicleMotion& motion);
    void clear() { samples_.clear(); }
    /// Empty where no samples cover that time: before the first, or long after the last.
    std::optional<RigChange> between(std::int64_t then_ns, std::int64_t now_ns) const;

  private:
    VehicleMotion at(std::int64_t time_ns) const;

    std::deque<VehicleMotion> samples_;
};

}  // namespace kambara
