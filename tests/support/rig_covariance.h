// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <random>

#include "core/camera/rig_parameters.h"

namespace kambara::testing_support {

/// A correlated covariance with deviations such as calibrations leave.
inline Eigen::MatrixXd some_covariance(const Rig& rig) {
    const auto names = rig_parameter_names(rig);
    const auto n = static_cast<Eigen::Index>(names.size());
    Eigen::VectorXd sigma(n);
    for (Eigen::Index i = 0; i < n; ++i) {
        const std::string& name = names[static_cast<std::size_t>(i)];
        sigma[i] = name.ends_with("_px")    ? 0.2
                   : name.ends_with("_rad") ? 2e-4
                   : name.ends_with("shift_x_mm") || name.ends_with("shift_y_mm") ||
                           name.ends_with("shift_z_mm")
                       ? 0.2
                       : 3e-4;
    }
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    const Eigen::MatrixXd mix =
        Eigen::MatrixXd::NullaryExpr(n, 2 * n, [&] { return normal(random); });
    Eigen::MatrixXd correlation = mix * mix.transpose();
    const Eigen::VectorXd scale = correlation.diagonal().cwiseSqrt().cwiseInverse();
    correlation = scale.asDiagonal() * correlation * scale.asDiagonal();
    return sigma.asDiagonal() * correlation * sigma.asDiagonal();
}

}  // namespace kambara::testing_support
