// SPDX-License-Identifier: GPL-3.0-or-later
// What targets look like.
#include "core/calibration/charuco_board.h"
#include "core/calibration/target.h"

namespace kambara {
namespace {

TargetPatch flat(double x, double y, double width, double height, bool dark) {
    return {{x, y, 0.0}, {width, 0.0, 0.0}, {0.0, height, 0.0}, dark};
}

// A white sheet with a margin beyond the squares, and the dark squares; the first square's
// top-left corner is at (-square, -square).
std::vector<TargetPatch> squares(int across, int down, double s) {
    std::vector<TargetPatch> all{flat(-2.0 * s, -2.0 * s, (across + 2) * s, (down + 2) * s, false)};
    all.front().sheet = true;
    for (int row = 0; row < down; ++row) {
        for (int column = row % 2; column < across; column += 2) {
            all.push_back(flat((column - 1) * s, (row - 1) * s, s, s, true));
        }
    }
    return all;
}

std::vector<TargetPatch> patches(const ChessboardTarget& target) {
    return squares(target.corners_across + 1, target.corners_down + 1, target.square_mm);
}

std::vector<TargetPatch> patches(const CharucoTarget& target) {
    const double s = target.square_mm;
    auto all = squares(target.squares_across, target.squares_down, s);
    for (const CharucoMarker& marker : charuco_markers(target)) {
        const Eigen::Vector2d at = marker.top_left_mm;
        all.push_back(flat(at.x(), at.y(), target.marker_mm, target.marker_mm, true));
        const int n = marker.cells_a_side;
        const double cell = target.marker_mm / n;
        for (int row = 0; row < n; ++row) {
            for (int column = 0; column < n; ++column) {
                if (marker.light[static_cast<std::size_t>(row * n + column)]) {
                    all.push_back(
                        flat(at.x() + column * cell, at.y() + row * cell, cell, cell, false));
                }
            }
        }
    }
    return all;
}

std::vector<TargetPatch> patches(const BoxTarget& target) {
    std::vector<TargetPatch> all;
    const auto frames = plane_frames(target);
    const double boxes_down = (target.rows - 1) * target.pitch_down_mm + target.box_height_mm;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const BoxPlane& plane = target.planes[i];
        const double before = i == 0 ? target.margin_mm : plane.gap_before_mm;
        const double after = i + 1 == frames.size() ? target.margin_mm : plane.gap_after_mm;
        const double boxes_across =
            (plane.columns - 1) * target.pitch_across_mm + target.box_width_mm;
        const auto& [origin, across, down] = frames[i];
        all.push_back({origin - before * across - target.margin_mm * down,
                       (before + boxes_across + after) * across,
                       (boxes_down + 2.0 * target.margin_mm) * down, !target.dark_on_light, true});
    }
    const auto corners = drawn_corners_mm(target);
    for (std::size_t i = 0; i < corners.size(); i += 4) {
        all.push_back({corners[i], corners[i + 1] - corners[i], corners[i + 3] - corners[i],
                       target.dark_on_light});
    }
    for (const RoundMark& mark : target.marks) {
        const auto& [origin, across, down] = frames[static_cast<std::size_t>(mark.plane)];
        const double d = mark.diameter_mm;
        all.push_back(
            {origin + (mark.across_mm - 0.5 * d) * across + (mark.down_mm - 0.5 * d) * down,
             d * across, d * down, target.dark_on_light, false, true});
    }
    return all;
}

std::vector<TargetPatch> patches(const PointTarget&) {
    return {};
}

}  // namespace

std::vector<TargetPatch> patches_of(const Target& target) {
    return std::visit([](const auto& kind) { return patches(kind); }, target);
}

}  // namespace kambara
