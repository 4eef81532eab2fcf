// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/sliding_mean.h"

#include <algorithm>
#include <numeric>

namespace kambara {

SlidingMean sliding_mean(const std::vector<Eigen::Vector2d>& centroids, std::size_t wanted) {
    SlidingMean result;
    result.kept.resize(centroids.size());
    std::iota(result.kept.begin(), result.kept.end(), std::size_t{0});
    while (!result.kept.empty()) {
        Eigen::Vector2d mean = Eigen::Vector2d::Zero();
        for (const std::size_t i : result.kept) {
            mean += centroids[i] / static_cast<double>(result.kept.size());
        }
        result.path.push_back(mean);
        const auto farthest = std::max_element(
            result.kept.begin(), result.kept.end(), [&](std::size_t a, std::size_t b) {
                return (centroids[a] - mean).squaredNorm() < (centroids[b] - mean).squaredNorm();
            });
        if (result.kept.size() <= wanted) {
            result.forbidden_radius_px = (centroids[*farthest] - mean).norm();
            break;
        }
        result.kept.erase(farthest);
    }
    return result;
}

}  // namespace kambara
