// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "core/calibration/box_outline.h"
#include "core/calibration/straightener.h"
#include "core/image/image.h"

namespace kambara {

/// What the light was that made a pixel's level, so that half the light is half-way between.
using LightOfLevel = std::array<float, 256>;

/// Levels as they are (gamma 1), or those of a camera that writes 255 (light / 255)^(1 / gamma).
LightOfLevel light_of_level(double gamma);

struct SideFitOptions {
    double gap_to_width = 0.5;  ///< the light gap beside a box, by its width
    double gap_to_height = 0.5;
    double blur_px =
        0.4;  ///< deviation of the picture's blur, for the share of it to stay clear of
    double least_contrast = 15.0;
};

/// A side: edge points and the line through them.
struct FittedSide {
    std::vector<Eigen::Vector2d> points_px;
    double sigma_px = 0.0;  ///< of one point across the side
    double dark = 0.0;      ///< light on either side of the edge
    double light = 0.0;
    double rms_px = 0.0;  ///< of the points beside the line
};

struct FittedBox {
    Quadrilateral corners_px;
    std::array<double, 4> sigma_px{};  ///< of each coordinate of each corner
    std::array<FittedSide, 4> sides;   ///< from corner i to corner i + 1
    double blur_px = 0.0;              ///< of its edges, beyond the pixels' own area
};

/// Measures a dark box whose corners are known to about a pixel. Across each side, row by row or
/// column by column, the edge lies where the light on either side would have to meet to give the
/// sum that is there: an integral over the step, which neither the pixels' area nor any symmetric
/// blur moves. Rows near a corner, which the neighbouring side touches, are left out. Lines are
/// fitted by orthogonal regression in straightened coordinates, with outliers left out, and
/// neighbouring lines are intersected in homogeneous form. Empty where a side has no three such
/// rows or no contrast. Any thread.
std::optional<FittedBox> fit_sides(const Image& grey, const LightOfLevel& light,
                                   const Quadrilateral& start, const SideFitOptions& options,
                                   const Straightener& straightener = {});

}  // namespace kambara
