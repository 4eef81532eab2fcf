// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/stereo/epipolar_offset.h"

#include <algorithm>
#include <cmath>

namespace kambara {
namespace {

constexpr double step_px = 1e-2;
constexpr double step_of_range = 1e-3;

std::optional<Eigen::Vector2d> in_right(const Rig& rig, const Eigen::Vector2d& left_px,
                                        double range_mm) {
    const auto ray = rig.left.unproject(left_px);
    return ray ? rig.right->project(ray->at(range_mm)) : std::nullopt;
}

}  // namespace

std::optional<Eigen::Matrix2d> right_by_left(const Rig& rig, const Eigen::Vector2d& left_px,
                                             double range_mm) {
    const auto here = in_right(rig, left_px, range_mm);
    const auto aside = in_right(rig, left_px + Eigen::Vector2d(step_px, 0.0), range_mm);
    const auto below = in_right(rig, left_px + Eigen::Vector2d(0.0, step_px), range_mm);
    if (!here || !aside || !below) {
        return std::nullopt;
    }
    Eigen::Matrix2d result;
    result << (*aside - *here) / step_px, (*below - *here) / step_px;
    return result;
}

EpipolarOffset epipolar_offset(const Rig& rig, const PairMeasurement& pair, double range_mm,
                               const std::optional<Eigen::Matrix4d>& of_calibration_px2) {
    const auto here = in_right(rig, pair.left_px, range_mm);
    const auto farther = in_right(rig, pair.left_px, (1.0 + step_of_range) * range_mm);
    const auto by_left = right_by_left(rig, pair.left_px, range_mm);
    if (!here || !farther || !by_left || (*farther - *here).norm() == 0.0) {
        return {};
    }
    const Eigen::Vector2d along = (*farther - *here).normalized();
    Eigen::Vector2d across(-along.y(), along.x());
    if (across.y() < 0.0 || (across.y() == 0.0 && across.x() < 0.0)) {
        across = -across;
    }
    Eigen::RowVector4d by_pixels;
    by_pixels << -across.transpose() * *by_left, across.transpose();
    const auto sigma = [&](const Eigen::Matrix4d& covariance) {
        return std::sqrt(std::max(0.0, (by_pixels * covariance * by_pixels.transpose()).value()));
    };
    EpipolarOffset result;
    result.offset_px = across.dot(pair.right_px - *here);
    result.noise_sigma_px = sigma(pair.covariance_px2);
    if (of_calibration_px2) {
        result.calibration_sigma_px = sigma(*of_calibration_px2);
    }
    return result;
}

}  // namespace kambara
