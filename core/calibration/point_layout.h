// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/calibration/seen_point.h"

namespace kambara {

/// How points lie in space: their mean, the axes of their spread (a right-handed frame in columns,
/// the widest first) and the spread along each, root mean square, mm.
struct PointLayout {
    Eigen::Vector3d mean_mm = Eigen::Vector3d::Zero();
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
    Eigen::Vector3d spread_mm = Eigen::Vector3d::Zero();

    /// Within a thousandth of their extent.
    bool collinear() const { return !(spread_mm.y() > 1e-3 * spread_mm.x()); }
    bool coplanar() const { return !(spread_mm.z() > 1e-3 * spread_mm.x()); }
};

PointLayout layout_of(const std::vector<SeenPoint>& points);

}  // namespace kambara
