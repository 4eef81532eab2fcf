// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

namespace kambara {

/// A plane that holds points of a target, with axes as somebody sees it who looks at the target.
struct PointPlane {
    Eigen::Vector3d origin_mm;  ///< one of its points
    Eigen::Vector3d across;     ///< of unit length, as is `down`
    Eigen::Vector3d down;
    std::vector<int> points;  ///< by number, rising
};

/// The planes that hold the points: again and again the one that holds most of those left, to
/// 0.02 mm. A point on two planes is in both. Empty where some points lie on no plane of four or
/// more, or more than 16 planes would be needed. Points: mm, in the target's frame, z away from who
/// looks at it.
std::vector<PointPlane> planes_of(const std::vector<Eigen::Vector3d>& points_mm);

}  // namespace kambara
