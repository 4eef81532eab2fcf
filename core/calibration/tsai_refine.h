// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "core/calibration/seen_point.h"

namespace kambara {

/// Tsai's eleven parameters in a fixed order. The rotation's three are a small turn after the
/// rotation found, about the camera's x, y and z, in rad: R' = exp(turn) R.
namespace tsai {
enum Parameter { turn_x, turn_y, turn_z, t_x, t_y, t_z, f, kappa1, c_x, c_y, s_x };
}
inline constexpr int tsai_parameters = 11;
using TsaiMatrix = Eigen::Matrix<double, tsai_parameters, tsai_parameters>;
using TsaiVector = Eigen::Matrix<double, tsai_parameters, 1>;
using TsaiMask = std::array<bool, tsai_parameters>;

/// What each refinement after the linear stage moves (calibration: Tsai's method, step 4).
inline constexpr TsaiMask tsai_focal{false, false, false, false, false, true, true, true};
inline constexpr TsaiMask tsai_all_but_centre{true, true, true,  true,  true, true,
                                              true, true, false, false, true};
inline constexpr TsaiMask tsai_all{true, true, true, true, true, true,
                                   true, true, true, true, true};

/// Without s_x, which points on one plane can't tell.
TsaiMask without_s_x(TsaiMask free);

/// The view of least squared error in distorted pixels, two residuals a point, over the free
/// parameters (Levenberg and Marquardt, single thread: the same input gives the same output).
/// Empty where the start projects a point nowhere or the search fails.
std::optional<TsaiView> refined(const TsaiView& start, const std::vector<SeenPoint>& points,
                                const TsaiMask& free);

/// The derivatives of the projected pixels by the parameters, two rows a point, x first; empty
/// where a point projects nowhere.
std::optional<Eigen::Matrix<double, Eigen::Dynamic, tsai_parameters>> tsai_jacobian(
    const TsaiView& view, const std::vector<SeenPoint>& points);

/// The inverse of J^T J over the free parameters, zero elsewhere: their covariance for one px of
/// noise in each coordinate. Empty where the points leave a parameter undetermined.
std::optional<TsaiMatrix> unit_covariance(
    const Eigen::Matrix<double, Eigen::Dynamic, tsai_parameters>& jacobian, const TsaiMask& free);

}  // namespace kambara
