// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/base/result.h"

namespace kambara {

/// A corner that was measured, in place of where the drawing has it.
struct MeasuredCorner {
    int id = 0;
    Eigen::Vector3d at_mm = Eigen::Vector3d::Zero();
    double sigma_mm = 0.01;  ///< of each coordinate
    bool operator==(const MeasuredCorner&) const = default;
};

/// How well the corners' places are known.
struct TargetAccuracy {
    double sigma_mm = 0.01;  ///< of each coordinate of a corner that follows the drawing
    std::vector<MeasuredCorner> measured;
    bool operator==(const TargetAccuracy&) const = default;
};

/// A flat chessboard, described by its inner corners.
struct ChessboardTarget {
    int corners_across = 9;
    int corners_down = 6;
    double square_mm = 30.0;
    TargetAccuracy accuracy = {};
    bool operator==(const ChessboardTarget&) const = default;
};

/// A chessboard with markers in its white squares (ChArUco), so that a part of it is enough.
struct CharucoTarget {
    int squares_across = 5;
    int squares_down = 7;
    double square_mm = 40.0;
    double marker_mm = 20.0;
    std::string dictionary = "DICT_6X6_250";  ///< OpenCV's name
    TargetAccuracy accuracy = {};
    bool operator==(const CharucoTarget&) const = default;
};

/// One plane of a box target. Planes stand beside each other, each meeting the one before it at a
/// vertical edge.
struct BoxPlane {
    int columns = 3;
    double angle_deg = 180.0;    ///< inside, to the plane before; the first plane's counts nothing
    double gap_before_mm = 0.0;  ///< from the edge shared with the plane before to the first column
    double gap_after_mm = 0.0;   ///< from the last column to the edge shared with the plane behind
    bool operator==(const BoxPlane&) const = default;
};

/// A round mark that breaks the symmetry, in its plane's frame: from the top-left corner of the
/// plane's top-left box, across and down.
struct RoundMark {
    int plane = 0;
    double across_mm = 0.0;
    double down_mm = 0.0;
    double diameter_mm = 0.0;
    bool operator==(const RoundMark&) const = default;
};

/// Boxes in rows and columns on one or more planes (calibration: the target).
struct BoxTarget {
    std::vector<BoxPlane> planes;
    int rows = 4;
    double box_width_mm = 50.0;
    double box_height_mm = 70.0;
    double pitch_across_mm = 75.0;
    double pitch_down_mm = 95.0;
    double margin_mm = 25.0;  ///< of sheet around the outermost boxes, where no plane follows
    bool dark_on_light = true;
    std::vector<RoundMark> marks;
    TargetAccuracy accuracy = {};
    bool operator==(const BoxTarget&) const = default;
};

/// The 24-box target: two planes at a right angle like an open book, 3 x 4 boxes on each.
BoxTarget two_plane_24();

/// Any points at known places. What they look like is not said, so they are not found in pictures.
struct PointTarget {
    std::vector<Eigen::Vector3d> points_mm;
    TargetAccuracy accuracy = {};
    bool operator==(const PointTarget&) const = default;
};

using Target = std::variant<ChessboardTarget, CharucoTarget, BoxTarget, PointTarget>;

/// A target from its file (a name ending in .yaml or .yml, see target_file.h) or its short form:
/// `two-plane-24`, `chessboard:9x6:30` (inner corners across x down, square in mm), or
/// `charuco:5x7:40:20:DICT_6X6_250` (squares across x down, square, marker, dictionary).
Result<Target> parse_target(std::string_view text);

/// The short form where there is one; else a few words for people.
std::string to_string(const Target& target);

/// Why a target can't be made or used; empty where it can.
std::string target_fault(const Target& target);

/// The corners in the target's own frame W, mm, z into the target; a corner's number is its
/// identity. Measured corners stand where they were measured. Chessboards: row by row from the
/// first inner corner, which is the origin; z = 0. Boxes: row by row, each row left to right over
/// all planes; in a box top-left, top-right, bottom-right, bottom-left; the origin is the top-left
/// corner of the first plane's top-left box, x along that plane, y down.
std::vector<Eigen::Vector3d> corners_in_target_mm(const Target& target);

/// As above, where the drawing alone has them.
std::vector<Eigen::Vector3d> drawn_corners_mm(const Target& target);

/// Standard deviation of each coordinate of each corner, mm.
std::vector<double> corner_sigmas_mm(const Target& target);

const TargetAccuracy& accuracy_of(const Target& target);
TargetAccuracy& accuracy_of(Target& target);

/// The axes of a plane of a box target, in the target's frame.
struct BoxPlaneFrame {
    Eigen::Vector3d origin_mm;  ///< the top-left corner of its top-left box
    Eigen::Vector3d across;     ///< of unit length, as is `down`
    Eigen::Vector3d down;
};
std::vector<BoxPlaneFrame> plane_frames(const BoxTarget& target);

/// A flat piece of the target's surface, for drawing it: origin, and the two edges as vectors.
struct TargetPatch {
    Eigen::Vector3d origin_mm;
    Eigen::Vector3d across_mm;
    Eigen::Vector3d down_mm;
    bool dark = false;
    bool sheet = false;  ///< carries the others; these lie on it, later ones over earlier ones
    bool round = false;  ///< the ellipse within the rectangle
};

/// The sheets first, then the squares, boxes and marks on them. A list of points has none.
std::vector<TargetPatch> patches_of(const Target& target);

}  // namespace kambara
