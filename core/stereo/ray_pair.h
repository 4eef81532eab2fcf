// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "core/base/result.h"
#include "core/camera/rig.h"
#include "core/geometry/triangulate.h"

namespace kambara {

/// The rays of a pixel in each picture, in the rig's frame, and how they pass each other.
struct RayPair {
    Ray left;
    Ray right;
    RayMeeting meeting;  ///< a is the left ray, b the right one
};

/// What every method of measuring a position asks of two pixels. Refuses, with the reason: a pixel
/// that no ray reaches, rays closer to parallel than `min_parallax_rad`, rays that come nearest to
/// each other behind a camera. The rig must have a right camera.
Result<RayPair> ray_pair(const Rig& rig, const Eigen::Vector2d& left_pixel,
                         const Eigen::Vector2d& right_pixel, double min_parallax_rad);

}  // namespace kambara
