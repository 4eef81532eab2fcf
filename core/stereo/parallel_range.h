// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "core/base/result.h"
#include "core/camera/rig.h"

namespace kambara {

/// Distance along z of a point seen by two parallel pinhole cameras side by side:
/// range = baseline f / (disparity pixel size), disparity = left column - right column. For
/// comparison only (geometry: position). Refuses a disparity that is not positive.
Result<double> parallel_range_mm(double baseline_mm, double f_mm, double disparity_px,
                                 double pixel_size_mm);

/// The position of a pair of pixels by that range, in the left camera's frame, mm; the lenses'
/// distortion is removed first. Refuses cameras that are not parallel (position_method.h) and
/// pixels that no ray reaches.
Result<Eigen::Vector3d> parallel_from_pair(const Rig& rig, const Eigen::Vector2d& left_pixel,
                                           const Eigen::Vector2d& right_pixel);

}  // namespace kambara
