// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/base/result.h"
#include "core/calibration/box_grid.h"
#include "core/calibration/box_layout.h"
#include "core/calibration/target_view.h"
#include "core/image/image.h"

namespace kambara {

/// A quadrilateral of the picture that is a box of the target.
struct IdentifiedBox {
    std::size_t box = 0;  ///< its number in the list that was given
    int number = 0;       ///< the box's own on the target
    int turn = 0;         ///< which of its corners is the top-left one
};

struct Identity {
    std::vector<IdentifiedBox> boxes;
    TargetView view;      ///< how the target was taken to be seen
    double rms_px = 0.0;  ///< of the corners' distances to where that has them
};

/// Tells which box of the target each quadrilateral is: places grids on the target's planes, two at
/// a time where it has several, so that one view of the whole explains all corners, and takes up
/// the single boxes that the view foretells. The target stands within 45 degrees of upright.
/// Refuses where too few fit, and where the boxes seen could be others: they must reach the top and
/// the bottom row, and the first and the last plane (of a flat target, the first and the last
/// column). A target with marks may be turned any way and seen in any part with a mark in it; there
/// must be one, none may be missing where it ought to be seen, and no other placement may have it
/// so. `grey` is the picture, dark boxes on light. Any thread.
Result<Identity> identify_boxes(const std::vector<Quadrilateral>& boxes,
                                const std::vector<BoxGrid>& grids, const BoxLayout& layout,
                                const Image& grey);

}  // namespace kambara
