// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace kambara {

/// A rotation and a translation. Named `T_b_from_a`, it takes a point given in frame a to the same
/// point in frame b: p_b = R p_a + t. Lengths in mm (geometry: p_i = R_i p_w + T_i).
struct RigidTransform {
    Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
    Eigen::Vector3d t_mm = Eigen::Vector3d::Zero();

    Eigen::Vector3d operator*(const Eigen::Vector3d& point_mm) const { return R * point_mm + t_mm; }
    RigidTransform operator*(const RigidTransform& before) const {
        return {R * before.R, R * before.t_mm + t_mm};
    }
    RigidTransform inverse() const { return {R.transpose(), -(R.transpose() * t_mm)}; }

    /// The origin of frame b seen from frame a: for a camera, its optical centre.
    Eigen::Vector3d centre_mm() const { return -(R.transpose() * t_mm); }
};

/// Rotations about the x and y axes with the signs of the geometry's nominal rig:
/// Rx(t) = [1 0 0; 0 c -s; 0 s c], Ry(t) = [c 0 s; 0 1 0; -s 0 c].
Eigen::Matrix3d rotation_about_x(double angle_rad);
Eigen::Matrix3d rotation_about_y(double angle_rad);

/// True where R^T R is the identity within `tolerance` in every entry and det R is positive.
bool is_rotation(const Eigen::Matrix3d& R, double tolerance);

/// The rotation nearest to R (in the Frobenius norm, by singular values).
Eigen::Matrix3d nearest_rotation(const Eigen::Matrix3d& R);

}  // namespace kambara
