// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>

#include "core/stereo/position.h"

namespace kambara {

/// How far a pair's right pixel lies beside the left one's epipolar curve, measured square to it
/// where the left ray passes at `range_mm` from its camera. `of_calibration_px2`: what the
/// calibration leaves open of the two pixels. Zeros where the right camera can't see that place.
/// The rig must have a right camera.
EpipolarOffset epipolar_offset(const Rig& rig, const PairMeasurement& pair, double range_mm,
                               const std::optional<Eigen::Matrix4d>& of_calibration_px2);

/// How the right pixel goes with the left one for a point that keeps its distance from the left
/// camera. Empty where a camera can't see it.
std::optional<Eigen::Matrix2d> right_by_left(const Rig& rig, const Eigen::Vector2d& left_px,
                                             double range_mm);

}  // namespace kambara
