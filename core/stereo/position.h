// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "core/base/result.h"
#include "core/camera/rig.h"

namespace kambara {

/// A pixel found in a picture, and how well it is known.
struct PixelMeasurement {
    Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
    Eigen::Matrix2d covariance_px2 = 0.01 * Eigen::Matrix2d::Identity();
};

struct PositionOptions {
    /// Rays closer to parallel than this give no position (0.02 degrees).
    double min_parallax_rad = 3.5e-4;
    /// Largest distance of a measured pixel from the projected position, in either picture.
    double max_residual_px = 2.0;
};

/// A point seen by both cameras.
struct Position {
    Eigen::Vector3d point_in_left_mm = Eigen::Vector3d::Zero();
    /// What the pixels' covariances make of it: the part that averages out over frames. The
    /// calibration's own part, which does not, is kept apart and not in here.
    Eigen::Matrix3d covariance_mm2 = Eigen::Matrix3d::Zero();
    /// The larger of the distances from the measured pixels to the projected position.
    double residual_px = 0.0;
    /// Angle between the two rays.
    double parallax_rad = 0.0;
};

/// The point of least reprojection error in both pictures, each weighted by its covariance
/// (geometry: position, method 3), from the midpoint as the start. Refuses, with the reason: a
/// pixel that no ray reaches, rays nearly parallel, a point behind a camera, a residual beyond the
/// gate. The rig must have a right camera.
Result<Position> position_from_pair(const Rig& rig, const PixelMeasurement& left,
                                    const PixelMeasurement& right,
                                    const PositionOptions& options = {});

}  // namespace kambara
