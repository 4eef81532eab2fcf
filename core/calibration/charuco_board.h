// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "core/calibration/target.h"

namespace kambara {

/// OpenCV's number of a marker dictionary by its name, and how many markers it has; empty for a
/// name that is none.
struct MarkerDictionary {
    int number = 0;
    int markers = 0;
};
std::optional<MarkerDictionary> marker_dictionary(const std::string& name);

/// One marker of a ChArUco board, in the board's frame (see corners_in_target_mm). The top-left
/// square is dark; the markers stand in the light ones, row by row, as OpenCV 4.6 draws them.
struct CharucoMarker {
    int id = 0;
    Eigen::Vector2d top_left_mm;
    int cells_a_side = 0;     ///< with the dark border
    std::vector<bool> light;  ///< row by row
};
std::vector<CharucoMarker> charuco_markers(const CharucoTarget& target);

}  // namespace kambara
