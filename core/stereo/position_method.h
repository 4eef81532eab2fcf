// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/camera/rig.h"

namespace kambara {

/// The ways from two pixels to a position (geometry: position).
enum class PositionMethod {
    reprojection,  ///< least reprojection error: what the system reports by itself
    sine,          ///< 1999's sine rule, the mean of both lines' answers (sine_rule.h)
    midpoint,      ///< of the rays' common perpendicular (midpoint.h)
    parallel,      ///< baseline f / disparity, for parallel cameras only (parallel_range.h)
};

std::string to_string(PositionMethod method);
Result<PositionMethod> position_method_from(std::string_view name);

/// Whether a rig's positions can be found that way. Refuses, with the reason: any method without a
/// right camera; parallel, where the cameras look more than 0.1 degrees apart or one stands more
/// than 0.1 degrees ahead of the other, as seen along the baseline. Either makes an error of range
/// that grows with it: at 1.5 m and a baseline of 450 mm 0.6 % for 0.1 degrees.
Result<Done> check_position_method(const Rig& rig, PositionMethod method);

}  // namespace kambara
