// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace kambara {

/// How the vehicle moved at one time, as its state estimator tells it (SYS-4, COR-8). In the rig's
/// axes, x right, y down, z forward: whoever brings it from a vehicle's own axes turns it first. A
/// plain value; it may come late, as long as the time stamp is right.
struct VehicleMotion {
    std::int64_t time_ns = 0;  ///< when that was so, on the pictures' clock
    /// Of the rig's origin through the water or over ground.
    Eigen::Vector3d velocity_mm_s = Eigen::Vector3d::Zero();
    Eigen::Vector3d turn_rad_s = Eigen::Vector3d::Zero();  ///< right-handed about the rig's axes
    double velocity_sigma_mm_s = 20.0;                     ///< of each component
    double turn_sigma_rad_s = 0.01;                        ///< likewise
    bool operator==(const VehicleMotion&) const = default;
};

}  // namespace kambara
