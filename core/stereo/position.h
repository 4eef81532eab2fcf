// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>

#include "core/base/result.h"
#include "core/camera/rig.h"
#include "core/stereo/position_method.h"

namespace kambara {

/// A pixel found in a picture, and how well it is known.
struct PixelMeasurement {
    Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
    Eigen::Matrix2d covariance_px2 = 0.01 * Eigen::Matrix2d::Identity();
};

/// The pixels of one point in both pictures. Where one was found by means of the other, they err
/// together.
struct PairMeasurement {
    Eigen::Vector2d left_px = Eigen::Vector2d::Zero();
    Eigen::Vector2d right_px = Eigen::Vector2d::Zero();
    /// Of left x, left y, right x, right y.
    Eigen::Matrix4d covariance_px2 = 0.01 * Eigen::Matrix4d::Identity();
};

struct PositionOptions {
    /// Rays closer to parallel than this give no position (0.02 degrees).
    double min_parallax_rad = 3.5e-4;
    /// Largest distance of a measured pixel from the projected position, in either picture.
    double max_residual_px = 2.0;
    PositionMethod method = PositionMethod::reprojection;
};

/// How far the right pixel lies beside the epipolar curve of the left one, positive below it (or to
/// its right, where the curve runs downwards): what a point seen by a rig as calibrated leaves is
/// noise alone.
struct EpipolarOffset {
    double offset_px = 0.0;
    double noise_sigma_px = 0.0;                 ///< by the pixels' covariance
    std::optional<double> calibration_sigma_px;  ///< by the rig's; empty where that is not known
};

/// A point seen by both cameras.
struct Position {
    Eigen::Vector3d point_in_left_mm = Eigen::Vector3d::Zero();
    /// What the pixels' covariances make of it: the part that averages out over frames.
    Eigen::Matrix3d covariance_mm2 = Eigen::Matrix3d::Zero();
    /// What the calibration's covariance makes of it (Rig::parameter_covariance), which does not
    /// average out; empty where the rig does not tell.
    std::optional<Eigen::Matrix3d> calibration_covariance_mm2;
    /// The larger of the distances from the measured pixels to the projected position.
    double residual_px = 0.0;
    /// Angle between the two rays.
    double parallax_rad = 0.0;
    EpipolarOffset epipolar;
    PositionMethod method = PositionMethod::reprojection;
};

/// The point that the method of the options gives; by itself the one of least reprojection error in
/// both pictures, weighted by their covariance (geometry: position, method 3), from the midpoint as
/// the start. Both covariances follow to the first order: the noise's from the method's derivative
/// by the pixels, the calibration's from that and the pixels' derivative by the rig's parameters.
/// Refuses, with the reason: a pixel that no ray reaches, rays nearly parallel, a point behind a
/// camera, a residual beyond the gate, a method that does not suit the rig. The rig must have a
/// right camera.
Result<Position> position_from_pair(const Rig& rig, const PairMeasurement& pair,
                                    const PositionOptions& options = {});

/// As above, for pixels that were found without each other.
Result<Position> position_from_pair(const Rig& rig, const PixelMeasurement& left,
                                    const PixelMeasurement& right,
                                    const PositionOptions& options = {});

}  // namespace kambara
