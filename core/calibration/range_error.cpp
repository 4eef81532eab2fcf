// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/range_error.h"

#include <Eigen/Dense>
#include <cmath>
#include <optional>

#include "core/base/angles.h"

namespace kambara {
namespace {

// Where left and right see a point of the left camera's frame; empty where one can't.
std::optional<Eigen::Vector4d> seen(const BundleCamera& left, const BundleCamera& right,
                                    const Eigen::Vector3d& point_in_left_mm) {
    const auto l = project(lens_of(left.lens, left.model, left.sensor), point_in_left_mm);
    const auto r = project(lens_of(right.lens, right.model, right.sensor),
                           transform_of(right.camera_from_first) * point_in_left_mm);
    if (!l || !r) {
        return std::nullopt;
    }
    return Eigen::Vector4d(l->x(), l->y(), r->x(), r->y());
}

double& parameter(BundleCamera& camera, int i) {
    return i < 12 ? camera.lens[static_cast<std::size_t>(i)]
                  : camera.camera_from_first[static_cast<std::size_t>(i - 12)];
}

using Derivatives = Eigen::Matrix<double, 4, Eigen::Dynamic>;

// By both cameras' parameters; zeros where one is held fixed.
std::optional<Derivatives> by_parameters(const Bundle& bundle, const Eigen::MatrixXd& covariance,
                                         const Eigen::Vector3d& at) {
    Derivatives result = Derivatives::Zero(4, 2 * camera_parameters);
    for (int i = 0; i < 2 * camera_parameters; ++i) {
        const double sigma = std::sqrt(std::max(0.0, covariance(i, i)));
        if (sigma == 0.0) {
            continue;
        }
        std::array<BundleCamera, 2> low{bundle.cameras[0], bundle.cameras[1]};
        std::array<BundleCamera, 2> high = low;
        const auto camera = static_cast<std::size_t>(i / camera_parameters);
        const double step = 0.1 * sigma;
        parameter(low[camera], i % camera_parameters) -= step;
        parameter(high[camera], i % camera_parameters) += step;
        const auto before = seen(low[0], low[1], at);
        const auto after = seen(high[0], high[1], at);
        if (!before || !after) {
            return std::nullopt;
        }
        result.col(i) = (*after - *before) / (2.0 * step);
    }
    return result;
}

std::optional<Eigen::Matrix<double, 4, 3>> by_point(const Bundle& bundle,
                                                    const Eigen::Vector3d& at) {
    Eigen::Matrix<double, 4, 3> result;
    const double step = 1e-4 * at.norm();
    for (int i = 0; i < 3; ++i) {
        const Eigen::Vector3d d = step * Eigen::Vector3d::Unit(i);
        const auto before = seen(bundle.cameras[0], bundle.cameras[1], at - d);
        const auto after = seen(bundle.cameras[0], bundle.cameras[1], at + d);
        if (!before || !after) {
            return std::nullopt;
        }
        result.col(i) = (*after - *before) / (2.0 * step);
    }
    return result;
}

}  // namespace

std::vector<RangeErrorPoint> range_error_map(const Bundle& bundle,
                                             const Eigen::MatrixXd& covariance,
                                             const RigidTransform& T_left_from_rig,
                                             const Eigen::Vector2i& size_px,
                                             const RangeErrorOptions& options) {
    std::vector<RangeErrorPoint> map;
    constexpr int both = 2 * camera_parameters;
    const Eigen::Vector3d right_in_left =
        transform_of(bundle.cameras[1].camera_from_first).centre_mm();
    const Eigen::Vector3d middle_in_rig = 0.5 * (T_left_from_rig.inverse() * right_in_left);
    for (int azimuth = -2; azimuth <= 2; ++azimuth) {
        for (int height = -1; height <= 1; ++height) {
            for (int depth = 0; depth < 5; ++depth) {
                RangeErrorPoint place;
                place.azimuth_deg = 0.5 * azimuth * options.azimuth_deg;
                place.height_mm = height * options.height_mm;
                place.depth_mm =
                    options.nearest_mm + 0.25 * depth * (options.farthest_mm - options.nearest_mm);
                const double x = place.depth_mm * std::tan(rad_from_deg(place.azimuth_deg));
                const Eigen::Vector3d at =
                    T_left_from_rig *
                    (middle_in_rig + Eigen::Vector3d(x, place.height_mm, place.depth_mm));
                const auto pixels = seen(bundle.cameras[0], bundle.cameras[1], at);
                if (!pixels || pixels->minCoeff() < 0.0 ||
                    std::max((*pixels)[0], (*pixels)[2]) > size_px.x() - 1 ||
                    std::max((*pixels)[1], (*pixels)[3]) > size_px.y() - 1) {
                    continue;
                }
                const auto A = by_point(bundle, at);
                const auto B = by_parameters(bundle, covariance, at);
                if (!A || !B) {
                    continue;
                }
                const Eigen::Matrix3d inverse = (A->transpose() * *A).inverse();
                place.point_in_left_mm = at;
                place.range_mm = at.norm();
                const Eigen::RowVector4d range_by_pixel =
                    at.normalized().transpose() * inverse * A->transpose();
                const Eigen::RowVectorXd range_by_parameter = range_by_pixel * *B;
                const double from_calibration =
                    (range_by_parameter * covariance.topLeftCorner(both, both) *
                     range_by_parameter.transpose())
                        .value();
                const double from_noise =
                    std::pow(options.noise_px, 2) * range_by_pixel.squaredNorm();
                place.sigma_calibration_mm = std::sqrt(std::max(0.0, from_calibration));
                place.sigma_total_mm = std::sqrt(std::max(0.0, from_calibration) + from_noise);
                map.push_back(place);
            }
        }
    }
    return map;
}

}  // namespace kambara
