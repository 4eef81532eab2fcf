// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/calibration/rig_views.h"
#include "core/calibration/target.h"
#include "core/camera/rig.h"
#include "core/geometry/rigid_transform.h"
#include "core/image/image.h"

namespace kambara::testing_support {

/// One showing of the 24-box target: a picture by each camera of a rig, left, right, pan-tilt.
struct ShownTarget {
    RigidTransform T_rig_from_target;
    std::vector<Image> pictures;
};

/// The target at random places and turns before the rig, wholly in sight of the left and the right
/// camera, with at least `least_boxes_px` of width to its narrowest box there; pictures rendered by
/// exact area coverage, blurred, with noise of 2 grey levels.
std::vector<ShownTarget> shown_targets(const Rig& rig, int views, std::uint32_t seed,
                                       double least_boxes_px = 6.0, double blur_px = 0.0);

/// The detector's corners in each of the pictures, on all cores.
std::vector<RigView> detected_views(const std::vector<ShownTarget>& shown, const Target& target);

}  // namespace kambara::testing_support
