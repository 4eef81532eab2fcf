// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/camera/mount.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace kambara {
namespace {

Eigen::Matrix3d rotation_about_z(double angle_rad) {
    return Eigen::AngleAxisd(angle_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix();
}

}  // namespace

// Down in the rig's frame is (sin roll cos pitch, cos roll cos pitch, sin pitch).
Eigen::Matrix3d R_level_from_rig(const Mount& mount) {
    return rotation_about_x(-mount.pitch_rad) * rotation_about_z(mount.roll_rad);
}

RigidTransform T_vehicle_from_rig(const Mount& mount) {
    Eigen::Matrix3d R_vehicle_from_level;
    R_vehicle_from_level << 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0;
    return {R_vehicle_from_level * rotation_about_y(mount.heading_rad) * R_level_from_rig(mount),
            mount.rig_in_vehicle_mm};
}

Mount mount_of_down(const Eigen::Vector3d& down_in_rig) {
    Mount mount;
    mount.pitch_rad = std::asin(std::clamp(down_in_rig.z(), -1.0, 1.0));
    mount.roll_rad = std::atan2(down_in_rig.x(), down_in_rig.y());
    return mount;
}

}  // namespace kambara
