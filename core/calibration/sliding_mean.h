// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

namespace kambara {

/// How outliers among boxes' centroids were rejected in 1999, kept to compare with: take the mean
/// of all, drop the farthest, and again, until `wanted` are left. It fails where an outlier lies
/// nearer to the mean than a true box does (the "forbidden region"), and where a box is missing.
struct SlidingMean {
    std::vector<std::size_t> kept;      ///< numbers of the centroids left, ascending
    std::vector<Eigen::Vector2d> path;  ///< the mean at every step, first to last
    double forbidden_radius_px = 0.0;   ///< from the last mean to the farthest one kept
};
SlidingMean sliding_mean(const std::vector<Eigen::Vector2d>& centroids, std::size_t wanted);

}  // namespace kambara
