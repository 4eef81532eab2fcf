// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/triangulate.h"

#include <Eigen/Geometry>
#include <cmath>

namespace kambara {

std::optional<RayMeeting> meeting_of(const Ray& a, const Ray& b) {
    const Eigen::Vector3d normal = a.direction.cross(b.direction);
    const double sine_squared = normal.squaredNorm();
    if (!(sine_squared > 1e-24)) {
        return std::nullopt;
    }
    const Eigen::Vector3d between = b.origin_mm - a.origin_mm;
    RayMeeting meeting;
    meeting.distance_a_mm = between.cross(b.direction).dot(normal) / sine_squared;
    meeting.distance_b_mm = between.cross(a.direction).dot(normal) / sine_squared;
    const Eigen::Vector3d on_a = a.at(meeting.distance_a_mm);
    const Eigen::Vector3d on_b = b.at(meeting.distance_b_mm);
    meeting.midpoint_mm = 0.5 * (on_a + on_b);
    meeting.gap_mm = (on_b - on_a).norm();
    meeting.angle_rad = std::atan2(std::sqrt(sine_squared), a.direction.dot(b.direction));
    return meeting;
}

}  // namespace kambara
