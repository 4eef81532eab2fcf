// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/calibration/bundle.h"

namespace kambara {

/// How far off the range of one place is told: one standard deviation.
struct RangeErrorPoint {
    Eigen::Vector3d point_in_left_mm;
    double azimuth_deg = 0.0;           ///< to the right of the rig's axis
    double height_mm = 0.0;             ///< downwards
    double depth_mm = 0.0;              ///< along the rig's axis
    double range_mm = 0.0;              ///< from the left camera's centre
    double sigma_calibration_mm = 0.0;  ///< from what the calibration leaves open
    double sigma_total_mm = 0.0;        ///< with the noise of one measurement in the pictures
};

struct RangeErrorOptions {
    double nearest_mm = 1000.0;
    double farthest_mm = 2000.0;
    double height_mm = 200.0;   ///< above and below the axis
    double azimuth_deg = 26.0;  ///< to both sides
    double noise_px = 0.1;      ///< of each coordinate
};

/// Over five directions, three heights and five depths: what the covariance of the left and right
/// camera's parameters (the first and second of the bundle) does to the position of least
/// reprojection error, to the first order. `T_left_from_rig` tells the axes. Places that a camera
/// can't see are left out.
std::vector<RangeErrorPoint> range_error_map(const Bundle& bundle,
                                             const Eigen::MatrixXd& covariance,
                                             const RigidTransform& T_left_from_rig,
                                             const Eigen::Vector2i& size_px,
                                             const RangeErrorOptions& options);

}  // namespace kambara
