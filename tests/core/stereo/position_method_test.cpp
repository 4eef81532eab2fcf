// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/stereo/position_method.h"

#include <gtest/gtest.h>

#include "core/base/angles.h"
#include "core/stereo/position.h"
#include "tests/core/stereo/stereo_samples.h"

namespace kambara {
namespace {

// Two alike cameras side by side that look the same way.
Rig parallel_rig() {
    const Camera camera{
        BrownLens(390, 385, 330, 236, {-0.28, 0.09, 1e-3, -5e-4, -0.01}), 640, 480, {}};
    return rig_from_pair(camera, camera, {Eigen::Matrix3d::Identity(), {-450.0, 0.0, 0.0}});
}

const PositionMethod all_methods[] = {PositionMethod::reprojection, PositionMethod::sine,
                                      PositionMethod::midpoint, PositionMethod::parallel};

TEST(PositionMethod, HasNames) {
    for (const PositionMethod method : all_methods) {
        EXPECT_EQ(position_method_from(to_string(method)).value(), method);
    }
    EXPECT_FALSE(position_method_from("Sine"));
}

TEST(PositionMethod, ExactPixelsGiveTheExactPointByEachThatSuits) {
    std::vector<Rig> rigs = rig_samples();
    rigs.push_back(parallel_rig());
    int tried = 0;
    for (const Rig& rig : rigs) {
        for (const PositionMethod method : all_methods) {
            if (!check_position_method(rig, method)) {
                continue;
            }
            ++tried;
            PositionOptions options;
            options.method = method;
            for (const SeenPoint& point : seen_points(rig, 100)) {
                const auto found = position_from_pair(rig, PixelMeasurement{point.left_px},
                                                      PixelMeasurement{point.right_px}, options);
                ASSERT_TRUE(found) << to_string(method) << ": " << found.error().text();
                EXPECT_LT((found->point_in_left_mm - point.in_left_mm).norm(), 1e-5)
                    << to_string(method);
                EXPECT_EQ(found->method, method);
                EXPECT_LT(found->residual_px, 1e-6);
            }
        }
    }
    EXPECT_EQ(tried, 3 * 3 + 4);  // the parallel one suits the last rig alone
}

TEST(PositionMethod, ConvergingCamerasRefuseTheParallelOneInWords) {
    const auto refused = check_position_method(nominal_rig(), PositionMethod::parallel);
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().cause.find("6.00 degrees"), std::string::npos)
        << refused.error().cause;
    PositionOptions options;
    options.method = PositionMethod::parallel;
    const SeenPoint point = seen(nominal_rig(), {100, 50, 1500});
    EXPECT_FALSE(position_from_pair(nominal_rig(), PixelMeasurement{point.left_px},
                                    PixelMeasurement{point.right_px}, options));
    // Just beside the tolerance, on either side.
    for (const double turn_deg : {0.05, 0.2}) {
        Rig rig = parallel_rig();
        rig.right->T_camera_from_rig.R =
            rotation_about_y(rad_from_deg(turn_deg)) * rig.right->T_camera_from_rig.R;
        rig.right->T_camera_from_rig.t_mm =
            rotation_about_y(rad_from_deg(turn_deg)) * rig.right->T_camera_from_rig.t_mm;
        EXPECT_EQ(check_position_method(rig, PositionMethod::parallel).ok(), turn_deg < 0.1);
    }
    Rig alone = nominal_rig();
    alone.right.reset();
    EXPECT_FALSE(check_position_method(alone, PositionMethod::midpoint));
}

// The scatter of noisy measurements against the covariance that each method reports.
TEST(PositionMethod, EachReportsItsOwnScatter) {
    const Rig rig = parallel_rig();
    const SeenPoint point = seen(rig, {300, -150, 1800});
    for (const PositionMethod method : all_methods) {
        PositionOptions options;
        options.method = method;
        PixelNoise noise(0.2);
        const Eigen::Matrix2d covariance = 0.04 * Eigen::Matrix2d::Identity();
        Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
        Eigen::Matrix3d reported = Eigen::Matrix3d::Zero();
        constexpr int trials = 3000;
        for (int i = 0; i < trials; ++i) {
            const auto found = position_from_pair(
                rig, PixelMeasurement{point.left_px + noise.next(), covariance},
                PixelMeasurement{point.right_px + noise.next(), covariance}, options);
            ASSERT_TRUE(found) << found.error().text();
            const Eigen::Vector3d error = found->point_in_left_mm - point.in_left_mm;
            scatter += error * error.transpose() / trials;
            reported += found->covariance_mm2 / trials;
        }
        for (int k = 0; k < 3; ++k) {
            EXPECT_NEAR(std::sqrt(scatter(k, k) / reported(k, k)), 1.0, 0.06)
                << to_string(method) << " " << k;
        }
    }
}

}  // namespace
}  // namespace kambara
