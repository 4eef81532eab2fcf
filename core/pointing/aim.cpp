// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pointing/aim.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace kambara {
namespace {

// The head's frame is that of the pan-tilt camera at home.
RigidTransform T_head_from_left(const Rig& rig) {
    return rig.pan_tilt.value().T_camera_from_rig * rig.left.T_camera_from_rig.inverse();
}

// Turned by what the point is off the axis, until it is on it: the arms are short against the
// distance, so each round takes most of it off.
HeadAngles angles_by_model(const HeadModel& model, const Eigen::Vector3d& point_in_rig_mm) {
    const Eigen::Vector3d start = model.T_base_from_rig * point_in_rig_mm;
    HeadAngles angles{std::atan2(start.x(), start.z()),
                      std::atan2(-start.y(), std::hypot(start.x(), start.z()))};
    for (int round = 0; round < 50; ++round) {
        const Eigen::Vector3d seen = T_camera_from_rig(model, angles) * point_in_rig_mm;
        const double pan =
            std::atan2(seen.x(), seen.z()) / std::max(0.3, std::cos(angles.tilt_rad));
        const double tilt = std::atan2(-seen.y(), std::hypot(seen.x(), seen.z()));
        angles = {angles.pan_rad + pan, angles.tilt_rad + tilt};
        if (std::abs(pan) + std::abs(tilt) < 1e-12) {
            break;
        }
    }
    return angles;
}

}  // namespace

HeadAngles angles_towards(const Rig& rig, const Eigen::Vector3d& point_in_left_mm) {
    if (rig.head) {
        return angles_by_model(*rig.head, rig.left.T_camera_from_rig.inverse() * point_in_left_mm);
    }
    const Eigen::Vector3d p = T_head_from_left(rig) * point_in_left_mm;
    return {std::atan2(p.x(), p.z()), std::atan2(-p.y(), std::hypot(p.x(), p.z()))};
}

Eigen::Vector3d axis_at_home_frame(const HeadAngles& angles) {
    const double level = std::cos(angles.tilt_rad);
    return {level * std::sin(angles.pan_rad), -std::sin(angles.tilt_rad),
            level * std::cos(angles.pan_rad)};
}

Eigen::Vector3d axis_in_left_frame(const Rig& rig, const HeadAngles& angles) {
    if (rig.head) {
        return rig.left.T_camera_from_rig.R *
               T_camera_from_rig(*rig.head, angles).R.row(2).transpose();
    }
    return T_head_from_left(rig).R.transpose() * axis_at_home_frame(angles);
}

double aiming_error_rad(const Rig& rig, const HeadAngles& angles,
                        const Eigen::Vector3d& point_in_left_mm) {
    if (rig.head) {
        const Eigen::Vector3d seen = T_camera_from_rig(*rig.head, angles) *
                                     (rig.left.T_camera_from_rig.inverse() * point_in_left_mm);
        return std::atan2(seen.head<2>().norm(), seen.z());
    }
    const Eigen::Vector3d axis = axis_at_home_frame(angles);
    const Eigen::Vector3d wanted = T_head_from_left(rig) * point_in_left_mm;
    return std::atan2(axis.cross(wanted).norm(), axis.dot(wanted));
}

std::optional<HeadAim> led_aim(const Rig& rig, const ExpectedPlace& expected,
                               std::int64_t pictured_ns, std::int64_t now_ns, double lead_s) {
    constexpr std::int64_t apart_ns = 20'000'000;
    constexpr double apart_s = 1e-9 * static_cast<double>(apart_ns);
    const auto lead_ns = static_cast<std::int64_t>(std::llround(lead_s * 1e9));
    const auto place = expected(pictured_ns + lead_ns);
    const auto later = expected(pictured_ns + lead_ns + apart_ns);
    if (!place || !later) {
        return std::nullopt;
    }
    HeadAim aim;
    aim.angles = angles_towards(rig, *place);
    const HeadAngles then = angles_towards(rig, *later);
    aim.rate_rad_s = {(then.pan_rad - aim.angles.pan_rad) / apart_s,
                      (then.tilt_rad - aim.angles.tilt_rad) / apart_s};
    aim.time_ns = now_ns + lead_ns;
    aim.computed_ns = now_ns;
    return aim;
}

HeadAngles within_limits(const HeadAngles& angles, const HeadLimits& limits) {
    return {std::clamp(angles.pan_rad, -limits.pan_rad, limits.pan_rad),
            std::clamp(angles.tilt_rad, -limits.tilt_rad, limits.tilt_rad)};
}

}  // namespace kambara
