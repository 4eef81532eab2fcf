// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "core/calibration/edge_chain.h"

namespace kambara {

/// Four corners in a picture, clockwise on the screen (x right, y down).
using Quadrilateral = std::array<Eigen::Vector2d, 4>;

/// The quadrilateral that a chain goes round, good to about a pixel: the largest one within the
/// chain's convex hull, less the half pixel by which the edge lies inside the chain. Empty where
/// the chain is no convex quadrilateral, such as a disc's.
std::optional<Quadrilateral> box_outline(const EdgeChain& chain);

/// Mean width (of the first side and the one across from it) and height, px.
Eigen::Vector2d mean_size_px(const Quadrilateral& box);

/// The corners numbered so that the first is the top-left one of a box that stands within 45
/// degrees of upright.
Quadrilateral upright(const Quadrilateral& box);

/// The corners numbered from another one on.
Quadrilateral turned(const Quadrilateral& box, int corners);

}  // namespace kambara
