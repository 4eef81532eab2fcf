// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/stereo/position.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <cmath>
#include <cstdio>

#include "core/camera/rig_parameters.h"
#include "core/stereo/epipolar_offset.h"
#include "core/stereo/least_reprojection.h"
#include "core/stereo/midpoint.h"
#include "core/stereo/parallel_range.h"
#include "core/stereo/ray_pair.h"
#include "core/stereo/sine_rule.h"

namespace kambara {
namespace {

constexpr double step_px = 1e-3;  // of derivatives by a pixel

using PointByPixels = Eigen::Matrix<double, 3, 4>;

bool is_covariance(const Eigen::Matrix4d& m) {
    return m.allFinite() && m.diagonal().minCoeff() > 0.0 && m.llt().info() == Eigen::Success;
}

Error unrelated(double residual_px, double most_px) {
    char text[160];
    std::snprintf(text, sizeof text,
                  "The two pixels belong to no common point: the best one is seen %.2f px beside "
                  "one of them (at most %.2f px are allowed).",
                  residual_px, most_px);
    return {text, "Check that both pixels show the same point and that the rig has not moved."};
}

// By a method of 1999, in the left camera's frame: a function of the pixels alone.
Result<Eigen::Vector3d> reference_point(const Rig& rig, const Eigen::Vector4d& pixels,
                                        const PositionOptions& options) {
    const Eigen::Vector2d left = pixels.head<2>();
    const Eigen::Vector2d right = pixels.tail<2>();
    if (options.method == PositionMethod::parallel) {
        return parallel_from_pair(rig, left, right);
    }
    if (options.method == PositionMethod::midpoint) {
        return midpoint_from_pair(rig, left, right, options);
    }
    const auto both = sine_rule_from_pair(rig, left, right, options);
    return both ? Result<Eigen::Vector3d>(both->mean_mm()) : both.error();
}

Result<PointByPixels> reference_by_pixels(const Rig& rig, const Eigen::Vector4d& pixels,
                                          const PositionOptions& options) {
    PointByPixels result;
    for (int i = 0; i < 4; ++i) {
        const Eigen::Vector4d step = step_px * Eigen::Vector4d::Unit(i);
        const auto low = reference_point(rig, pixels - step, options);
        const auto high = reference_point(rig, pixels + step, options);
        if (!low || !high) {
            return !low ? low.error() : high.error();
        }
        result.col(i) = (*high - *low) / (2.0 * step_px);
    }
    return result;
}

}  // namespace

Result<Position> position_from_pair(const Rig& rig, const PairMeasurement& pair,
                                    const PositionOptions& options) {
    const auto rays = ray_pair(rig, pair.left_px, pair.right_px, options.min_parallax_rad);
    if (!rays) {
        return rays.error();
    }
    if (!is_covariance(pair.covariance_px2)) {
        return Error{"A pixel's covariance is not positive definite.",
                     "Give each pixel an uncertainty above zero."};
    }
    const RigidTransform& T_left_from_rig = rig.left.T_camera_from_rig;
    Eigen::Vector3d in_rig_mm;
    PointByPixels by_pixels;
    if (options.method == PositionMethod::reprojection) {
        const auto point = least_reprojection(rig, pair, rays->meeting.midpoint_mm);
        if (!point) {
            return point.error();
        }
        in_rig_mm = *point;
    } else {
        Eigen::Vector4d pixels;
        pixels << pair.left_px, pair.right_px;
        const auto point = reference_point(rig, pixels, options);
        if (!point) {
            return point.error();
        }
        const auto derivative = reference_by_pixels(rig, pixels, options);
        if (!derivative) {
            return derivative.error();
        }
        in_rig_mm = T_left_from_rig.inverse() * *point;
        by_pixels = *derivative;
    }
    const auto residual = pair_residual(rig, pair, in_rig_mm);
    if (!residual) {
        return Error{"The point would lie outside a camera's field.",
                     "Check the two pixels and the rig file."};
    }
    if (residual->largest_px() > options.max_residual_px) {
        return unrelated(residual->largest_px(), options.max_residual_px);
    }
    if (options.method == PositionMethod::reprojection) {
        const Eigen::Matrix4d weight = pair.covariance_px2.inverse();
        const Eigen::Matrix<double, 3, 4> weighted = residual->pixels_by_point.transpose() * weight;
        by_pixels = T_left_from_rig.R * (weighted * residual->pixels_by_point).inverse() * weighted;
    }
    Position result;
    result.method = options.method;
    result.point_in_left_mm = T_left_from_rig * in_rig_mm;
    result.covariance_mm2 = by_pixels * pair.covariance_px2 * by_pixels.transpose();
    result.residual_px = residual->largest_px();
    result.parallax_rad = rays->meeting.angle_rad;
    // The point answers to a change of the rig as to pixels changed the other way.
    const auto by_rig = rig.parameter_covariance
                            ? pixels_by_parameters(rig, result.point_in_left_mm)
                            : std::nullopt;
    std::optional<Eigen::Matrix4d> of_calibration_px2;
    if (by_rig) {
        of_calibration_px2 = *by_rig * *rig.parameter_covariance * by_rig->transpose();
        result.calibration_covariance_mm2 = by_pixels * *of_calibration_px2 * by_pixels.transpose();
    }
    result.epipolar =
        epipolar_offset(rig, pair, result.point_in_left_mm.norm(), of_calibration_px2);
    return result;
}

Result<Position> position_from_pair(const Rig& rig, const PixelMeasurement& left,
                                    const PixelMeasurement& right, const PositionOptions& options) {
    PairMeasurement pair{left.pixel, right.pixel, Eigen::Matrix4d::Zero()};
    pair.covariance_px2.topLeftCorner<2, 2>() = left.covariance_px2;
    pair.covariance_px2.bottomRightCorner<2, 2>() = right.covariance_px2;
    return position_from_pair(rig, pair, options);
}

}  // namespace kambara
