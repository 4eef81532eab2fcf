// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/point_checks.h"

#include <algorithm>
#include <numeric>
#include <string>
#include <tuple>

#include "core/calibration/point_layout.h"

namespace kambara {
namespace {

constexpr std::size_t least_points = 7;

std::string name_of(std::size_t i, const std::vector<int>& labels) {
    return labels.empty() ? "point " + std::to_string(i + 1) : "line " + std::to_string(labels[i]);
}

std::optional<Error> not_finite(const std::vector<SeenPoint>& points,
                                const std::vector<int>& labels) {
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!points[i].in_world_mm.allFinite() || !points[i].seen_px.allFinite()) {
            return Error{"A number of " + name_of(i, labels) + " is not finite.",
                         "Mend the number or leave the point out."};
        }
    }
    return std::nullopt;
}

std::optional<Error> given_twice(const std::vector<SeenPoint>& points,
                                 const std::vector<int>& labels) {
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), 0U);
    const auto place = [&](std::size_t i) {
        const Eigen::Vector3d& p = points[i].in_world_mm;
        return std::tuple(p.x(), p.y(), p.z(), i);
    };
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return place(a) < place(b); });
    for (std::size_t k = 1; k < order.size(); ++k) {
        const std::size_t a = order[k - 1];
        const std::size_t b = order[k];
        if (points[a].in_world_mm == points[b].in_world_mm) {
            return Error{"The same place is given twice, by " + name_of(a, labels) + " and " +
                             name_of(b, labels) + ".",
                         "Give each point once: duplicated points make the result look better "
                         "than it is."};
        }
    }
    return std::nullopt;
}

}  // namespace

std::optional<Error> fault_of(const std::vector<SeenPoint>& points, bool coplanar,
                              const std::vector<int>& labels) {
    if (points.size() < least_points) {
        return Error{"There are " + std::to_string(points.size()) + " points.",
                     "Tsai's method needs at least " + std::to_string(least_points) + "."};
    }
    if (auto fault = not_finite(points, labels)) {
        return fault;
    }
    if (auto fault = given_twice(points, labels)) {
        return fault;
    }
    const PointLayout layout = layout_of(points);
    if (layout.collinear()) {
        return Error{"The points are collinear: all on one line.",
                     "Give points that spread in all three directions."};
    }
    if (layout.coplanar() && !coplanar) {
        return Error{
            "The points are coplanar: all on one plane, which cannot tell s_x and the "
            "depth apart.",
            "Add points off the plane, or ask for the method for coplanar points, which "
            "takes s_x as known."};
    }
    if (!layout.coplanar() && coplanar) {
        return Error{"The points are not on one plane, as the method for coplanar points needs.",
                     "Ask for the method for points in space."};
    }
    return std::nullopt;
}

}  // namespace kambara
