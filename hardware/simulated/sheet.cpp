// SPDX-License-Identifier: GPL-3.0-or-later
#include "hardware/simulated/sheet.h"

#include <Eigen/Geometry>

namespace kambara {

Sheet::Sheet(const TargetPatch& in_camera)
    : origin_(in_camera.origin_mm.cast<float>()),
      across_(in_camera.across_mm.normalized().cast<float>()),
      down_(in_camera.down_mm.normalized().cast<float>()),
      normal_(in_camera.across_mm.cross(in_camera.down_mm).normalized().cast<float>()),
      offset_(normal_.dot(origin_)),
      width_mm_(static_cast<float>(in_camera.across_mm.norm())),
      height_mm_(static_cast<float>(in_camera.down_mm.norm())) {}

bool Sheet::hides(const Eigen::Vector3d& point_in_camera_mm) const {
    const Eigen::Vector2d slope = point_in_camera_mm.head<2>() / point_in_camera_mm.z();
    const Meeting meeting = meet(slope.cast<float>());
    return meeting.depth_mm > 0.0F &&
           static_cast<double>(meeting.depth_mm) < point_in_camera_mm.z() &&
           covers(meeting.u_mm, meeting.v_mm);
}

}  // namespace kambara
