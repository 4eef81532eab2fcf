// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "core/base/result.h"
#include "core/image/image.h"
#include "core/image/rectangle.h"

namespace kambara {

/// How well a piece of a grey picture can be told from its surroundings.
struct Texture {
    double contrast_grey = 0.0;  ///< standard deviation after a 3 x 3 mean (which damps noise)
    /// The weaker of the two principal gradients, root mean square, grey levels per pixel: small
    /// along a straight edge, which slides on itself.
    double weakest_gradient_grey_px = 0.0;
};

Texture texture_of(const Image& grey, const Rectangle& rectangle);

/// Whether a template may be cut at `rectangle`: inside the picture, 7 x 7 pixels at the least,
/// enough texture in every direction to be followed. The error says which failed.
Result<Done> check_template(const Image& grey, const Rectangle& rectangle);

/// Covariance, px^2, of a match found by least squares between the part `inner` of `templ` and the
/// piece of `grey` at (x, y) once gain and offset are fitted: residual variance by the inverse of
/// the summed gradient products, plus `floor_px` squared for what the model of the patch leaves
/// out.
Eigen::Matrix2d match_covariance_px2(const Image& grey, const Image& templ, const Rectangle& inner,
                                     int x, int y, double floor_px);

}  // namespace kambara
