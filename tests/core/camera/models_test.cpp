// SPDX-License-Identifier: GPL-3.0-or-later
// Each lens model against another derivation of itself.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <opencv2/calib3d.hpp>

#include "core/camera/lens.h"
#include "core/camera/lens_functions.h"
#include "core/camera/nominal_rig.h"
#include "tests/core/camera/lens_samples.h"

namespace kambara {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

TEST(TsaiLens, FollowsTheEquationsFromTheDistortedPoint) {
    for (const double kappa : {0.037709, 0.0, -0.02}) {
        TsaiLens lens = std::get<TsaiLens>(nominal_rig().left.lens);
        lens.kappa1_per_mm2 = kappa;
        for (const auto& [x_d, y_d] : {std::pair(0.0, 0.0), std::pair(1.2, -0.7),
                                       std::pair(-2.4, 1.7), std::pair(0.001, 2.0)}) {
            const double stretch = 1.0 + kappa * (x_d * x_d + y_d * y_d);
            const Vector3d point =
                Vector3d(x_d * stretch / lens.f_mm, y_d * stretch / lens.f_mm, 1.0) * 1234.5;
            const double X_f = 1.030092 * x_d * 640 / (0.00635 * 768) + 337.80;
            const double Y_f = y_d / 0.0074 + 240.50;
            const auto pixel = project(lens, point);
            ASSERT_TRUE(pixel);
            EXPECT_LT((*pixel - Vector2d(X_f, Y_f)).norm(), 1e-10);
            EXPECT_LT((unproject(lens, {X_f, Y_f})->direction - point.normalized()).norm(), 1e-14);
        }
    }
}

TEST(TsaiLens, TheCubicIsSolvedToMachinePrecision) {
    for (const double kappa : {1e3, 1.0, 0.03, 1e-7, 1e-15, -1e-15, -1e-7, -0.03, -1.0}) {
        // Up to far outside any picture for barrel lenses, to the turning point for the others.
        const double last = kappa > 0.0 ? 1e4 : 1.0 / std::sqrt(-3.0 * kappa);
        for (double part = 1e-6; part < 1.0; part = 1.3 * part + 1e-3) {
            const double r = part * std::min(last, 1e4);
            const double r_u = r * (1.0 + kappa * r * r);
            const double found = std::sqrt(tsai_squared_distorted_radius(kappa, r_u * r_u));
            // What the root must fulfil, as far as rounding of r_u lets it.
            EXPECT_NEAR(found * (1.0 + kappa * found * found), r_u, 1e-15 * 4.0 * r_u)
                << "kappa " << kappa << ", r " << r;
        }
    }
}

TEST(TsaiLens, PincushionProjectsNothingBeyondTheTurningPoint) {
    TsaiLens lens = std::get<TsaiLens>(nominal_rig().left.lens);
    lens.kappa1_per_mm2 = -0.02;
    const double most_r_u = 2.0 / (3.0 * std::sqrt(0.06));
    const auto at = [&](double r_u) { return Vector3d(60.0 * r_u, 80.0 * r_u, 100.0 * lens.f_mm); };
    EXPECT_TRUE(project(lens, at(most_r_u * (1.0 - 1e-9))));
    EXPECT_FALSE(project(lens, at(most_r_u * (1.0 + 1e-9))));
    EXPECT_FALSE(project(lens, at(100.0 * most_r_u)));
    // And no ray reaches the pixels beyond its image, of radius 1 / sqrt(-3 kappa1).
    const double most_y_px = 1.0 / std::sqrt(0.06) / 0.0074;
    EXPECT_TRUE(unproject(lens, {337.80, 240.50 + most_y_px - 0.01}));
    EXPECT_FALSE(unproject(lens, {337.80, 240.50 + most_y_px + 0.01}));
}

TEST(BrownLens, AgreesWithOpenCv) {
    for (const Lens& lens : lens_samples(20)) {
        const auto* brown = std::get_if<BrownLens>(&lens);
        if (!brown) {
            continue;
        }
        std::vector<cv::Point3d> points;
        for (const Vector2d& at : picture_grid(1201, 901, 12)) {
            points.emplace_back(at.x() - 600.0, at.y() - 450.0, 1000.0);
        }
        const cv::Mat K = (cv::Mat_<double>(3, 3) << brown->fx_px(), 0, brown->cx_px(), 0,
                           brown->fy_px(), brown->cy_px(), 0, 0, 1);
        std::vector<cv::Point2d> theirs;
        cv::projectPoints(points, cv::Vec3d(), cv::Vec3d(), K, brown->distortion(), theirs);
        int compared = 0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (const auto ours = project(lens, {points[i].x, points[i].y, points[i].z})) {
                EXPECT_LT((*ours - Vector2d(theirs[i].x, theirs[i].y)).norm(), 1e-9);
                ++compared;
            }
        }
        EXPECT_GT(compared, 100);
    }
}

TEST(BrownLens, RefusesWhatLiesBeyondTheFold) {
    // r (1 - 0.4 r^2) turns back at r = 1 / sqrt(1.2), where it reaches 2/3 of that.
    const BrownLens lens(500, 500, 320, 240, {-0.4, 0, 0, 0, 0});
    const double fold = 1.0 / std::sqrt(1.2);
    EXPECT_NEAR(lens.max_radius(), fold, 1e-5);
    EXPECT_TRUE(project(lens, {0.999 * fold, 0, 1}));
    EXPECT_FALSE(project(lens, {1.001 * fold, 0, 1}));
    const double reached_px = 320 + 500 * fold * 2.0 / 3.0;
    EXPECT_TRUE(unproject(lens, {reached_px - 0.1, 240}));
    EXPECT_FALSE(unproject(lens, {reached_px + 0.1, 240}));
}

TEST(BrownLens, IsUndoneWhereNewtonsMethodAloneGoesAstray) {
    // A pole ahead, and a stretch in which the distorted radius hardly grows.
    const BrownLens pole(500, 500, 320, 240,
                         {0.3199, 0.2319, 0, 0, 0.1029, -0.2652, -0.1693, -0.0367});
    const BrownLens flat(500, 500, 320, 240,
                         {0.4784, 0.4634, 0, 0, 0.1740, 0.0707, 0.0523, 0.0827});
    for (const BrownLens& lens : {pole, flat}) {
        const double last = std::min(lens.max_radius(), 3.0);
        for (double part = 0.01; part < 0.995; part += 0.01) {
            const Vector3d direction = Vector3d(0.6 * part * last, -0.8 * part * last, 1.0);
            const auto pixel = project(lens, direction);
            ASSERT_TRUE(pixel);
            const auto ray = unproject(lens, *pixel);
            ASSERT_TRUE(ray) << part;
            EXPECT_LT((ray->direction - direction.normalized()).norm(), 1e-10) << part;
        }
    }
}

TEST(BrownLens, KnowsHowManyTermsItHas) {
    EXPECT_EQ(BrownLens(1, 1, 0, 0, {0.1}).distortion(), (std::vector<double>{0.1, 0, 0, 0, 0}));
    EXPECT_EQ(BrownLens(1, 1, 0, 0, {1, 2, 3, 4, 5, 6, 7, 8}).terms(), 8);
    EXPECT_THROW(BrownLens(1, 1, 0, 0, std::vector<double>(9)), std::invalid_argument);
}

}  // namespace
}  // namespace kambara
