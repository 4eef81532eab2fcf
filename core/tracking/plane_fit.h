// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>

#include "core/camera/rig.h"
#include "core/image/image.h"
#include "core/tracking/patch.h"

namespace kambara {

/// A flat piece that two pictures of the same instant agree on.
struct PlaneFit {
    double range_mm = 0.0;  ///< of the patch's reference point, from the left camera's eye
    Eigen::Vector2d slope;  ///< of the plane: change of the rig's z by x and by y
    Eigen::Matrix2d slope_covariance;
    Eigen::Vector2d right_px;        ///< where the right picture shows the reference point
    Eigen::Matrix2d covariance_px2;  ///< of it, whatever the slope; of what is left over
    double off_curve_px = 0.0;       ///< across the epipolar curve: the calibration's own error
    double likeness = 0.0;           ///< correlation of both pictures' pixels, in [0, 1]
};

/// Fits the plane of a patch, cut from the left picture and as yet thought to lean as its slope
/// says, to the right picture: distance, two slopes, a shift across the epipolar curve, gain and
/// offset at once, by Gauss-Newton on the grey values (the plane-induced map between two views,
/// Hartley and Zisserman, Multiple view geometry, 2004, section 13.1, through the lenses). Distance
/// and slope err together where texture is little: the covariance holds that. Starts at `range_mm`;
/// a few pixels off will do. Empty where it strays farther, leans too steeply, or texture is
/// lacking. The rig must have a right camera.
std::optional<PlaneFit> fit_plane(const ReferencePatch& patch, const Rig& rig,
                                  const Image& right_grey, double range_mm);

}  // namespace kambara
