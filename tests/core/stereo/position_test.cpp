// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/stereo/position.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <optional>
#include <string>

#include "core/stereo/midpoint.h"
#include "tests/core/stereo/stereo_samples.h"

namespace kambara {
namespace {

using Eigen::Matrix2d;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

std::string cause_of(const Result<Position>& position) {
    return position ? "a position" : position.error().cause;
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

TEST(Position, ExactPixelsGiveTheExactPoint) {
    for (const Rig& rig : rig_samples()) {
        for (const SeenPoint& point : seen_points(rig, 300)) {
            const auto position = position_from_pair(rig, {point.left_px}, {point.right_px});
            ASSERT_TRUE(position) << position.error().text();
            EXPECT_LT((position->point_in_left_mm - point.in_left_mm).norm(), 1e-6);
            EXPECT_LT(position->residual_px, 1e-8);
        }
    }
}

// The scatter of many noisy measurements against the covariance reported for one of them.
void expect_honest_covariance(const Rig& rig, const Vector3d& in_rig_mm, double left_sigma_px,
                              double right_sigma_px) {
    constexpr int trials = 4000;
    const SeenPoint point = seen(rig, in_rig_mm);
    const Matrix2d left_covariance = left_sigma_px * left_sigma_px * Matrix2d::Identity();
    const Matrix2d right_covariance = right_sigma_px * right_sigma_px * Matrix2d::Identity();
    PixelNoise noise(1.0);
    Matrix3d scatter = Matrix3d::Zero();
    Matrix3d reported = Matrix3d::Zero();
    double distance = 0.0;  // squared, in units of the reported covariance
    for (int i = 0; i < trials; ++i) {
        const auto position =
            position_from_pair(rig, {point.left_px + left_sigma_px * noise.next(), left_covariance},
                               {point.right_px + right_sigma_px * noise.next(), right_covariance});
        ASSERT_TRUE(position) << position.error().text();
        const Vector3d error = position->point_in_left_mm - point.in_left_mm;
        scatter += error * error.transpose() / trials;
        reported += position->covariance_mm2 / trials;
        distance += error.dot(position->covariance_mm2.inverse() * error) / trials;
    }
    for (int k = 0; k < 3; ++k) {
        EXPECT_NEAR(std::sqrt(scatter(k, k) / reported(k, k)), 1.0, 0.15);
    }
    EXPECT_NEAR(distance, 3.0, 0.3);  // three degrees of freedom, correlations included
}

TEST(Position, CovarianceMatchesTheScatter) {
    for (const Rig& rig : rig_samples()) {
        expect_honest_covariance(rig, {200, 50, 1200}, 0.3, 0.3);
        expect_honest_covariance(rig, {-300, -200, 2500}, 0.1, 0.1);
        expect_honest_covariance(rig, {500, 100, 1500}, 0.1, 0.5);
    }
}

TEST(Position, APictureThatIsKnownBetterCountsMore) {
    const Rig rig = nominal_rig();
    const SeenPoint point = seen(rig, {100, 50, 1500});
    const Vector2d lowered = point.right_px + Vector2d(0.0, 1.0);
    const auto beside_left_px = [&](double left_variance, double right_variance) {
        const auto position =
            position_from_pair(rig, {point.left_px, left_variance * Matrix2d::Identity()},
                               {lowered, right_variance * Matrix2d::Identity()});
        return (*project(rig.left.lens, position.value().point_in_left_mm) - point.left_px).norm();
    };
    EXPECT_LT(beside_left_px(0.01, 1.0), 0.02);
    EXPECT_GT(beside_left_px(1.0, 0.01), 0.9);
    EXPECT_NEAR(beside_left_px(0.01, 0.01), 0.5, 0.1);
}

// Root mean square of both methods' errors with noisy pixels of known uncertainty.
struct Errors {
    double least_mm;
    double midpoint_mm;
};

Errors errors_at(const Rig& rig, const Vector3d& in_rig_mm, double left_sigma_px,
                 double right_sigma_px) {
    constexpr int trials = 3000;
    const SeenPoint point = seen(rig, in_rig_mm);
    PixelNoise noise(1.0);
    double least = 0.0;
    double midpoint = 0.0;
    for (int i = 0; i < trials; ++i) {
        const PixelMeasurement left{point.left_px + left_sigma_px * noise.next(),
                                    left_sigma_px * left_sigma_px * Matrix2d::Identity()};
        const PixelMeasurement right{point.right_px + right_sigma_px * noise.next(),
                                     right_sigma_px * right_sigma_px * Matrix2d::Identity()};
        const Position a = position_from_pair(rig, left, right, {.max_residual_px = 10.0}).value();
        const Vector3d b = midpoint_from_pair(rig, left.pixel, right.pixel).value();
        least += (a.point_in_left_mm - point.in_left_mm).squaredNorm() / trials;
        midpoint += (b - point.in_left_mm).squaredNorm() / trials;
    }
    return {std::sqrt(least), std::sqrt(midpoint)};
}

TEST(Position, LeastErrorIsNoWorseThanTheMidpoint) {
    for (const Rig& rig : rig_samples()) {
        // Far away the depth alone counts, and both methods know it equally well.
        const Errors far = errors_at(rig, {-500, 300, 6000}, 0.2, 0.2);
        EXPECT_LE(far.least_mm, 1.002 * far.midpoint_mm);
        // Near by and to one side, the two pictures of unlike sharpness.
        const Errors near = errors_at(rig, {-300, 200, 500}, 0.1, 0.8);
        EXPECT_LT(near.least_mm, 0.99 * near.midpoint_mm);
    }
}

TEST(Position, RefusesPixelsThatNoRayReaches) {
    Rig rig = nominal_rig();
    rig.right->lens = BrownLens(400, 400, 320, 240, {-0.5, 0, 0, 0, 0});
    EXPECT_TRUE(contains(cause_of(position_from_pair(rig, {{300, 240}}, {{5, 5}})),
                         "No ray reaches the right pixel (5.00, 5.00)"));
}

TEST(Position, RefusesParallelRays) {
    const Rig rig = nominal_rig();
    const SeenPoint far = seen(rig, {0, 0, 2e6});
    EXPECT_TRUE(contains(cause_of(position_from_pair(rig, {far.left_px}, {far.right_px})),
                         "parallel to 0.013 degrees"));
    EXPECT_TRUE(position_from_pair(rig, {far.left_px}, {far.right_px}, {.min_parallax_rad = 1e-4}));
}

TEST(Position, RefusesPointsBehindACamera) {
    const Rig rig = nominal_rig();
    const SeenPoint point = seen(rig, {225, 0, 1000});
    const Vector2d aside(150, 0);
    EXPECT_TRUE(contains(
        cause_of(position_from_pair(rig, {point.left_px - aside}, {point.right_px + aside})),
        "behind a camera"));
}

TEST(Position, RefusesPixelsOfDifferentPoints) {
    const Rig rig = nominal_rig();
    const SeenPoint point = seen(rig, {225, 0, 1000});
    const Vector2d down(0, 6.0);
    const auto refused = position_from_pair(rig, {point.left_px}, {point.right_px + down});
    EXPECT_TRUE(contains(cause_of(refused), "no common point")) << cause_of(refused);
    EXPECT_TRUE(contains(cause_of(refused), "at most 2.00 px"));
    const auto taken =
        position_from_pair(rig, {point.left_px}, {point.right_px + down}, {.max_residual_px = 5.0});
    ASSERT_TRUE(taken);
    EXPECT_NEAR(taken->residual_px, 3.0, 0.2);
}

TEST(Position, RefusesAnUncertaintyThatIsNone) {
    const Rig rig = nominal_rig();
    const SeenPoint point = seen(rig, {225, 0, 1000});
    EXPECT_TRUE(contains(
        cause_of(position_from_pair(rig, {point.left_px, Matrix2d::Zero()}, {point.right_px})),
        "positive definite"));
}

TEST(Position, NeedsARightCamera) {
    Rig rig = nominal_rig();
    rig.right.reset();
    EXPECT_THROW((void)position_from_pair(rig, {{320, 240}}, {{320, 240}}),
                 std::bad_optional_access);
}

}  // namespace
}  // namespace kambara
