// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/base/result.h"
#include "core/camera/mount.h"

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

}  // namespace kambara
