// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <vector>

namespace kambara {

using Homography = Eigen::Matrix3d;
using Projection = Eigen::Matrix<double, 3, 4>;

/// The homography that takes plane places to pixels, from four pairs or more, by the direct linear
/// transformation with normalised coordinates (Hartley and Zisserman 2004, algorithm 4.2).
Homography fit_homography(const std::vector<Eigen::Vector2d>& places,
                          const std::vector<Eigen::Vector2d>& pixels);

/// The projection that takes points in space to pixels, from six pairs or more that are not
/// coplanar (algorithm 7.1). Its sign is such that the points' third coordinates are positive,
/// where they are all of one sign.
Projection fit_projection(const std::vector<Eigen::Vector3d>& points,
                          const std::vector<Eigen::Vector2d>& pixels);

inline Eigen::Vector2d apply(const Homography& H, const Eigen::Vector2d& place) {
    return (H * place.homogeneous()).hnormalized();
}
inline Eigen::Vector2d apply(const Projection& P, const Eigen::Vector3d& point) {
    return (P * point.homogeneous()).hnormalized();
}

/// Whether a camera can see so: the points before it, the picture not mirrored.
bool seen_from_before(const Projection& P, const std::vector<Eigen::Vector3d>& points);

}  // namespace kambara
