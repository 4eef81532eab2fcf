// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "core/calibration/target.h"

namespace kambara {

/// A box's place on its target: plane, column of that plane, row.
struct BoxPlace {
    int plane = 0;
    int column = 0;
    int row = 0;
    bool operator==(const BoxPlace&) const = default;
};

/// A round mark in the target's frame: its middle, and its radius along the plane's two axes.
struct BoxMark {
    Eigen::Vector3d middle_mm;
    Eigen::Vector3d across_mm;
    Eigen::Vector3d down_mm;
};

/// What finding the boxes of a target needs to know of it: equal boxes in rows and columns, on one
/// plane or more, left to right; all planes have the same rows.
struct BoxLayout {
    std::vector<int> columns;  ///< of each plane
    int rows = 0;
    double gap_to_width = 0.0;   ///< the white between two boxes of a row, by a box's width
    double gap_to_height = 0.0;  ///< ... of a column, by its height
    bool dark_on_light = true;
    std::vector<BoxMark> marks;  ///< that tell the target's parts apart, and which way up it is
    std::vector<Eigen::Vector3d> corners_mm;  ///< four a box, as drawn_corners_mm has them

    int boxes() const { return static_cast<int>(corners_mm.size() / 4); }
    /// Boxes are counted row by row, left to right over all planes.
    int box_number(const BoxPlace& place) const;
    BoxPlace place_of(int box) const;
    /// top-left, top-right, bottom-right, bottom-left
    std::array<Eigen::Vector3d, 4> corners_of(int box) const;
};

BoxLayout box_layout(const BoxTarget& target);

}  // namespace kambara
