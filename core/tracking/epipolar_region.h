// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "core/camera/rig.h"
#include "core/matching/search_region.h"
#include "core/tracking/epipolar_curve.h"

namespace kambara {

/// Where a template of width x height pixels, cut about a pixel of the left picture, can be in the
/// right one: the positions whose centre, rounded, lies at most `band_px` in x and in y from the
/// epipolar curve as the lenses draw it, between the bounds. Empty where the right camera sees
/// nothing of it.
SearchRegion epipolar_region(const Rig& rig, const Eigen::Vector2d& left_px,
                             const RangeBounds& bounds, int band_px, int width, int height);

}  // namespace kambara
