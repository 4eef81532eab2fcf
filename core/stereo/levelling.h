// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/base/result.h"
#include "core/camera/mount.h"
#include "core/camera/rig.h"

namespace kambara {

struct LevellingOptions {
    double largest_tilt_rad = 1.05;    ///< of the rig, pitch or roll: 60 degrees
    double largest_sigma_rad = 0.035;  ///< of a result that is of use: 2 degrees
    double outlier_deviations = 4.0;   ///< beyond so many, a point is left out
};

struct Levelling {
    Mount mount;  ///< pitch and roll, with their deviations; from a wall, the roll as it was given
    Eigen::Vector3d axis_in_rig = Eigen::Vector3d::Zero();  ///< straight down, or into the wall
    double extent_mm = 0.0;  ///< the movement's length, or the wall's height as far as measured
    double rms_mm = 0.0;     ///< of the distances from the line or the plane
    int points_used = 0;
    int points_left_out = 0;
};

/// The mount's pitch and roll from positions of a target that was moved straight up or down (1999,
/// section 7.2.2), in the rig's frame, mm: a line of least orthogonal distances is the plumb line.
/// The deviations are what the points' scatter about it leaves open, theirs taken as independent.
/// Refuses: fewer than 4 points, a movement along no line, a line that is not upright within 60
/// degrees of the rig's y axis, a result that is not known to 2 degrees.
Result<Levelling> level_from_vertical(const std::vector<Eigen::Vector3d>& points_in_rig_mm,
                                      const LevellingOptions& options = {});

/// The mount's pitch from points of an upright wall before the rig. A wall says nothing of roll:
/// that is given, 0 where the rig hangs level from side to side. Refuses: fewer than 6 points,
/// points on one line, a wall seen from its side, a result that is not known to 2 degrees.
Result<Levelling> level_from_wall(const std::vector<Eigen::Vector3d>& points_in_rig_mm,
                                  double roll_rad = 0.0, const LevellingOptions& options = {});

/// How far measured points spread, whether or not they are of use to level by.
struct Movement {
    double extent_mm = 0.0;         ///< along the line of their largest spread
    double off_line_rms_mm = 0.0;   ///< of the distances from that line
    double off_plane_rms_mm = 0.0;  ///< of those from the plane of least distances
};
Movement movement_of(const std::vector<Eigen::Vector3d>& points_mm);

/// A movement shorter than this is warned of: errors of 1 mm at its ends that hang together, as a
/// rig's do, turn it by half a degree.
inline constexpr double short_movement_mm = 200.0;

/// The angle by which points off a line by this RMS may have turned it if they bend rather than
/// scatter: a residual that grows evenly along the line is turned by its RMS times the root of 12
/// over the length. 0 without a length.
double largest_turn_by_bending_rad(double rms_mm, double extent_mm);

/// The rig with the mount that was found. Its heading and lever arm stay as they were, and, from a
/// wall, the roll's deviation, since a wall says nothing of roll.
Rig with_mount(Rig rig, const Levelling& found, bool from_wall);

}  // namespace kambara
