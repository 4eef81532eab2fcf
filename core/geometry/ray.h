// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "core/geometry/rigid_transform.h"

namespace kambara {

/// A half line. It has an origin of its own since a camera behind a port has no single centre.
struct Ray {
    Eigen::Vector3d origin_mm = Eigen::Vector3d::Zero();
    Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();  ///< of unit length

    Eigen::Vector3d at(double distance_mm) const { return origin_mm + distance_mm * direction; }
};

inline Ray operator*(const RigidTransform& T_b_from_a, const Ray& ray_in_a) {
    return {T_b_from_a * ray_in_a.origin_mm, T_b_from_a.R * ray_in_a.direction};
}

}  // namespace kambara
