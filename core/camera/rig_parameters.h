// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "core/camera/rig.h"

namespace kambara {

/// The numbers that a calibration finds of a rig's left and right camera, in the order of
/// Rig::parameter_covariance: the left lens's, the right lens's, then the right camera's pose
/// p_right = exp(turn) R p_left + t + shift, of which turn (rad) and shift (mm) are zero and only
/// uncertain. Names with units; none without a right camera.
std::vector<std::string> rig_parameter_names(const Rig& rig);

/// Names of a lens's own: f_mm kappa1_per_mm2 cx_px cy_px sx, or fx_px fy_px cx_px cy_px and the
/// distortion terms.
std::vector<std::string> lens_parameter_names(const Lens& lens);

/// How the left and right pixel of a point (left x, left y, right x, right y) change with each of
/// the parameters: 4 x n, px per unit of the parameter. Empty where a camera can't see the point or
/// there is no right one.
std::optional<Eigen::Matrix<double, 4, Eigen::Dynamic>> pixels_by_parameters(
    const Rig& rig, const Eigen::Vector3d& point_in_left_mm);

/// How the pixel of a point changes with each of a lens's numbers: 2 x n. The point must be within
/// the lens's range.
Eigen::Matrix2Xd pixel_by_lens_parameters(const Lens& lens,
                                          const Eigen::Vector3d& point_in_camera_mm);

/// The lens whose numbers are more by so much.
Lens with_lens_moved(const Lens& lens, const Eigen::VectorXd& by);

/// The rig whose parameters are more by so much, in the order of the names above. The rig's frame
/// stays where the left camera holds it, so it is that of rig.h only to the first order:
/// rig_from_pair() lays it anew. Needs a right camera.
Rig with_parameters_moved(const Rig& rig, const Eigen::VectorXd& by);

/// Why a matrix can't be the parameters' covariance; empty when it can be. Zeros are allowed, for
/// what was held fixed.
std::string covariance_fault(const Rig& rig, const Eigen::MatrixXd& covariance);
/// Of so many parameters.
std::string covariance_fault(Eigen::Index parameters, const Eigen::MatrixXd& covariance);

}  // namespace kambara
