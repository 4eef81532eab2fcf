// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

namespace kambara {

/// A corner of a target found in a picture: which one (its number in corners_in_target_mm), where,
/// and the standard deviation of each coordinate.
struct DetectedCorner {
    int id = 0;
    Eigen::Vector2d px = Eigen::Vector2d::Zero();
    double sigma_px = 0.1;
    double blur_px = 0.0;  ///< width of the edges there; 0 where not measured
};

/// In ascending order of their numbers, each once; any part of the target.
using DetectedCorners = std::vector<DetectedCorner>;

}  // namespace kambara
