// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <stop_token>
#include <vector>

namespace kambara {

/// The joint problem: lens parameters (fx fy cx cy k1 k2 p1 p2 k3 k4 k5 k6), poses as an
/// angle-axis rotation and a translation in mm.
struct Bundle {
    using LensParameters = std::array<double, 12>;
    using Pose = std::array<double, 6>;

    std::vector<Eigen::Vector3d> board_mm;
    std::vector<std::vector<Eigen::Vector2d>> left_px;   // a view each
    std::vector<std::vector<Eigen::Vector2d>> right_px;  // likewise; empty for one camera alone
    bool free_k3 = false;

    LensParameters left{};
    LensParameters right{};
    Pose right_from_left{};
    std::vector<Pose> left_from_board;
};

struct BundleResult {
    bool converged = false;
    double left_sum_px2 = 0.0;  ///< of squared residual lengths
    double right_sum_px2 = 0.0;
    Bundle::LensParameters left_sigma{};
    Bundle::LensParameters right_sigma{};
    Eigen::Matrix3d translation_covariance_mm2 = Eigen::Matrix3d::Zero();  ///< of right_from_left
};

/// Adjusts the bundle in place (Levenberg and Marquardt; the views' poses eliminated first) and
/// tells the parameters' deviations, scaled by the residuals' own variance.
BundleResult adjust(Bundle& bundle, std::stop_token stop);

}  // namespace kambara
