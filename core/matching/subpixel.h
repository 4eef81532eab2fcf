// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>

#include "core/image/image.h"
#include "core/image/rectangle.h"

namespace kambara {

/// Where a template lies to a part of a pixel.
struct SubpixelMatch {
    Eigen::Vector2d position_px = Eigen::Vector2d::Zero();  ///< of the template's top-left pixel
    Eigen::Matrix2d covariance_px2 = Eigen::Matrix2d::Zero();
    double gain = 1.0;  ///< picture = gain x template + offset
    double offset_grey = 0.0;
    double residual_grey = 0.0;  ///< root mean square of what is left
};

/// Moves a match to the place of least squared differences between the picture, interpolated by a
/// cubic spline, and the template with gain and offset free: Gauss-Newton steps with the
/// template's own gradients (inverse compositional: Baker & Matthews 2004, section 3.2), which a
/// parabola through the scores misses by up to a tenth of a pixel. The covariance follows from the
/// residual, taken as white noise of picture and template, and the gradients freed of the
/// template's noise; what is alike for neighbouring pixels (another shape, another light) is not in
/// it. `rectangle` is the template within `picture_of_template`; `start_px`
/// should be within a pixel or so. Empty where the template has no texture in some direction, where
/// it would leave the picture, or where the steps lead farther than 1.5 pixels away. Grey pictures.
std::optional<SubpixelMatch> refine_match(const Image& picture, const Image& picture_of_template,
                                          const Rectangle& rectangle,
                                          const Eigen::Vector2d& start_px);

}  // namespace kambara
