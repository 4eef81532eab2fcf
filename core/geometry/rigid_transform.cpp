// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/rigid_transform.h"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <cmath>

namespace kambara {

Eigen::Matrix3d rotation_about_x(double angle_rad) {
    const double c = std::cos(angle_rad);
    const double s = std::sin(angle_rad);
    Eigen::Matrix3d R;
    R << 1, 0, 0, 0, c, -s, 0, s, c;
    return R;
}

Eigen::Matrix3d rotation_about_y(double angle_rad) {
    const double c = std::cos(angle_rad);
    const double s = std::sin(angle_rad);
    Eigen::Matrix3d R;
    R << c, 0, s, 0, 1, 0, -s, 0, c;
    return R;
}

bool is_rotation(const Eigen::Matrix3d& R, double tolerance) {
    if (!R.allFinite()) {
        return false;
    }
    const Eigen::Matrix3d rest = R.transpose() * R - Eigen::Matrix3d::Identity();
    return rest.cwiseAbs().maxCoeff() <= tolerance && R.determinant() > 0.0;
}

Eigen::Matrix3d nearest_rotation(const Eigen::Matrix3d& R) {
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(R, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Eigen::Matrix3d D = Eigen::Matrix3d::Identity();
    D(2, 2) = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0.0 ? -1.0 : 1.0;
    return svd.matrixU() * D * svd.matrixV().transpose();
}

}  // namespace kambara
