// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/stereo/least_reprojection.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>

namespace kambara {
namespace {

constexpr int most_steps = 30;
// A step is the last when it promises less than this of the sum of squares (in sigmas squared).
constexpr double enough = 1e-9;

}  // namespace

double PairResidual::largest_px() const {
    return std::max(rest.head<2>().norm(), rest.tail<2>().norm());
}

std::optional<PairResidual> pair_residual(const Rig& rig, const PairMeasurement& pair,
                                          const Eigen::Vector3d& point_in_rig_mm) {
    Eigen::Matrix<double, 2, 3> left_by_point;
    Eigen::Matrix<double, 2, 3> right_by_point;
    const auto left = rig.left.project(point_in_rig_mm, left_by_point);
    const auto right = rig.right->project(point_in_rig_mm, right_by_point);
    if (!left || !right) {
        return std::nullopt;
    }
    PairResidual residual;
    residual.rest << pair.left_px - *left, pair.right_px - *right;
    residual.pixels_by_point << left_by_point, right_by_point;
    return residual;
}

Result<Eigen::Vector3d> least_reprojection(const Rig& rig, const PairMeasurement& pair,
                                           const Eigen::Vector3d& start_in_rig_mm) {
    const Eigen::Matrix4d weight = pair.covariance_px2.inverse();
    const auto cost_of = [&](const PairResidual& at) { return at.rest.dot(weight * at.rest); };
    Eigen::Vector3d point = start_in_rig_mm;
    auto now = pair_residual(rig, pair, point);
    if (!now) {
        return Error{"The point would lie outside a camera's field.",
                     "Check the two pixels and the rig file."};
    }
    double damping = 0.0;
    for (int step = 0; step < most_steps; ++step) {
        const Eigen::Matrix<double, 3, 4> weighted = now->pixels_by_point.transpose() * weight;
        const Eigen::Vector3d downhill = weighted * now->rest;
        Eigen::Matrix3d damped = weighted * now->pixels_by_point;
        damped.diagonal() *= 1.0 + damping;
        const Eigen::Vector3d move = damped.llt().solve(downhill);
        if (!move.allFinite()) {
            return Error{"The two pixels do not determine a point.",
                         "Check the two pixels and the rig file."};
        }
        const double promised = move.dot(downhill);
        const auto next = pair_residual(rig, pair, point + move);
        // Rounding may raise a cost that is already as good as zero.
        if (next && cost_of(*next) <= cost_of(*now) + enough) {
            point += move;
            now = next;
            damping *= 0.1;
        } else {
            damping = std::max(10.0 * damping, 1e-3);
        }
        if (promised < enough && damping < 1.0) {
            break;
        }
    }
    return point;
}

}  // namespace kambara
