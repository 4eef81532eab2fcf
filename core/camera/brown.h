// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

namespace kambara {

/// The radius of the undistorted direction up to which r -> r * radial(r) grows (the denominator
/// staying positive): at most 12, which is 85 degrees off the axis.
double brown_max_radius(const std::array<double, 12>& parameters);

/// The undistorted direction (x, y) that the distorted one comes from, within `max_radius`; empty
/// where there is none. Newton's method on both coordinates; a few steps for ordinary lenses.
std::optional<Eigen::Vector2d> brown_undistort(const std::array<double, 12>& parameters,
                                               double max_radius, const Eigen::Vector2d& distorted);

/// The derivative of the distorted direction by the undistorted one.
Eigen::Matrix2d brown_jacobian(const std::array<double, 12>& parameters, const Eigen::Vector2d& at);

}  // namespace kambara
