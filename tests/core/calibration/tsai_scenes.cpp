// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/calibration/tsai_scenes.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "core/base/angles.h"
#include "core/calibration/target.h"
#include "core/camera/nominal_rig.h"

namespace kambara::testing_support {
namespace {

Eigen::Matrix3d turned(const Eigen::Vector3d& turn) {
    return turn.norm() > 0.0 ? Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix()
                             : Eigen::Matrix3d::Identity();
}

TsaiView moved(const TsaiView& view, const TsaiVector& by) {
    TsaiView result = view;
    result.T_camera_from_world.R = turned(by.head<3>()) * view.T_camera_from_world.R;
    result.T_camera_from_world.t_mm += by.segment<3>(tsai::t_x);
    result.lens.f_mm += by[tsai::f];
    result.lens.kappa1_per_mm2 += by[tsai::kappa1];
    result.lens.cx_px += by[tsai::c_x];
    result.lens.cy_px += by[tsai::c_y];
    result.lens.sx += by[tsai::s_x];
    return result;
}

Eigen::Vector3d any_direction(Random& random) {
    Eigen::Vector3d v;
    do {
        v = {uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1)};
    } while (v.norm() > 1.0 || v.norm() < 1e-3);
    return v.normalized();
}

bool in_picture(const Eigen::Vector2d& pixel, double width, double height) {
    return pixel.x() >= 0.0 && pixel.y() >= 0.0 && pixel.x() <= width - 1.0 &&
           pixel.y() <= height - 1.0;
}

}  // namespace

double uniform(Random& random, double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11U) * 0x1.0p-53;
}

TsaiScene any_scene(Random& random) {
    TsaiScene scene;
    TsaiLens& lens = scene.truth.lens;
    const double pitch_mm = uniform(random, 0.003, 0.02);
    lens.sensor = {pitch_mm, pitch_mm * uniform(random, 0.8, 1.6), 768, 640};
    const double half_width_mm = 320.0 * lens.sensor.dx_prime_mm();
    lens.f_mm = half_width_mm * uniform(random, 1.0, 4.0);
    // At the picture's corner, barrel up to 30 %, pincushion up to 12 %.
    const double corner2 = half_width_mm * half_width_mm + std::pow(240.0 * lens.sensor.dy_mm, 2);
    lens.kappa1_per_mm2 =
        (random() % 2 == 0 ? uniform(random, 0.01, 0.3) : -uniform(random, 0.01, 0.12)) / corner2;
    lens.cx_px = 320.0 + uniform(random, -20, 20);
    lens.cy_px = 240.0 + uniform(random, -20, 20);
    lens.sx = uniform(random, 0.95, 1.05);
    scene.options.sensor = lens.sensor;
    scene.options.cx_px = 320.0;
    scene.options.cy_px = 240.0;

    // Points between one and two distances before the camera, on pixels all over the picture.
    const double near_mm = uniform(random, 300.0, 3000.0);
    const RigidTransform T_camera_from_world{
        turned(uniform(random, 0.0, 3.0) * any_direction(random)),
        uniform(random, 0.0, 2.0 * near_mm) * any_direction(random)};
    scene.truth.T_camera_from_world = T_camera_from_world;
    const int count = 20 + static_cast<int>(random() % 41);
    while (static_cast<int>(scene.points.size()) < count) {
        const Eigen::Vector2d pixel(uniform(random, 0, 639), uniform(random, 0, 479));
        const auto ray = unproject(lens, pixel);
        if (!ray) {
            continue;
        }
        const double z = near_mm * uniform(random, 1.0, 2.0);
        const Eigen::Vector3d world = T_camera_from_world.inverse() *
                                      Eigen::Vector3d(ray->direction * z / ray->direction.z());
        // Seen again through the model, so that point and pixel agree to the last digit.
        scene.points.push_back({world, *project(lens, T_camera_from_world * world)});
    }
    return scene;
}

