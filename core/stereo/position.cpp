// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/stereo/position.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cstdio>
#include <optional>

#include "core/stereo/ray_pair.h"

namespace kambara {
namespace {

constexpr int most_steps = 30;
// A step is the last when it promises less than this of the sum of squares (in sigmas squared).
constexpr double enough = 1e-9;

// A camera's measurement, weighted by the inverse of its covariance.
struct Observed {
    const Camera& camera;
    const Eigen::Vector2d& pixel;
    Eigen::Matrix2d weight;
};

// The least-squares problem, linearised at a point of the rig's frame.
struct Linearised {
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
    Eigen::Vector3d gradient = Eigen::Vector3d::Zero();  // downhill, half of it
    double cost = 0.0;
    double residual_px = 0.0;

    bool add(const Observed& seen, const Eigen::Vector3d& point_in_rig_mm) {
        Eigen::Matrix<double, 2, 3> J;
        const auto pixel = seen.camera.project(point_in_rig_mm, J);
        if (!pixel) {
            return false;
        }
        const Eigen::Vector2d rest = seen.pixel - *pixel;
        const Eigen::Matrix<double, 3, 2> weighted = J.transpose() * seen.weight;
        information += weighted * J;
        gradient += weighted * rest;
        cost += rest.dot(seen.weight * rest);
        residual_px = std::max(residual_px, rest.norm());
        return true;
    }
};

std::optional<Linearised> linearised(const Observed& left, const Observed& right,
                                     const Eigen::Vector3d& point_in_rig_mm) {
    Linearised sum;
    if (!sum.add(left, point_in_rig_mm) || !sum.add(right, point_in_rig_mm)) {
        return std::nullopt;
    }
    return sum;
}

bool is_covariance(const Eigen::Matrix2d& m) {
    return m.allFinite() && m(0, 0) > 0.0 && m.determinant() > 0.0;
}

Error unrelated(double residual_px, double most_px) {
    char text[160];
    std::snprintf(text, sizeof text,
                  "The two pixels belong to no common point: the best one is seen %.2f px beside "
                  "one of them (at most %.2f px are allowed).",
                  residual_px, most_px);
    return {text, "Check that both pixels show the same point and that the rig has not moved."};
}

}  // namespace

Result<Position> position_from_pair(const Rig& rig, const PixelMeasurement& left,
                                    const PixelMeasurement& right, const PositionOptions& options) {
    const auto rays = ray_pair(rig, left.pixel, right.pixel, options.min_parallax_rad);
    if (!rays) {
        return rays.error();
    }
    if (!is_covariance(left.covariance_px2) || !is_covariance(right.covariance_px2)) {
        return Error{"A pixel's covariance is not positive definite.",
                     "Give each pixel an uncertainty above zero."};
    }
    const Observed in_left{rig.left, left.pixel, left.covariance_px2.inverse()};
    const Observed in_right{*rig.right, right.pixel, right.covariance_px2.inverse()};

    Eigen::Vector3d point = rays->meeting.midpoint_mm;
    auto now = linearised(in_left, in_right, point);
    if (!now) {
        return Error{"The point would lie outside a camera's field.",
                     "Check the two pixels and the rig file."};
    }
    double damping = 0.0;
    for (int step = 0; step < most_steps; ++step) {
        Eigen::Matrix3d damped = now->information;
        damped.diagonal() *= 1.0 + damping;
        const Eigen::Vector3d move = damped.llt().solve(now->gradient);
        if (!move.allFinite()) {
            return Error{"The two pixels do not determine a point.",
                         "Check the two pixels and the rig file."};
        }
        const double promised = move.dot(now->gradient);
        const auto next = linearised(in_left, in_right, point + move);
        // Rounding may raise a cost that is already as good as zero.
        if (next && next->cost <= now->cost + enough) {
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
    if (now->residual_px > options.max_residual_px) {
        return unrelated(now->residual_px, options.max_residual_px);
    }
    const RigidTransform& T_left_from_rig = rig.left.T_camera_from_rig;
    Position result;
    result.point_in_left_mm = T_left_from_rig * point;
    result.covariance_mm2 =
        T_left_from_rig.R * now->information.inverse() * T_left_from_rig.R.transpose();
    result.residual_px = now->residual_px;
    result.parallax_rad = rays->meeting.angle_rad;
    return result;
}

}  // namespace kambara
