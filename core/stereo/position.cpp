// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/stereo/position.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <string>

#include "core/geometry/triangulate.h"

namespace kambara {
namespace {

constexpr int most_steps = 20;

Error refused(const std::string& cause) {
    return {cause, "Check the two pixels and the rig file."};
}

// One camera's part of the normal equations.
struct Part {
    Eigen::Matrix3d information;
    Eigen::Vector3d gradient;
    Eigen::Vector2d residual_px;
};

std::optional<Part> part_of(const Camera& camera, const PixelMeasurement& measured,
                            const Eigen::Matrix2d& weight, const Eigen::Vector3d& point_in_rig_mm) {
    Eigen::Matrix<double, 2, 3> J;
    const auto pixel = camera.project(point_in_rig_mm, J);
    if (!pixel) {
        return std::nullopt;
    }
    const Eigen::Vector2d residual = measured.pixel - *pixel;
    return Part{J.transpose() * weight * J, J.transpose() * weight * residual, residual};
}

}  // namespace

Result<Position> position_from_pair(const Rig& rig, const PixelMeasurement& left,
                                    const PixelMeasurement& right, const PositionOptions& options) {
    const auto left_ray = rig.left.unproject(left.pixel);
    const auto right_ray = rig.right->unproject(right.pixel);
    if (!left_ray || !right_ray) {
        return refused(std::string("The ") + (left_ray ? "right" : "left") +
                       " pixel lies where its lens lets no ray through.");
    }
    const auto meeting = meeting_of(*left_ray, *right_ray);
    if (!meeting || meeting->angle_rad < options.min_parallax_rad) {
        return refused("The two rays are nearly parallel: the point is too far away to measure.");
    }
    if (meeting->distance_a_mm <= 0.0 || meeting->distance_b_mm <= 0.0) {
        return refused("The two rays meet behind a camera.");
    }
    const Eigen::Matrix2d left_weight = left.covariance_px2.inverse();
    const Eigen::Matrix2d right_weight = right.covariance_px2.inverse();
    Eigen::Vector3d point = meeting->midpoint_mm;
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
    Position result;
    for (int step = 0; step < most_steps; ++step) {
        const auto a = part_of(rig.left, left, left_weight, point);
        const auto b = part_of(*rig.right, right, right_weight, point);
        if (!a || !b) {
            return refused("The point would lie outside a camera's field.");
        }
        information = a->information + b->information;
        result.residual_px = std::max(a->residual_px.norm(), b->residual_px.norm());
        const Eigen::Vector3d move = information.ldlt().solve(a->gradient + b->gradient);
        if (!move.allFinite()) {
            return refused("The two pixels do not determine a point.");
        }
        point += move;
        if (move.norm() < 1e-10 * point.norm()) {
            break;
        }
    }
    if (result.residual_px > options.max_residual_px) {
        return refused("The two pixels belong to no common point: it would be seen " +
                       std::to_string(result.residual_px) + " px beside one of them (at most " +
                       std::to_string(options.max_residual_px) + " allowed).");
    }
    const RigidTransform& T_left_from_rig = rig.left.T_camera_from_rig;
    result.point_in_left_mm = T_left_from_rig * point;
    result.covariance_mm2 =
        T_left_from_rig.R * information.inverse() * T_left_from_rig.R.transpose();
    result.parallax_rad = meeting->angle_rad;
    return result;
}

}  // namespace kambara
