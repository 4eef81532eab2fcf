// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/camera/lens.h"
#include "core/geometry/rigid_transform.h"

namespace kambara {

/// A point of the target and the pixel at which a camera saw it.
struct SeenPoint {
    Eigen::Vector3d in_world_mm = Eigen::Vector3d::Zero();
    Eigen::Vector2d seen_px = Eigen::Vector2d::Zero();
};

/// One camera before one target: Tsai's eleven parameters.
struct TsaiView {
    TsaiLens lens;
    RigidTransform T_camera_from_world;
};

/// From each seen pixel to where the view projects its point, px; NaN where it projects nowhere.
std::vector<Eigen::Vector2d> residuals_px(const TsaiView& view,
                                          const std::vector<SeenPoint>& points);

/// The sum of the squared lengths of those residuals; NaN where one is NaN.
double squared_error_px2(const TsaiView& view, const std::vector<SeenPoint>& points);

/// The diagonal of the rectangle that holds the middle four fifths of the pixels in x and in y: the
/// part of the picture that is filled, without what lies far off. Needs a point.
double extent_px(const std::vector<SeenPoint>& points);

}  // namespace kambara
