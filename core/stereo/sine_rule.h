// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "core/base/result.h"
#include "core/geometry/rigid_transform.h"
#include "core/stereo/position.h"

namespace kambara {

/// A point on one camera's sensor as 1999's method takes it: p_camera = R p_world + T, and the
/// undistorted point (x_u, y_u, f) in front of the optical centre, in any unit of length (mm for a
/// Tsai lens).
struct SensorPoint {
    RigidTransform T_camera_from_world;
    Eigen::Vector3d on_sensor = Eigen::Vector3d::UnitZ();
};

/// Where the two lines of sight place the target, in the left camera's frame, mm. The two agree
/// only where the lines meet.
struct SineRulePosition {
    Eigen::Vector3d along_left_mm = Eigen::Vector3d::Zero();
    Eigen::Vector3d along_right_mm = Eigen::Vector3d::Zero();

    Eigen::Vector3d mean_mm() const { return 0.5 * (along_left_mm + along_right_mm); }
};

/// 1999's position, its misprints mended (geometry: equations 38-48). H and F are the two sensor
/// points in the world's frame, P the target: the sine rule in the triangle H-F-P gives a = HP and
/// b = FP, and front projection puts the target at DP = a + |DH| on the left line of sight and at
/// BP = b + |BF| on the right one. Kept as a reference. Refuses lines closer to parallel than
/// `min_parallax_rad`, and lines that run apart.
Result<SineRulePosition> sine_rule(const SensorPoint& left, const SensorPoint& right,
                                   double min_parallax_rad = PositionOptions{}.min_parallax_rad);

/// As above for a pair of pixels, with the rig's frame as the world. A lens without a focal length
/// in mm is given one of 1 mm, which changes nothing in the result.
Result<SineRulePosition> sine_rule_from_pair(const Rig& rig, const Eigen::Vector2d& left_pixel,
                                             const Eigen::Vector2d& right_pixel,
                                             const PositionOptions& options = {});

}  // namespace kambara
