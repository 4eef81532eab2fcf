// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/mean_slope.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

#include "core/camera/nominal_rig.h"
#include "core/tracking/stereo_tracker.h"
#include "tests/support/textured_plane.h"

namespace kambara {
namespace {

Eigen::Matrix2d covariance() {
    return (Eigen::Matrix2d() << 4e-4, 1e-4, 1e-4, 9e-4).finished();
}

Eigen::Vector2d about(const Eigen::Vector2d& slope, std::mt19937& random) {
    std::normal_distribution<double> normal;
    const double a = normal(random);
    const double b = normal(random);
    return slope + Eigen::Vector2d(0.02 * a, 0.005 * a + std::sqrt(9e-4 - 2.5e-5) * b);
}

TEST(MeanSlope, IsAsSureAsItsPairsTogether) {
    std::mt19937 random(3);
    const Eigen::Vector2d truth(0.3, -0.2);
    double squared = 0.0;
    constexpr int cases = 2000;
    for (int i = 0; i < cases; ++i) {
        MeanSlope mean;
        while (!mean.is_settled()) {
            mean.add(about(truth, random), covariance());
        }
        const Eigen::Vector2d off = mean.value().value() - truth;
        squared += MeanSlope::enough * off.dot(covariance().inverse() * off);
    }
    EXPECT_NEAR(squared / cases, 2.0, 0.15);  // two dimensions
}

TEST(MeanSlope, NoiseAloneIsNoSlope) {
    std::mt19937 random(4);
    int leaning = 0;
    constexpr int cases = 2000;
    for (int i = 0; i < cases; ++i) {
        MeanSlope mean;
        EXPECT_FALSE(mean.value());
        while (!mean.is_settled()) {
            mean.add(about(Eigen::Vector2d::Zero(), random), covariance());
        }
        leaning += mean.value() ? 1 : 0;
    }
    EXPECT_LE(leaning, 10);  // 2 of 2000 by chance
}

TEST(MeanSlope, WhatDisagreesIsLeftOut) {
    MeanSlope mean;
    mean.add({0.3, 0.0}, covariance());
    mean.add({-0.3, 0.0}, covariance());  // something passed before the target
    EXPECT_NEAR(mean.value().value().x(), 0.3, 1e-12);
}

// Taken to be square to the rig's axis it is off by up to 0.37 px on the far side of the field.
TEST(StereoTrackerOnALeaningPlane, KeepsItsPlaceAcrossTheField) {
    const Rig rig = nominal_rig();
    StereoTracker tracker(rig);
    const Rectangle rectangle{150, 200, 31, 31};
    const Eigen::Vector2d slope(0.15, 0.25);
    const auto pair_at = [&](int index) {
        testing_support::TexturedPlane plane{{70.0 * index, 10.0 * index, 1500.0 + 5.0 * index}};
        plane.slope = slope;
        return testing_support::drawn_pair(plane, rig, index);
    };
    ASSERT_TRUE(tracker.set_template(pair_at(0), rectangle));
    ASSERT_TRUE(tracker.start());
    // The point under the template's centre, on a plane through the rig's (0, 0, 1500).
    const Ray ray = *rig.left.unproject({rectangle.centre_x_px(), rectangle.centre_y_px()});
    const Eigen::Vector3d normal(-slope.x(), -slope.y(), 1.0);
    const Eigen::Vector3d origin(0.0, 0.0, 1500.0);
    const Eigen::Vector3d first =
        ray.at((origin - ray.origin_mm).dot(normal) / ray.direction.dot(normal));
    double worst_px = 0.0;
    for (int i = 0; i < 17; ++i) {
        const TrackEstimate estimate = tracker.process(pair_at(i));
        ASSERT_EQ(estimate.state, TrackState::tracking) << i << ": " << estimate.reason;
        const auto truth = rig.left.project(first + i * Eigen::Vector3d(70.0, 10.0, 5.0));
        ASSERT_TRUE(truth && estimate.left_px);
        worst_px = std::max(worst_px, (*estimate.left_px - *truth).norm());
    }
    std::printf("off by at most %.3f px\n", worst_px);
    EXPECT_LT(worst_px, 0.03);
    EXPECT_LT((tracker.look()->slope - slope).norm(), 0.01);
    // Made the new reference, it goes on leaning.
    ASSERT_TRUE(tracker.update_template());
    EXPECT_LT((tracker.look()->slope - slope).norm(), 0.01);
}

}  // namespace
}  // namespace kambara
