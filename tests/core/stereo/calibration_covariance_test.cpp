// SPDX-License-Identifier: GPL-3.0-or-later
// What the rig's own covariance makes of a position, against rigs drawn from it.
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <random>

#include "core/camera/rig_parameters.h"
#include "core/stereo/position.h"
#include "tests/core/stereo/stereo_samples.h"
#include "tests/support/rig_covariance.h"

namespace kambara {
namespace {

// The rig whose parameters are off by so much, in a frame of its own.
Rig changed(const Rig& rig, const Eigen::VectorXd& by) {
    const Rig moved = with_parameters_moved(rig, by);
    return rig_from_pair(moved.left, *moved.right, T_right_from_left(moved));
}

TEST(CalibrationCovariance, IsKeptApartAndMatchesTheScatterOfRigsDrawnFromIt) {
    for (Rig rig : rig_samples()) {
        rig.parameter_covariance = testing_support::some_covariance(rig);
        ASSERT_EQ(covariance_fault(rig, *rig.parameter_covariance), "");
        const Eigen::MatrixXd L = rig.parameter_covariance->llt().matrixL();
        for (const Eigen::Vector3d& place :
             {Eigen::Vector3d(200, 50, 1000), {500, -200, 2000}, {-300, 300, 5000}}) {
            const SeenPoint point = seen(rig, place);
            const auto told = position_from_pair(rig, PixelMeasurement{point.left_px},
                                                 PixelMeasurement{point.right_px});
            ASSERT_TRUE(told && told->calibration_covariance_mm2);
            std::mt19937 random(8);
            std::normal_distribution<double> normal;
            double chi2 = 0.0;
            double epipolar = 0.0;
            constexpr int trials = 1500;
            for (int i = 0; i < trials; ++i) {
                const Rig other = changed(rig, L * Eigen::VectorXd::NullaryExpr(
                                                       L.rows(), [&] { return normal(random); }));
                const auto found =
                    position_from_pair(other, PixelMeasurement{point.left_px},
                                       PixelMeasurement{point.right_px}, {.max_residual_px = 20.0});
                ASSERT_TRUE(found) << found.error().text();
                EXPECT_FALSE(found->calibration_covariance_mm2);  // that rig doesn't tell
                const Eigen::Vector3d error = found->point_in_left_mm - point.in_left_mm;
                chi2 += error.dot(told->calibration_covariance_mm2->ldlt().solve(error)) / trials;
                epipolar += std::pow(found->epipolar.offset_px, 2) / trials;
            }
            EXPECT_NEAR(chi2, 3.0, 0.35) << place.transpose();
            EXPECT_NEAR(std::sqrt(epipolar) / told->epipolar.calibration_sigma_px.value(), 1.0,
                        0.08);
            EXPECT_NEAR(told->epipolar.offset_px, 0.0, 1e-6);
        }
    }
}

TEST(CalibrationCovariance, FollowsThePicturesSize) {
    Rig rig = nominal_rig();
    rig.parameter_covariance = testing_support::some_covariance(rig);
    const Rig half = scaled_to(rig, 320, 240);
    const SeenPoint point = seen(rig, {200, 50, 1500});
    const SeenPoint point_in_half = seen(half, {200, 50, 1500});
    const auto a =
        position_from_pair(rig, PixelMeasurement{point.left_px}, PixelMeasurement{point.right_px});
    const auto b = position_from_pair(half, PixelMeasurement{point_in_half.left_px},
                                      PixelMeasurement{point_in_half.right_px});
    EXPECT_LT((*a->calibration_covariance_mm2 - *b->calibration_covariance_mm2).norm(),
              1e-3 * a->calibration_covariance_mm2->norm());
}

}  // namespace
}  // namespace kambara
