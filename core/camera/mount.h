// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>

#include "core/geometry/rigid_transform.h"

namespace kambara {

/// How the rig sits on the vehicle. Three frames follow (geometry: frames, levelling):
/// rig: see rig.h. level: the rig's origin, x to the right, y straight down, z forward, level.
/// vehicle: x forward, y to the right, z down, as vehicles have it, its origin where the lever arm
/// is measured from.
struct Mount {
    double pitch_rad = 0.0;    ///< the rig's z axis looks down by so much
    double roll_rad = 0.0;     ///< its right side hangs down by so much, turned about its z axis
    double heading_rad = 0.0;  ///< it looks to the right of the vehicle's bow by so much
    Eigen::Vector3d rig_in_vehicle_mm = Eigen::Vector3d::Zero();  ///< the rig's origin
    std::optional<double> pitch_sigma_rad;  ///< one deviation, where it was measured
    std::optional<double> roll_sigma_rad;
    bool operator==(const Mount&) const = default;
};

Eigen::Matrix3d R_level_from_rig(const Mount& mount);
RigidTransform T_vehicle_from_rig(const Mount& mount);

/// Pitch and roll of a rig in whose frame `down` (a unit vector) points straight down.
Mount mount_of_down(const Eigen::Vector3d& down_in_rig);

}  // namespace kambara
