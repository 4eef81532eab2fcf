// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/point_sorting.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace kambara {
namespace {

// The smaller, the more top left.
double rank(const Eigen::Vector2d& p, TopLeftRule rule, int height_px) {
    switch (rule) {
        case TopLeftRule::max_theta:
            return -std::atan2(height_px - p.y(), p.x());
        case TopLeftRule::topleft_bottomright:
            return p.x() + p.y();
        case TopLeftRule::bottomleft_topright:
            break;
    }
    return p.x();
}

}  // namespace

std::vector<std::size_t> sort_points(const std::vector<Eigen::Vector2d>& points, TopLeftRule rule,
                                     int height_px, double half_angle_rad) {
    std::vector<std::size_t> left(points.size());
    std::iota(left.begin(), left.end(), std::size_t{0});
    std::vector<std::size_t> sorted;
    while (!left.empty()) {
        auto next = std::min_element(left.begin(), left.end(), [&](std::size_t a, std::size_t b) {
            return rank(points[a], rule, height_px) < rank(points[b], rule, height_px);
        });
        while (next != left.end()) {
            const Eigen::Vector2d& here = points[*next];
            sorted.push_back(*next);
            left.erase(next);
            next = left.end();
            double nearest = 1e300;
            for (auto i = left.begin(); i != left.end(); ++i) {
                const Eigen::Vector2d step = points[*i] - here;
                if (std::abs(std::atan2(step.y(), step.x())) <= half_angle_rad &&
                    step.norm() < nearest) {
                    nearest = step.norm();
                    next = i;
                }
            }
        }
    }
    return sorted;
}

}  // namespace kambara
