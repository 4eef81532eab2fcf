// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/predictor.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

namespace kambara {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr std::int64_t frame_ns = 33'333'333;

double seconds(std::int64_t ns) {
    return static_cast<double>(ns) * 1e-9;
}

// As a position at 1.5 m: the distance is known worst.
const Vector3d sigmas_mm(0.4, 0.4, 1.5);
const Matrix3d noise_mm2 = sigmas_mm.cwiseAbs2().asDiagonal();

class NoisyPlaces {
  public:
    Vector3d operator()(const Vector3d& place) {
        return place + Vector3d(normal_(random_), normal_(random_), normal_(random_))
                           .cwiseProduct(sigmas_mm);
    }

  private:
    std::mt19937 random_{3};
    std::normal_distribution<double> normal_;
};

TEST(Predictor, KnowsNothingBeforeTheFirstMeasurement) {
    EXPECT_FALSE(Predictor().at(5));
    EXPECT_FALSE(Predictor().motion());
}

TEST(Predictor, StaysWhereItIsUntilItHasSeenMotion) {
    Predictor predictor;
    predictor.update(0, {1, 2, 3}, noise_mm2);
    EXPECT_EQ(*predictor.at(frame_ns), Vector3d(1, 2, 3));
    EXPECT_FALSE(predictor.motion());
}

TEST(Predictor, FindsAConstantVelocityWithinItsSigmasAndSaysSo) {
    Predictor predictor;
    NoisyPlaces noisy;
    const Vector3d velocity_mm_s(120, -40, 300);
    int inside = 0;
    int consistent = 0;
    constexpr int frames = 300;
    for (int i = 0; i < frames; ++i) {
        predictor.update(i * frame_ns, noisy(velocity_mm_s * seconds(i * frame_ns)), noise_mm2);
        if (const auto motion = predictor.motion()) {
            const Vector3d off = motion->velocity_mm_s - velocity_mm_s;
            inside += (off.array().abs() < 2.0 * motion->velocity_sigma_mm_s().array()).all();
            consistent += motion->consistent;
        }
    }
    EXPECT_GT(inside, 0.9 * frames);
    EXPECT_GT(consistent, 0.9 * frames);
    EXPECT_EQ(predictor.motion()->model, MotionModel::constant_velocity);
    EXPECT_FALSE(predictor.motion()->by_vehicle);
}

// A ball that is thrown: constant velocity alone would be late.
TEST(Predictor, TakesTheAccelerationWhereThereIsOne) {
    Predictor predictor;
    NoisyPlaces noisy;
    const auto place = [](std::int64_t time_ns) {
        const double t = seconds(time_ns);
        return Vector3d(200.0 * t, 1500.0 * t * t, 1500.0);
    };
    for (int i = 0; i < 60; ++i) {
        predictor.update(i * frame_ns, noisy(place(i * frame_ns)), noise_mm2);
    }
    EXPECT_EQ(predictor.motion()->model, MotionModel::constant_acceleration);
    // An acceleration that is thought to fade is found somewhat smaller than it is.
    EXPECT_GT(predictor.motion()->acceleration_mm_s2.y(), 2000.0);
    EXPECT_LT(predictor.motion()->acceleration_mm_s2.y(), 3300.0);
    const std::int64_t ahead_ns = 62 * frame_ns;
    EXPECT_LT((*predictor.at(ahead_ns) - place(ahead_ns)).norm(), 10.0);
}

// It goes on straight through a loss of a third of a second, and is followed when it turns about.
TEST(Predictor, BridgesAShortLossAndFollowsASuddenTurn) {
    Predictor predictor;
    NoisyPlaces noisy;
    const auto place = [](int frame) {
        return Vector3d(400.0 * seconds((frame < 60 ? frame : 120 - frame) * frame_ns), 0, 1500);
    };
    for (int i = 0; i < 60; ++i) {
        if (i < 30 || i >= 40) {
            predictor.update(i * frame_ns, noisy(place(i)), noise_mm2);
        }
        if (i == 39 || i == 30) {
            EXPECT_LT((*predictor.at(i * frame_ns) - place(i)).norm(), i == 30 ? 3.0 : 15.0);
        }
    }
    for (int i = 60; i < 66; ++i) {
        predictor.update(i * frame_ns, noisy(place(i)), noise_mm2);
    }
    EXPECT_LT((*predictor.at(66 * frame_ns) - place(66)).norm(), 8.0);
}

TEST(Predictor, DoesNotExtrapolateBeyondHalfASecond) {
    Predictor predictor;
    for (int i = 0; i < 30; ++i) {
        predictor.update(i * frame_ns, {100.0 * seconds(i * frame_ns), 0, 0}, noise_mm2);
    }
    const Vector3d half = *predictor.at(29 * frame_ns + 500'000'000);
    EXPECT_EQ(*predictor.at(29 * frame_ns + 10'000'000'000), half);
    EXPECT_NEAR(half.x(), 100.0 * (seconds(29 * frame_ns) + 0.5), 2.0);
}

TEST(Predictor, ForgetsItsVelocityOverALongGap) {
    Predictor predictor;
    predictor.update(0, {0, 0, 0}, noise_mm2);
    predictor.update(100'000'000, {10, 0, 0}, noise_mm2);
    predictor.update(2'000'000'000, {50, 0, 0}, noise_mm2);
    EXPECT_EQ(predictor.at(2'100'000'000)->x(), 50.0);
    EXPECT_FALSE(predictor.has_velocity());
}

// A point that stands still on the ground, a vehicle that turns and goes; the feed is told late.
TEST(Predictor, AVehicleMovesTheExpectedPlace) {
    const double turn_rad_s = 1.5;
    const Vector3d velocity(100, 0, 300);
    auto vehicle = std::make_shared<VehicleTrack>();
    Predictor with;
    Predictor without;
    with.follow_vehicle(vehicle);
    RigidTransform T_rig_from_world;
    const Vector3d still(200, 100, 1500);
    constexpr std::int64_t step_ns = 1'000'000;
    std::int64_t told_ns = 0;
    const auto turn_at = [&](std::int64_t t) { return turn_rad_s * std::cos(8.0 * seconds(t)); };
    double worst_with = 0.0;
    double worst_without = 0.0;
    for (std::int64_t t = 0; t < 2'000'000'000; t += step_ns) {
        for (; told_ns <= t - 20'000'000; told_ns += 10'000'000) {
            vehicle->add({told_ns, velocity, {0, turn_at(told_ns), 0}, 1.0, 0.001});
        }
        if (t % 33'000'000 == 0) {
            const Vector3d place = T_rig_from_world * still;
            if (t > 500'000'000) {
                worst_with = std::max(worst_with, (*with.at(t) - place).norm());
                worst_without = std::max(worst_without, (*without.at(t) - place).norm());
            }
            with.update(t, place, noise_mm2);
            without.update(t, place, noise_mm2);
        }
        const double s = seconds(step_ns);
        const Matrix3d R =
            Eigen::AngleAxisd(-turn_at(t + step_ns / 2) * s, Vector3d::UnitY()).toRotationMatrix();
        T_rig_from_world = RigidTransform{R, -velocity * s} * T_rig_from_world;
    }
    EXPECT_LT(worst_with, 2.0);
    EXPECT_GT(worst_without, 4.0 * worst_with);
    ASSERT_TRUE(with.motion());
    EXPECT_TRUE(with.motion()->by_vehicle);
    EXPECT_LT(with.motion()->velocity_mm_s.norm(), 60.0);  // over ground
}

TEST(VehicleTrack, SaysNothingOfTimesItDoesNotKnow) {
    VehicleTrack track;
    EXPECT_FALSE(track.between(0, 10));
    track.add({100'000'000, {1, 0, 0}, {0, 0, 0}});
    track.add({50'000'000, {9, 0, 0}, {0, 0, 0}});  // older: passed over
    EXPECT_FALSE(track.add({150'000'000, {NAN, 0, 0}, {0, 0, 0}}));
    EXPECT_FALSE(track.add({150'000'000, {9, 0, 0}, {0, 0, 0}, NAN}));
    EXPECT_FALSE(track.add({150'000'000, {9, 0, 0}, {0, 0, 0}, 20.0, -0.01}));
    EXPECT_FALSE(track.between(0, 110'000'000));
    ASSERT_TRUE(track.between(100'000'000, 300'000'000));
    EXPECT_NEAR(track.between(100'000'000, 300'000'000)->T_now_from_then.t_mm.x(), -0.2, 1e-12);
    EXPECT_FALSE(track.between(100'000'000, 400'000'000));
}

}  // namespace
}  // namespace kambara
