// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/calibration/seen_point.h"

namespace kambara {

/// Tsai's linear stage: from the radial alignment constraint (a point, its picture and the optical
/// axis lie in one plane, whatever the radial distortion) the rotation, T_x, T_y and s_x; then f
/// and T_z (calibration: Tsai's method, steps 1 to 3). `given` holds what is known: the sensor,
/// the centre and, for a plane, s_x.
///
/// It divides by T_y, so the world's origin is moved to a point seen well above or below the
/// centre, and back again. Which one matters a little, for the equations' noise is not evenly
/// weighted: the outermost point of each quarter of the picture is tried.
///
/// Gives candidates, each before all the points: of every origin one with kappa1 = 0 and one with
/// kappa1 taken along. None where the points do not determine a camera, or only one with f < 0,
/// which is what a left-handed world or a mirrored picture comes to. Needs 7 points, not on one
/// plane.
std::vector<TsaiView> tsai_linear(const std::vector<SeenPoint>& points, const TsaiLens& given);

/// The same for points on one plane, wherever that is in the world; s_x can't be told and is kept.
/// Needs 5 points, not on one line. A plane tells nothing about mirrors: mirrored, it is the same
/// plane seen from behind.
std::vector<TsaiView> tsai_linear_coplanar(const std::vector<SeenPoint>& points,
                                           const TsaiLens& given);

}  // namespace kambara
