// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "core/base/result.h"
#include "core/stereo/position.h"

namespace kambara {

/// The midpoint of the common perpendicular of the two pixels' rays, in the left camera's frame, mm
/// (geometry: position, method 2). Closed form, biased far away; a reference for
/// position_from_pair, which starts from it. Refuses as ray_pair does; the residual gate of the
/// options is not looked at.
Result<Eigen::Vector3d> midpoint_from_pair(const Rig& rig, const Eigen::Vector2d& left_pixel,
                                           const Eigen::Vector2d& right_pixel,
                                           const PositionOptions& options = {});

}  // namespace kambara
