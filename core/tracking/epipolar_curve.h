// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/camera/rig.h"

namespace kambara {

/// Distances between which a target is looked for, along the left ray.
struct RangeBounds {
    double nearest_mm = 250.0;
    double farthest_mm = 1.0e6;
};

/// A place along a left pixel's ray and the right pixel that sees it.
struct EpipolarSample {
    Eigen::Vector3d point_in_rig_mm;
    Eigen::Vector2d right_px;
};

/// The epipolar curve of a left pixel as the lenses draw it: places along the ray from near to
/// far, no two neighbours more than `step_px` apart in the right picture. Straight only for lenses
/// without distortion. Parts that the right camera does not see are left out; a `margin_px` beyond
/// the picture's border still counts as seen. Empty where nothing is seen.
std::vector<EpipolarSample> epipolar_curve(const Rig& rig, const Eigen::Vector2d& left_px,
                                           const RangeBounds& bounds, double step_px,
                                           double margin_px = 0.0);

}  // namespace kambara
