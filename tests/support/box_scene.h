// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <set>
#include <vector>

#include "core/calibration/target.h"
#include "core/camera/lens.h"
#include "core/geometry/rigid_transform.h"
#include "core/image/image.h"
#include "tests/support/coverage.h"

namespace kambara::testing_support {

/// A picture of a target of boxes, rendered by exact area coverage, with what may go wrong in it.
struct BoxScene {
    Target target = parse_target("two-plane-24").value();
    RigidTransform camera_from_target;
    Lens lens;
    int width_px = 640;
    int height_px = 480;
    double paper = 200.0;  ///< of the sheets, the second one a tenth darker
    double ink = 35.0;
    double background = 70.0;
    std::set<int> hidden;                        ///< boxes lost to glare: as white as the paper
    std::vector<CoverageCanvas::Piece> behind;   ///< disjoint, painted before the target
    std::vector<CoverageCanvas::Piece> over_it;  ///< ... and after it
    double blur_px = 0.0;
    double gamma = 1.0;  ///< the camera's levels are 255 (light / 255)^(1 / gamma)
    double noise = 2.0;  ///< deviation, grey levels
    std::uint32_t seed = 1;
};

Image rendered(const BoxScene& scene);

/// The target's corners in the picture.
std::vector<Eigen::Vector2d> true_corners_px(const BoxScene& scene);

/// The target turned by roll, then yaw and tilt, its middle at this place in the camera's frame.
/// Yaw 0 looks along the bisector into the open book.
RigidTransform target_pose(const Target& target, const Eigen::Vector3d& middle_in_camera_mm,
                           double yaw_rad, double tilt_rad, double roll_rad);

/// Quadrilaterals strewn over the picture, some like boxes, that stay `clear_px` away from the
/// target and from each other.
std::vector<CoverageCanvas::Piece> decoys(const BoxScene& scene, int count, std::uint32_t seed);

/// The narrowest box's width, px.
double narrowest_box_px(const std::vector<Eigen::Vector2d>& corners_px);

}  // namespace kambara::testing_support
