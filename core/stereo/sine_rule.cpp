// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/stereo/sine_rule.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <variant>

#include "core/stereo/ray_pair.h"

namespace kambara {
namespace {

double angle_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

SensorPoint sensor_point(const Camera& camera, const Ray& ray_in_rig) {
    const Eigen::Vector3d direction = camera.T_camera_from_rig.R * ray_in_rig.direction;
    const auto* tsai = std::get_if<TsaiLens>(&camera.lens);
    const double f_mm = tsai ? tsai->f_mm : 1.0;
    return {camera.T_camera_from_rig, direction * (f_mm / direction.z())};
}

}  // namespace

Result<SineRulePosition> sine_rule(const SensorPoint& left, const SensorPoint& right,
                                   double min_parallax_rad) {
    const RigidTransform& T_0 = left.T_camera_from_world;
    const RigidTransform& T_2 = right.T_camera_from_world;
    const Eigen::Vector3d AD = T_0.centre_mm();
    const Eigen::Vector3d AB = T_2.centre_mm();
    const Eigen::Vector3d DH = T_0.R.transpose() * left.on_sensor;
    const Eigen::Vector3d BF = T_2.R.transpose() * right.on_sensor;
    const Eigen::Vector3d HF = (AB + BF) - (AD + DH);

    const double angle_at_H = angle_between(DH, HF);
    const double angle_at_F = angle_between(BF, -HF);
    const double angle_at_P = std::numbers::pi - angle_at_H - angle_at_F;
    if (!(angle_at_P > 0.0 && angle_at_P >= min_parallax_rad)) {
        return Error{
            "The two lines of sight are parallel or run apart: they meet nowhere in front "
            "of the cameras.",
            "Bring the target nearer, and check that left and right are not swapped."};
    }
    const double side_per_sine = HF.norm() / std::sin(angle_at_P);
    const double DP = side_per_sine * std::sin(angle_at_F) + DH.norm();
    const double BP = side_per_sine * std::sin(angle_at_H) + BF.norm();
    SineRulePosition position;
    position.along_left_mm = DP * left.on_sensor.normalized();
    position.along_right_mm = T_0 * (T_2.inverse() * (BP * right.on_sensor.normalized()));
    return position;
}

Result<SineRulePosition> sine_rule_from_pair(const Rig& rig, const Eigen::Vector2d& left_pixel,
                                             const Eigen::Vector2d& right_pixel,
                                             const PositionOptions& options) {
    const auto rays = ray_pair(rig, left_pixel, right_pixel, options.min_parallax_rad);
    if (!rays) {
        return rays.error();
    }
    return sine_rule(sensor_point(rig.left, rays->left), sensor_point(*rig.right, rays->right),
                     options.min_parallax_rad);
}

}  // namespace kambara
