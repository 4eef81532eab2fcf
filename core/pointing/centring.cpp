// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pointing/centring.h"

#include "core/camera/zoom.h"
#include "core/pointing/aim.h"

namespace kambara {

std::optional<HeadAngles> centring_angles(const Rig& rig, const Eigen::Vector2d& pixel,
                                          const HeadAngles& seen_from, double magnification,
                                          double range_mm) {
    if (!rig.pan_tilt) {
        return std::nullopt;
    }
    const auto ray = unproject(zoomed(rig.pan_tilt->lens, magnification), pixel);
    if (!ray) {
        return std::nullopt;
    }
    const RigidTransform T_seeing_from_home{
        (rotation_about_y(seen_from.pan_rad) * rotation_about_x(seen_from.tilt_rad)).transpose(),
        Eigen::Vector3d::Zero()};
    const RigidTransform T_seeing_from_rig =
        rig.head ? T_camera_from_rig(*rig.head, seen_from)
                 : T_seeing_from_home * rig.pan_tilt->T_camera_from_rig;
    const Eigen::Vector3d place_in_rig_mm =
        T_seeing_from_rig.inverse() * (ray->direction.normalized() * range_mm);
    return angles_towards(rig, rig.left.T_camera_from_rig * place_in_rig_mm);
}

}  // namespace kambara
