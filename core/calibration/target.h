// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/base/result.h"

namespace kambara {

/// A flat chessboard, described by its inner corners.
struct ChessboardTarget {
    int corners_across = 9;
    int corners_down = 6;
    double square_mm = 30.0;
    bool operator==(const ChessboardTarget&) const = default;
};

/// The 24-box target: two planes at a right angle like an open book, 3 x 4 dark boxes on each
/// (calibration: the target). All its sizes are fixed by the drawing.
struct TwoPlaneTarget {
    bool operator==(const TwoPlaneTarget&) const = default;
};

using Target = std::variant<ChessboardTarget, TwoPlaneTarget>;

/// Reads the short form: `chessboard:9x6:30` (inner corners across x down, square in mm) or
/// `two-plane-24`.
Result<Target> parse_target(std::string_view text);
std::string to_string(const Target& target);

/// The corners in the target's own frame W, mm. Chessboard: row by row from its first inner corner,
/// z = 0. Two planes: boxes left to right, top to bottom over both planes (6 a row); in a box
/// top-left, top-right, bottom-right, bottom-left; z into the target.
std::vector<Eigen::Vector3d> corners_in_target_mm(const Target& target);

/// A flat rectangle of the target's surface, for drawing it: origin, and the two edges as vectors.
struct TargetPatch {
    Eigen::Vector3d origin_mm;
    Eigen::Vector3d across_mm;
    Eigen::Vector3d down_mm;
    bool dark = false;
};

/// The white sheets first, then the dark boxes or squares on them.
std::vector<TargetPatch> patches_of(const Target& target);

}  // namespace kambara
