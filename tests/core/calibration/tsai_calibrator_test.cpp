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

TEST(TsaiCalibrator, WithoutNoiseEveryParameterComesOutExactly) {
    Random random(7);
    double worst = 0.0;
    for (int run = 0; run < 1000; ++run) {
        const TsaiScene scene = any_scene(random);
        const auto report = calibrate_tsai(scene.points, scene.options);
        ASSERT_TRUE(report) << run << ": " << report.error().text();
        const double error = error_of(report->view, scene.truth)
                                 .cwiseQuotient(scales_of(scene.truth))
                                 .cwiseAbs()
                                 .maxCoeff();
        EXPECT_LE(error, 1e-8) << run;
        EXPECT_TRUE(report->outliers.empty()) << run;
        worst = std::max(worst, error);
    }
    std::printf("1000 cameras, largest relative error %.2g\n", worst);
}

TEST(TsaiCalibrator, NoisyViewsReachTheCramerRaoBound) {
    constexpr int runs = 500;
    constexpr double noise_px = 0.05;
    Random random(11);
    TsaiVector squares = TsaiVector::Zero();
    TsaiVector held = TsaiVector::Zero();
    int judged = 0;
    int beyond = 0;
    int beyond_told = 0;
    int within_called_poor = 0;
    for (int run = 0; run < runs;) {
        const auto scene = target_scene(random, uniform(random, 700.0, 1500.0));
        if (!scene) {
            continue;
        }
        ++run;
        const auto points = with_noise(scene->points, noise_px, random);
        const auto report = calibrate_tsai(points, scene->options);
        ASSERT_TRUE(report) << run << ": " << report.error().text();
        const TsaiVector bound = cramer_rao_sigma(*scene, noise_px);
        const double f_percent = 100.0 * bound[tsai::f] / scene->truth.lens.f_mm;
        if (f_percent > 0.6) {
            ++beyond;
            beyond_told += report->poorly_determined ? 1 : 0;
            continue;
        }
        ++judged;
        within_called_poor += report->poorly_determined ? 1 : 0;
        const TsaiVector error = error_of(report->view, scene->truth);
        squares += error.cwiseQuotient(bound).cwiseAbs2();
        held += (error.cwiseAbs().array() <= report->interval_95.array()).cast<double>().matrix();
    }
    const TsaiVector ratio = (squares / judged).cwiseSqrt();
    const TsaiVector share = held / judged;
    std::printf("%d runs within the limit, %d beyond (%d told), %d within called poor\n", judged,
                beyond, beyond_told, within_called_poor);
    for (int i = 0; i < tsai_parameters; ++i) {
        std::printf("parameter %2d: RMS error %.3f of the bound, 95 %% intervals hold in %.1f %%\n",
                    i, ratio[i], 100.0 * share[i]);
        EXPECT_LE(ratio[i], 1.1) << i;
        EXPECT_GE(share[i], 0.92) << i;
        EXPECT_LE(share[i], 0.98) << i;
    }
    EXPECT_EQ(beyond_told, beyond);
}

}  // namespace
}  // namespace kambara
