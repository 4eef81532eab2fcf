// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

namespace kambara {

/// The three rules by which 1999 looked for the top left point of those that are left, kept to
/// compare with. Pixels here as elsewhere: y down; the bottom left of the picture is (0, height).
enum class TopLeftRule {
    max_theta,            ///< MAXTHETA: the largest angle about the picture's bottom left corner
    topleft_bottomright,  ///< TOPLEFTBOTTOMRIGHT: the left side faces the top left: least x + y
    bottomleft_topright,  ///< BOTTOMLEFTTOPRIGHT: it faces the bottom left: least x
};

/// Sorts points left to right, top to bottom as in 1999: begin at the top left one, go on to the
/// nearest one within `half_angle_rad` of the x axis until there is none, and begin again with what
/// is left.
/// Gives the points' numbers in that order.
std::vector<std::size_t> sort_points(const std::vector<Eigen::Vector2d>& points, TopLeftRule rule,
                                     int height_px, double half_angle_rad = 0.6);

}  // namespace kambara
