// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>

#include "core/geometry/ray.h"

namespace kambara {

/// The common perpendicular of two rays.
struct RayMeeting {
    double distance_a_mm = 0.0;  ///< along ray a to its foot; negative: behind its origin
    double distance_b_mm = 0.0;
    Eigen::Vector3d midpoint_mm = Eigen::Vector3d::Zero();
    double gap_mm = 0.0;     ///< length of the perpendicular: how far the rays miss each other
    double angle_rad = 0.0;  ///< between the rays
};

/// Closed form; empty where the rays are parallel to rounding.
std::optional<RayMeeting> meeting_of(const Ray& a, const Ray& b);

}  // namespace kambara
