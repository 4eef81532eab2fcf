// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pointing/pan_tilt_view.h"

#include <Eigen/Geometry>
#include <cmath>

#include "core/camera/zoom.h"
#include "core/pointing/aim.h"

namespace kambara {
namespace {

// Where the optical axis meets the picture.
Eigen::Vector2d middle_px(const Camera& camera) {
    return project(camera.lens, Eigen::Vector3d::UnitZ()).value();
}

}  // namespace

Camera pan_tilt_camera_at(const Rig& rig, const HeadAngles& angles) {
    Camera camera = rig.pan_tilt.value();
    if (rig.head) {
        camera.T_camera_from_rig = T_camera_from_rig(*rig.head, angles);
        return camera;
    }
    const Eigen::Matrix3d R_home_from_turned =
        (Eigen::AngleAxisd(angles.pan_rad, Eigen::Vector3d::UnitY()) *
         Eigen::AngleAxisd(angles.tilt_rad, Eigen::Vector3d::UnitX()))
            .toRotationMatrix();
    camera.T_camera_from_rig =
        RigidTransform{R_home_from_turned.transpose(), Eigen::Vector3d::Zero()} *
        camera.T_camera_from_rig;
    return camera;
}

Eigen::Vector2d pixel_at_calibrated_zoom(const Camera& camera, const Eigen::Vector2d& pixel,
                                         double magnified) {
    const Eigen::Vector2d middle = middle_px(camera);
    return middle + (pixel - middle) / magnified;
}

std::optional<HeadAngles> angles_to_centre(const Rig& rig, const HeadAngles& angles,
                                           const Eigen::Vector2d& pixel, double range_mm,
                                           double magnified) {
    Camera camera = pan_tilt_camera_at(rig, angles);
    camera.lens = zoomed(camera.lens, magnified);
    const auto ray = camera.unproject(pixel);
    if (!ray) {
        return std::nullopt;
    }
    return angles_towards(rig, rig.left.T_camera_from_rig * ray->at(range_mm));
}

}  // namespace kambara
