// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/calibration/box_outline.h"

namespace kambara {

/// One box of a grid: its number in the list that was given, and its column and row in the grid,
/// counted from any of them.
struct GridBox {
    std::size_t box = 0;
    int column = 0;
    int row = 0;
};
using BoxGrid = std::vector<GridBox>;

struct BoxGridOptions {
    double gap_to_width = 0.5;
    double gap_to_height = 0.5;
    int most_columns = 3;  ///< that a grid can have
    int most_rows = 4;
};

/// Groups quadrilaterals that stand in one plane's rows and columns. From a box its neighbours are
/// foretold through the homography of the boxes nearby, so that neither perspective nor a lens that
/// bends the whole matters, and taken where all four corners agree; where the nearest one is
/// missing, the next but one is looked for. A quadrilateral belongs to one grid; one that has no
/// neighbours is a grid by itself. The corners in `boxes` are renumbered to stand as their grid
/// does. Largest grids first. Any thread.
std::vector<BoxGrid> grids_of(std::vector<Quadrilateral>& boxes, const BoxGridOptions& options);

/// The turn of `box` that brings its corners nearest to those foretold, and how far the worst one
/// then is, px.
struct CornerMatch {
    int turn = 0;
    double farthest_px = 0.0;
};
CornerMatch match_corners(const Quadrilateral& box, const Quadrilateral& foretold);

}  // namespace kambara
