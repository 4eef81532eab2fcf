// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/detected_corners.h"
#include "core/image/image.h"

namespace kambara {

/// Refines corners of a checkered pattern in place: each in a window of `share` of the distance to
/// its nearest neighbour to each side, so that it holds one corner only, near or far. Sets each
/// corner's deviation from the picture's noise and the gradients in the window (the least squares'
/// own covariance, not below 0.02 px), and how far the edges there are blurred. A corner that runs
/// away from where it was is dropped.
void refine_corners(const Image& grey, DetectedCorners& corners, double share = 0.3);

/// The distance from a corner to its nearest neighbour, px.
double spacing_px(const DetectedCorners& corners, std::size_t at);

}  // namespace kambara
