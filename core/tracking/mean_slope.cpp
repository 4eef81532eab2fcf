// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/mean_slope.h"

#include <Eigen/LU>

namespace kambara {
namespace {

constexpr double by_chance = 13.8;

}  // namespace

bool leans_otherwise(const Eigen::Vector2d& slope, const Eigen::Vector2d& other,
                     const Eigen::Matrix2d& covariance) {
    const Eigen::Vector2d apart = slope - other;
    return apart.dot(covariance.inverse() * apart) > by_chance;
}

void MeanSlope::add(const Eigen::Vector2d& slope, const Eigen::Matrix2d& covariance) {
    if (count_ > 0) {
        const Eigen::Matrix2d of_mean = information_.inverse();
        if (leans_otherwise(slope, of_mean * weighted_, covariance + of_mean)) {
            return;
        }
    }
    const Eigen::Matrix2d weight = covariance.inverse();
    information_ += weight;
    weighted_ += weight * slope;
    ++count_;
}

std::optional<Eigen::Vector2d> MeanSlope::value() const {
    if (count_ == 0) {
        return std::nullopt;
    }
    const Eigen::Matrix2d covariance = information_.inverse();
    const Eigen::Vector2d mean = covariance * weighted_;
    return leans_otherwise(mean, Eigen::Vector2d::Zero(), covariance) ? std::optional(mean)
                                                                      : std::nullopt;
}

}  // namespace kambara
