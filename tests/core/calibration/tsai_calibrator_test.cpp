// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/tsai_calibrator.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <cstdio>

#include "tests/core/calibration/tsai_scenes.h"

namespace kambara {
namespace {

using testing_support::any_scene;
using testing_support::cramer_rao_sigma;
using testing_support::error_of;
using testing_support::Random;
using testing_support::target_scene;
using testing_support::TsaiScene;
using testing_support::uniform;
using testing_support::with_noise;

// Lengths against the distance, pixels against the picture, everything else against itself.
TsaiVector scales_of(const TsaiView& truth) {
    TsaiVector scale = TsaiVector::Ones();
    scale.segment<3>(tsai::t_x).setConstant(truth.T_camera_from_world.t_mm.norm());
    scale[tsai::f] = truth.lens.f_mm;
    scale[tsai::kappa1] = std::abs(truth.lens.kappa1_per_mm2);
    scale[tsai::c_x] = truth.lens.cx_px;
    scale[tsai::c_y] = truth.lens.cy_px;
    scale[tsai::s_x] = truth.lens.sx;
    return scale;
}

double largest_relative_error(const TsaiReport& report, const TsaiScene& scene) {
    return error_of(report.view, scene.truth)
        .cwiseQuotient(scales_of(scene.truth))
        .cwiseAbs()
        .maxCoeff();
}

TEST(TsaiCalibrator, WithoutNoiseEveryParameterComesOutExactly) {
    Random random(7);
    double worst = 0.0;
    for (int run = 0; run < 1000; ++run) {
        const TsaiScene scene = any_scene(random);
        const auto report = calibrate_tsai(scene.points, scene.options);
        ASSERT_TRUE(report) << run << ": " << report.error().text();
        const double error = largest_relative_error(*report, scene);
        EXPECT_LE(error, 1e-8) << run;
        EXPECT_TRUE(report->outliers.empty()) << run;
        worst = std::max(worst, error);
    }
    std::printf("1000 cameras, largest relative error %.2g\n", worst);
}

// What the noisy views came to: errors against the bound, and how often the intervals held.
struct Tally {
    TsaiVector squares = TsaiVector::Zero();
    TsaiVector held = TsaiVector::Zero();
    int judged = 0;
    int beyond = 0;       // the bound for f is above the limit
    int beyond_told = 0;  // and the report says so
    int within_called_poor = 0;
};

Tally tally_of(int runs, double noise_px, double nearest_mm, double farthest_mm, Random& random) {
    Tally tally;
    while (tally.judged + tally.beyond < runs) {
        const auto scene = target_scene(random, uniform(random, nearest_mm, farthest_mm));
        if (!scene) {
            continue;
        }
        const auto report =
            calibrate_tsai(with_noise(scene->points, noise_px, random), scene->options);
        if (!report) {
            ADD_FAILURE() << report.error().text();
            return tally;
        }
        const TsaiVector bound = cramer_rao_sigma(*scene, noise_px);
        if (100.0 * bound[tsai::f] / scene->truth.lens.f_mm > 0.6) {
            ++tally.beyond;
            tally.beyond_told += report->poorly_determined ? 1 : 0;
            continue;
        }
        ++tally.judged;
        tally.within_called_poor += report->poorly_determined ? 1 : 0;
        const TsaiVector error = error_of(report->view, scene->truth);
        tally.squares += error.cwiseQuotient(bound).cwiseAbs2();
        tally.held +=
            (error.cwiseAbs().array() <= report->interval_95.array()).cast<double>().matrix();
    }
    return tally;
}

TEST(TsaiCalibrator, NoisyViewsReachTheCramerRaoBoundAndTheIntervalsHold) {
    Random random(11);
    const Tally tally = tally_of(500, 0.05, 700.0, 1500.0, random);
    const TsaiVector ratio = (tally.squares / tally.judged).cwiseSqrt();
    const TsaiVector share = tally.held / tally.judged;
    std::printf("%d views within the limit, %d of them called poor; %d beyond, %d told\n",
                tally.judged, tally.within_called_poor, tally.beyond, tally.beyond_told);
    for (int i = 0; i < tsai_parameters; ++i) {
        std::printf("parameter %2d: RMS error %.3f of the bound, 95 %% intervals hold in %.1f %%\n",
                    i, ratio[i], 100.0 * share[i]);
        EXPECT_LE(ratio[i], 1.1) << i;
        EXPECT_GE(share[i], 0.92) << i;
        EXPECT_LE(share[i], 0.98) << i;
    }
    EXPECT_LE(tally.within_called_poor, 25);
    EXPECT_EQ(tally.beyond_told, tally.beyond);
}

// Farther off and noisier, where the bound for f crosses the limit.
TEST(TsaiCalibrator, BeyondTheLimitTheCameraIsCalledPoorlyDetermined) {
    Random random(12);
    const Tally tally = tally_of(200, 0.1, 1100.0, 1800.0, random);
    std::printf("%d views within the limit, %d of them called poor; %d beyond, %d told\n",
                tally.judged, tally.within_called_poor, tally.beyond, tally.beyond_told);
    ASSERT_GE(tally.beyond, 50);
    EXPECT_GE(tally.beyond_told, 0.97 * tally.beyond);
}

// The scene's points, moved along their rays onto a plane that is tilted against the camera.
TsaiScene on_a_plane(TsaiScene scene, Random& random) {
    const RigidTransform& T = scene.truth.T_camera_from_world;
    const double z0 = (T * scene.points.front().in_world_mm).z();
    const Eigen::Vector3d normal(uniform(random, 0.4, 0.8), uniform(random, -0.4, 0.4), 1.0);
    for (SeenPoint& point : scene.points) {
        const auto ray = unproject(scene.truth.lens, point.seen_px);
        const Eigen::Vector3d in_camera =
            ray->direction * (z0 * normal.z() / normal.dot(ray->direction));
        point.in_world_mm = T.inverse() * in_camera;
        point.seen_px = *project(scene.truth.lens, T * point.in_world_mm);
    }
    scene.options.coplanar = true;
    scene.options.sx = scene.truth.lens.sx;
    return scene;
}

TEST(TsaiCalibrator, APlaneTellsAllButTheScaleFactor) {
    Random random(8);
    double worst = 0.0;
    for (int run = 0; run < 300; ++run) {
        const TsaiScene scene = on_a_plane(any_scene(random), random);
        const auto report = calibrate_tsai(scene.points, scene.options);
        ASSERT_TRUE(report) << run << ": " << report.error().text();
        const double error = largest_relative_error(*report, scene);
        EXPECT_LE(error, 1e-8) << run;
        EXPECT_EQ(report->sigma[tsai::s_x], 0.0);
        worst = std::max(worst, error);
    }
    std::printf("300 planes, largest relative error %.2g\n", worst);
}

TEST(TsaiCalibrator, TheBasicMethodKeepsTheCentreAndStatesNoIntervals) {
    Random random(9);
    for (int run = 0; run < 50; ++run) {
        TsaiScene scene = any_scene(random);
        scene.options.cx_px = scene.truth.lens.cx_px;
        scene.options.cy_px = scene.truth.lens.cy_px;
        scene.options.method = TsaiMethod::basic;
        const auto report = calibrate_tsai(scene.points, scene.options);
        ASSERT_TRUE(report) << run << ": " << report.error().text();
        EXPECT_EQ(report->view.lens.cx_px, scene.options.cx_px);
        EXPECT_EQ(report->view.lens.cy_px, scene.options.cy_px);
        EXPECT_FALSE(report->covariance);
        // With the right centre the linear stage is exact, whatever the distortion.
        EXPECT_LE(error_of(report->view, scene.truth)
                      .cwiseQuotient(scales_of(scene.truth))
                      .cwiseAbs()
                      .maxCoeff(),
                  1e-7)
            << run;
    }
}

// A world frame far from the points changes what T is, not what is found.
TEST(TsaiCalibrator, TheWorldsOriginMayBeAnywhere) {
    Random random(10);
    auto scene = target_scene(random, 1000.0);
    while (!scene) {
        scene = target_scene(random, 1000.0);
    }
    const auto points = with_noise(scene->points, 0.05, random);
    const auto here = calibrate_tsai(points, scene->options);
    auto moved = points;
    const Eigen::Vector3d far_mm(5e4, -2e5, 1e5);
    for (SeenPoint& point : moved) {
        point.in_world_mm += far_mm;
    }
    const auto there = calibrate_tsai(moved, scene->options);
    ASSERT_TRUE(here && there);
    EXPECT_NEAR(here->view.lens.f_mm, there->view.lens.f_mm, 1e-7);
    EXPECT_NEAR(here->sigma[tsai::f], there->sigma[tsai::f], 1e-7);
    EXPECT_NEAR(
        (here->view.T_camera_from_world.t_mm - (there->view.T_camera_from_world * far_mm)).norm(),
        0.0, 1e-3);
}

}  // namespace
}  // namespace kambara
