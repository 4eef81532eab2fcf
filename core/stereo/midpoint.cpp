// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/stereo/midpoint.h"

#include "core/stereo/ray_pair.h"

namespace kambara {

Result<Eigen::Vector3d> midpoint_from_pair(const Rig& rig, const Eigen::Vector2d& left_pixel,
                                           const Eigen::Vector2d& right_pixel,
                                           const PositionOptions& options) {
    const auto rays = ray_pair(rig, left_pixel, right_pixel, options.min_parallax_rad);
    if (!rays) {
        return rays.error();
    }
    return Eigen::Vector3d(rig.left.T_camera_from_rig * rays->meeting.midpoint_mm);
}

}  // namespace kambara
