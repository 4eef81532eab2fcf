// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>

#include "core/base/result.h"
#include "core/stereo/position.h"

namespace kambara {

/// How the left and right pixel (left x, left y, right x, right y) of a point of the rig's frame
/// depart from the measured ones, and change with the point.
struct PairResidual {
    Eigen::Vector4d rest = Eigen::Vector4d::Zero();  ///< measured minus projected, px
    Eigen::Matrix<double, 4, 3> pixels_by_point = Eigen::Matrix<double, 4, 3>::Zero();

    double largest_px() const;  ///< the larger of both pictures' distances
};

/// Empty where a camera can't see the point. The rig must have a right camera.
std::optional<PairResidual> pair_residual(const Rig& rig, const PairMeasurement& pair,
                                          const Eigen::Vector3d& point_in_rig_mm);

/// The point, in the rig's frame, whose projections lie nearest to the measured pixels, weighted by
/// the inverse of their covariance: Gauss-Newton steps, damped, from `start_in_rig_mm`. Refuses a
/// start outside a camera's field and pixels that do not determine a point.
Result<Eigen::Vector3d> least_reprojection(const Rig& rig, const PairMeasurement& pair,
                                           const Eigen::Vector3d& start_in_rig_mm);

}  // namespace kambara
