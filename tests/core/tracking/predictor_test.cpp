// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/predictor.h"

#include <gtest/gtest.h>

namespace kambara {
namespace {

constexpr std::int64_t frame_ns = 33'333'333;

TEST(Predictor, KnowsNothingBeforeTheFirstMeasurement) {
    EXPECT_FALSE(Predictor().at(5));
}

TEST(Predictor, StaysWhereItIsUntilItHasSeenMotion) {
    Predictor predictor;
    predictor.update(0, {1, 2, 3});
    EXPECT_EQ(*predictor.at(frame_ns), Eigen::Vector3d(1, 2, 3));
}

TEST(Predictor, FollowsConstantVelocityExactly) {
    Predictor predictor;
    const Eigen::Vector3d velocity_mm_s(120, -40, 300);
    for (int i = 0; i < 5; ++i) {
        predictor.update(i * frame_ns, velocity_mm_s * (static_cast<double>(i * frame_ns) * 1e-9));
    }
    const Eigen::Vector3d expected = velocity_mm_s * (static_cast<double>(6 * frame_ns) * 1e-9);
    EXPECT_LT((*predictor.at(6 * frame_ns) - expected).norm(), 1e-9);
}

TEST(Predictor, DoesNotExtrapolateBeyondHalfASecond) {
    Predictor predictor;
    predictor.update(0, {0, 0, 0});
    predictor.update(100'000'000, {10, 0, 0});
    EXPECT_NEAR(predictor.at(100'000'000 + 10'000'000'000)->x(), 10.0 + 0.5 * 100.0, 1e-9);
}

TEST(Predictor, ForgetsItsVelocityOverALongGap) {
    Predictor predictor;
    predictor.update(0, {0, 0, 0});
    predictor.update(100'000'000, {10, 0, 0});
    predictor.update(2'000'000'000, {50, 0, 0});
    EXPECT_EQ(predictor.at(2'100'000'000)->x(), 50.0);
}

}  // namespace
}  // namespace kambara
