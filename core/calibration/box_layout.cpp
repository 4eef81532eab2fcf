// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/box_layout.h"

#include <numeric>

#include "core/calibration/box_marks.h"

namespace kambara {

int BoxLayout::box_number(const BoxPlace& place) const {
    const int a_row = std::accumulate(columns.begin(), columns.end(), 0);
    const int before = std::accumulate(columns.begin(), columns.begin() + place.plane, 0);
    return place.row * a_row + before + place.column;
}

BoxPlace BoxLayout::place_of(int box) const {
    const int a_row = std::accumulate(columns.begin(), columns.end(), 0);
    if (a_row <= 0) {
        return {};
    }
    BoxPlace place{0, box % a_row, box / a_row};
    while (place.column >= columns[static_cast<std::size_t>(place.plane)]) {
        place.column -= columns[static_cast<std::size_t>(place.plane)];
        ++place.plane;
    }
    return place;
}

std::array<Eigen::Vector3d, 4> BoxLayout::corners_of(int box) const {
    const auto first = static_cast<std::size_t>(4 * box);
    return {corners_mm[first], corners_mm[first + 1], corners_mm[first + 2], corners_mm[first + 3]};
}

BoxLayout box_layout(const BoxTarget& target) {
    BoxLayout layout;
    for (const BoxPlane& plane : target.planes) {
        layout.columns.push_back(plane.columns);
    }
    layout.rows = target.rows;
    layout.gap_to_width = target.pitch_across_mm / target.box_width_mm - 1.0;
    layout.gap_to_height = target.pitch_down_mm / target.box_height_mm - 1.0;
    layout.dark_on_light = target.dark_on_light;
    layout.marks = box_marks(target);
    layout.corners_mm = drawn_corners_mm(Target(target));
    return layout;
}

}  // namespace kambara
