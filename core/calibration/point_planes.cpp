// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/point_planes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace kambara {
namespace {

constexpr double tolerance_mm = 0.02;
constexpr std::size_t least_points = 4;
constexpr std::size_t most_planes = 16;
constexpr std::size_t most_mates = 60;  // points tried beside the first one that is left

using Points = std::vector<Eigen::Vector3d>;

// Unit normal; zero where the three lie on a line.
Eigen::Vector3d normal_of(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                          const Eigen::Vector3d& c) {
    const Eigen::Vector3d n = (b - a).cross(c - a);
    const double sides = (b - a).norm() * (c - a).norm();
    return n.norm() > 1e-3 * sides ? Eigen::Vector3d(n.normalized()) : Eigen::Vector3d::Zero();
}

std::vector<int> points_on(const Points& points, const Eigen::Vector3d& origin,
                           const Eigen::Vector3d& normal) {
    std::vector<int> on;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (std::abs(normal.dot(points[i] - origin)) <= tolerance_mm) {
            on.push_back(static_cast<int>(i));
        }
    }
    return on;
}

// The plane through the first point left that holds most points.
PointPlane fullest_plane(const Points& points, const std::vector<int>& left,
                         Eigen::Vector3d& normal) {
    const auto at = [&](int i) -> const Eigen::Vector3d& {
        return points[static_cast<std::size_t>(i)];
    };
    PointPlane best;
    best.origin_mm = at(left.front());
    const std::size_t step = std::max<std::size_t>(1, left.size() / most_mates);
    for (std::size_t i = 1; i < left.size(); i += step) {
        for (std::size_t j = i + 1; j < left.size(); j += step) {
            const Eigen::Vector3d n = normal_of(best.origin_mm, at(left[i]), at(left[j]));
            if (n.isZero()) {
                continue;
            }
            auto on = points_on(points, best.origin_mm, n);
            if (on.size() > best.points.size()) {
                best.points = std::move(on);
                normal = n;
            }
            if (best.points.size() == points.size()) {
                return best;
            }
        }
    }
    return best;
}

// y downwards where the plane is not level, and across to the right of who looks at it from before
// the target.
void set_axes(PointPlane& plane, Eigen::Vector3d normal, const Points& points) {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& p : points) {
        middle += p / static_cast<double>(points.size());
    }
    double extent = 1.0;
    for (const Eigen::Vector3d& p : points) {
        extent = std::max(extent, (p - middle).norm());
    }
    const Eigen::Vector3d viewer = middle - 10.0 * extent * Eigen::Vector3d::UnitZ();
    if (normal.dot(plane.origin_mm - viewer) < 0.0) {
        normal = -normal;
    }
    const Eigen::Vector3d y = Eigen::Vector3d::UnitY() - normal.y() * normal;
    const Eigen::Vector3d z = Eigen::Vector3d::UnitZ() - normal.z() * normal;
    // On a level plane the near side is below, as the viewer sees it.
    plane.down =
        y.norm() > 0.1 ? Eigen::Vector3d(y.normalized()) : Eigen::Vector3d(-z.normalized());
    plane.across = plane.down.cross(normal);
}

}  // namespace

std::vector<PointPlane> planes_of(const Points& points_mm) {
    std::vector<PointPlane> planes;
    std::vector<int> left(points_mm.size());
    for (std::size_t i = 0; i < left.size(); ++i) {
        left[i] = static_cast<int>(i);
    }
    while (!left.empty()) {
        Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
        PointPlane plane = fullest_plane(points_mm, left, normal);
        if (plane.points.size() < least_points || planes.size() == most_planes) {
            return {};
        }
        set_axes(plane, normal, points_mm);
        std::erase_if(left, [&](int i) {
            return std::binary_search(plane.points.begin(), plane.points.end(), i);
        });
        planes.push_back(std::move(plane));
    }
    return planes;
}

}  // namespace kambara