std::optional<TsaiScene> target_scene(Random& random, double distance_mm) {
    TsaiScene scene;
    scene.truth.lens = std::get<TsaiLens>(nominal_rig().left.lens);
    scene.options.sensor = scene.truth.lens.sensor;
    scene.options.cx_px = 319.5;
    scene.options.cy_px = 239.5;
    const auto corners = corners_in_target_mm(two_plane_24());
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& corner : corners) {
        mean += corner / static_cast<double>(corners.size());
    }
    // Facing the book: its spine away from the camera, both planes at 45 degrees.
    const auto angle = [&](double limit_deg) {
        return rad_from_deg(uniform(random, -limit_deg, limit_deg));
    };
    const Eigen::Matrix3d roll = turned({0.0, 0.0, angle(20.0)});
    const Eigen::Matrix3d R =
        roll * rotation_about_x(angle(25.0)) * rotation_about_y(rad_from_deg(-45.0) + angle(25.0));
    const Eigen::Vector3d aim(distance_mm * uniform(random, -0.2, 0.2),
                              distance_mm * uniform(random, -0.15, 0.15), distance_mm);
    scene.truth.T_camera_from_world = {R, aim - R * mean};
    for (const Eigen::Vector3d& corner : corners) {
        const auto pixel = project(scene.truth.lens, scene.truth.T_camera_from_world * corner);
        if (!pixel || !in_picture(*pixel, 640, 480)) {
            return std::nullopt;
        }
        scene.points.push_back({corner, *pixel});
    }
    return scene;
}

std::vector<SeenPoint> with_noise(std::vector<SeenPoint> points, double sigma_px, Random& random) {
    std::normal_distribution<double> noise(0.0, sigma_px);
    for (SeenPoint& point : points) {
        point.seen_px.x() += noise(random);
        point.seen_px.y() += noise(random);
    }
    return points;
}

TsaiVector cramer_rao_sigma(const TsaiScene& scene, double sigma_px) {
    const auto n = static_cast<Eigen::Index>(scene.points.size());
    TsaiVector steps;
    steps << 1e-5, 1e-5, 1e-5, 1e-2, 1e-2, 1e-2, 1e-5, 1e-6, 1e-2, 1e-2, 1e-5;
    Eigen::Matrix<double, Eigen::Dynamic, tsai_parameters> J(2 * n, tsai_parameters);
    for (int i = 0; i < tsai_parameters; ++i) {
        const TsaiVector step = steps[i] * TsaiVector::Unit(i);
        const auto ahead = residuals_px(moved(scene.truth, step), scene.points);
        const auto behind = residuals_px(moved(scene.truth, -step), scene.points);
        for (Eigen::Index k = 0; k < n; ++k) {
            const auto at = static_cast<std::size_t>(k);
            J.block<2, 1>(2 * k, i) = (ahead[at] - behind[at]) / (2.0 * steps[i]);
        }
    }
    const TsaiVector scale = J.colwise().norm().cwiseInverse();
    const Eigen::Matrix<double, Eigen::Dynamic, tsai_parameters> S = J * scale.asDiagonal();
    const TsaiMatrix inverse = (S.transpose() * S).inverse();
    return sigma_px * inverse.diagonal().cwiseSqrt().cwiseProduct(scale);
}

TsaiVector error_of(const TsaiView& estimate, const TsaiView& truth) {
    TsaiVector error;
    const Eigen::AngleAxisd turn(estimate.T_camera_from_world.R *
                                 truth.T_camera_from_world.R.transpose());
    error.head<3>() = turn.angle() * turn.axis();
    error.segment<3>(tsai::t_x) =
        estimate.T_camera_from_world.t_mm - truth.T_camera_from_world.t_mm;
    error[tsai::f] = estimate.lens.f_mm - truth.lens.f_mm;
    error[tsai::kappa1] = estimate.lens.kappa1_per_mm2 - truth.lens.kappa1_per_mm2;
    error[tsai::c_x] = estimate.lens.cx_px - truth.lens.cx_px;
    error[tsai::c_y] = estimate.lens.cy_px - truth.lens.cy_px;
    error[tsai::s_x] = estimate.lens.sx - truth.lens.sx;
    return error;
}

}  // namespace kambara::testing_support
