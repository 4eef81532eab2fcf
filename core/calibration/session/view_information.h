// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "core/calibration/range_error.h"
#include "core/calibration/rig_views.h"
#include "core/calibration/session/rig_guess.h"

namespace kambara {

/// The parameters of the guess's cameras that a calibration solves for: their places among the 18
/// of each camera (see BundleCovariance).
std::vector<int> open_parameters(const RigGuess& guess);

/// What one view tells of the open parameters, once the target's own pose is solved for: the
/// inverse covariance that it adds, to the first order. `ids`: the corners seen, a camera each;
/// `noise_px`: of each coordinate.
Eigen::MatrixXd view_information(const RigGuess& guess,
                                 const std::vector<Eigen::Vector3d>& target_mm,
                                 const PoseBlock& first_from_target,
                                 const std::vector<std::vector<int>>& ids, double noise_px);

/// What a guess is worth by itself: 20 % of a focal length, a tenth of the picture's width in the
/// centre, any ordinary distortion, 0.2 rad and 200 mm in the cameras' places.
Eigen::MatrixXd guess_information(const RigGuess& guess);

/// What is to become small: for a covariance C of the open parameters, trace(C goal) is the mean
/// square of what C does to measurements in the working volume. With left and right camera: the
/// error of the range over the range, at the places of range_error_map. A camera that is no part of
/// that pair counts with the error of its pixels over its focal length; beside a pair, a tenth of
/// that square, since it only has to aim. Zeros where the cameras see nothing of the volume.
Eigen::MatrixXd volume_goal(const RigGuess& guess, const RangeErrorOptions& options);

}  // namespace kambara
