// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <optional>

#include "core/base/angles.h"
#include "core/camera/rig.h"

namespace kambara {

/// The head's angles that put a point, given in the left camera's frame, on its optical axis:
/// p_1 = R_1 R_0^T (p_0 - T_0) + T_1, pan = atan2(x_1, z_1), tilt = atan2(-y_1, sqrt(x_1^2 +
/// z_1^2)) (geometry: pan-tilt mapping; 1999's equation 37, mended). The camera's centre is taken
/// to stay where it is at home, unless the rig has a head model: then its axes and lever arms are
/// taken into account, and the angles are found by iteration. The rig must have a pan-tilt camera.
HeadAngles angles_towards(const Rig& rig, const Eigen::Vector3d& point_in_left_mm);

/// The optical axis at the angles, a unit vector in the frame of the pan-tilt camera at home.
Eigen::Vector3d axis_at_home_frame(const HeadAngles& angles);

/// As above in the left camera's frame: the inverse of angles_towards.
Eigen::Vector3d axis_in_left_frame(const Rig& rig, const HeadAngles& angles);

/// The angle between the optical axis at `angles` and the direction to the point.
double aiming_error_rad(const Rig& rig, const HeadAngles& angles,
                        const Eigen::Vector3d& point_in_left_mm);

/// Where something that moves is expected at a time, in the left camera's frame; empty where that
/// is not known.
using ExpectedPlace = std::function<std::optional<Eigen::Vector3d>(std::int64_t time_ns)>;

/// The aim at it for a picture's time `pictured_ns`, which is `now_ns` on the system's clock, led
/// by `lead_s`. Computed now. Empty where the place is not known.
std::optional<HeadAim> led_aim(const Rig& rig, const ExpectedPlace& expected,
                               std::int64_t pictured_ns, std::int64_t now_ns, double lead_s);

/// The nearest angles that the head can reach; the same angles where it reaches them, so that a
/// comparison tells whether they were beyond the limits.
HeadAngles within_limits(const HeadAngles& angles, const HeadLimits& limits);

}  // namespace kambara
