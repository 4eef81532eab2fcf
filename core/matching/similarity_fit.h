// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>

#include "core/image/image.h"
#include "core/image/rectangle.h"

namespace kambara {

/// How a template lies in a picture: moved, turned in the picture's plane, and grown.
struct SimilarityMatch {
    Eigen::Vector2d centre_px = Eigen::Vector2d::Zero();  ///< of the template, in the picture
    double scale = 1.0;                                   ///< more than 1: larger in the picture
    double turn_rad = 0.0;                                ///< from x towards y
    double scale_sigma = 0.0;                             ///< standard deviations, by the residual
    double turn_sigma_rad = 0.0;
    double residual_grey = 0.0;  ///< root mean square of what counts
    double outlier_share = 0.0;  ///< of the pixels that do not fit: what hides the target
};

/// Finds centre, size and turn of least squared differences between the picture, interpolated by a
/// cubic spline, and the template with gain and offset free: Gauss-Newton steps with the
/// template's own gradients (inverse compositional: Baker & Matthews 2004, section 3.2). Pixels
/// that stand out from the rest count less and less (Tukey's weights), so that a particle that
/// drifts by does not pull. `rectangle` is the template within `picture_of_template`; of a mask of
/// the rectangle's size, only the pixels where it is not 0 count. Empty where the template lacks
/// texture, where it would leave the picture, or where the steps lead farther than 3 pixels, a
/// fifth of the size or 0.3 rad away. Grey pictures. Any thread.
std::optional<SimilarityMatch> fit_similarity(const Image& picture,
                                              const Image& picture_of_template,
                                              const Rectangle& rectangle,
                                              const Eigen::Vector2d& start_centre_px,
                                              const Image* mask = nullptr);

}  // namespace kambara
