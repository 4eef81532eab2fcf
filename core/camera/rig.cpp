// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/camera/rig.h"

#include <Eigen/Geometry>

#include "core/camera/rig_parameters.h"

namespace kambara {

std::optional<Eigen::Vector2d> Camera::project(const Eigen::Vector3d& point_in_rig_mm) const {
    return kambara::project(lens, T_camera_from_rig * point_in_rig_mm);
}

std::optional<Eigen::Vector2d> Camera::project(const Eigen::Vector3d& point_in_rig_mm,
                                               Eigen::Matrix<double, 2, 3>& pixel_by_point) const {
    auto pixel = kambara::project(lens, T_camera_from_rig * point_in_rig_mm, pixel_by_point);
    if (pixel) {
        pixel_by_point = (pixel_by_point * T_camera_from_rig.R).eval();
    }
    return pixel;
}

std::optional<Ray> Camera::unproject(const Eigen::Vector2d& pixel) const {
    const auto ray = kambara::unproject(lens, pixel);
    return ray ? std::optional(T_camera_from_rig.inverse() * *ray) : std::nullopt;
}

bool Camera::sees(const Eigen::Vector2d& pixel) const {
    return pixel.x() >= 0.0 && pixel.y() >= 0.0 && pixel.x() <= width_px - 1.0 &&
           pixel.y() <= height_px - 1.0;
}

namespace {

// What is told in px grows with the pictures; all else stays.
Eigen::MatrixXd scaled_covariance(const Rig& rig, int width_px, int height_px) {
    const auto names = rig_parameter_names(rig);
    Eigen::VectorXd factors = Eigen::VectorXd::Ones(static_cast<Eigen::Index>(names.size()));
    for (std::size_t i = 0; i < names.size(); ++i) {
        const Camera& camera = names[i].starts_with("left.") ? rig.left : *rig.right;
        if (names[i].ends_with("x_px")) {
            factors[static_cast<Eigen::Index>(i)] = static_cast<double>(width_px) / camera.width_px;
        } else if (names[i].ends_with("y_px")) {
            factors[static_cast<Eigen::Index>(i)] =
                static_cast<double>(height_px) / camera.height_px;
        }
    }
    return factors.asDiagonal() * *rig.parameter_covariance * factors.asDiagonal();
}

}  // namespace

Rig rig_from_pair(const Camera& left, const Camera& right,
                  const RigidTransform& T_right_from_left) {
    // Axes of the rig, seen from the left camera.
    const Eigen::Vector3d x = T_right_from_left.centre_mm().normalized();
    const Eigen::Vector3d mean_axis =
        Eigen::Vector3d::UnitZ() + T_right_from_left.R.transpose() * Eigen::Vector3d::UnitZ();
    const Eigen::Vector3d z = (mean_axis - mean_axis.dot(x) * x).normalized();
    const Eigen::Vector3d y = z.cross(x);
    RigidTransform T_left_from_rig;
    T_left_from_rig.R << x, y, z;

    Rig rig;
    rig.left = left;
    rig.left.T_camera_from_rig = T_left_from_rig;
    rig.right = right;
    rig.right->T_camera_from_rig = T_right_from_left * T_left_from_rig;
    return rig;
}

RigidTransform T_right_from_left(const Rig& rig) {
    return rig.right->T_camera_from_rig * rig.left.T_camera_from_rig.inverse();
}

double baseline_mm(const Rig& rig) {
    return (rig.left.T_camera_from_rig.centre_mm() - rig.right->T_camera_from_rig.centre_mm())
        .norm();
}

Rig scaled_to(const Rig& rig, int width_px, int height_px) {
    Rig result = rig;
    if (result.parameter_covariance) {
        *result.parameter_covariance = scaled_covariance(rig, width_px, height_px);
    }
    const auto resize = [&](Camera& camera) {
        camera.lens = scaled(camera.lens, static_cast<double>(width_px) / camera.width_px,
                             static_cast<double>(height_px) / camera.height_px);
        camera.width_px = width_px;
        camera.height_px = height_px;
    };
    resize(result.left);
    if (result.right) {
        resize(*result.right);
    }
    return result;
}

}  // namespace kambara
