// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "core/camera/nominal_rig.h"
#include "core/pointing/aim.h"
#include "core/pointing/steering.h"

namespace kambara {
namespace {

using Eigen::Vector3d;

// The left camera's frame from the rig's.
Vector3d in_left(const Rig& rig, const Vector3d& in_rig_mm) {
    return rig.left.T_camera_from_rig * in_rig_mm;
}

const Vector3d head_in_rig_mm(225, -120, 30);

TEST(Aim, TheAxisAtHomeIsAtZero) {
    const Rig rig = nominal_rig();
    const double down = rad_from_deg(21.0);
    const Vector3d on_axis = head_in_rig_mm + 1700.0 * Vector3d(0, std::sin(down), std::cos(down));
    const HeadAngles angles = angles_towards(rig, in_left(rig, on_axis));
    EXPECT_NEAR(angles.pan_rad, 0.0, 1e-14);
    EXPECT_NEAR(angles.tilt_rad, 0.0, 1e-14);
}

TEST(Aim, RightAndUpArePositive) {
    const Rig rig = nominal_rig();
    // Level with the head and straight ahead in the rig: 21 degrees above its axis.
    const HeadAngles level =
        angles_towards(rig, in_left(rig, head_in_rig_mm + Vector3d(0, 0, 900)));
    EXPECT_NEAR(level.pan_rad, 0.0, 1e-14);
    EXPECT_NEAR(level.tilt_rad, rad_from_deg(21.0), 1e-14);
    // To the side along the rig's x, which is the head's x too.
    const HeadAngles right =
        angles_towards(rig, in_left(rig, head_in_rig_mm + Vector3d(500, 0, 0)));
    EXPECT_NEAR(right.pan_rad, rad_from_deg(90.0), 1e-13);
    EXPECT_NEAR(right.tilt_rad, 0.0, 1e-13);
}

TEST(Aim, IsUndoneByTheAxis) {
    const Rig rig = nominal_rig();
    std::mt19937 random(2);
    std::uniform_real_distribution<double> pan(-100.0, 100.0);
    std::uniform_real_distribution<double> tilt(-25.0, 25.0);
    for (int i = 0; i < 200; ++i) {
        const HeadAngles wanted{rad_from_deg(pan(random)), rad_from_deg(tilt(random))};
        const Vector3d point =
            in_left(rig, head_in_rig_mm) + 2500.0 * axis_in_left_frame(rig, wanted);
        const HeadAngles found = angles_towards(rig, point);
        EXPECT_NEAR(found.pan_rad, wanted.pan_rad, 1e-12);
        EXPECT_NEAR(found.tilt_rad, wanted.tilt_rad, 1e-12);
        EXPECT_LT(aiming_error_rad(rig, wanted, point), 1e-12);
    }
}

TEST(Aim, TheErrorIsTheAngleBetweenAxisAndTarget) {
    const Rig rig = nominal_rig();
    const HeadAngles at{0.3, 0.2};
    const Vector3d point = in_left(rig, head_in_rig_mm) + 900.0 * axis_in_left_frame(rig, at);
    EXPECT_NEAR(aiming_error_rad(rig, {0.3, 0.25}, point), 0.05, 1e-12);
    // A pan error counts less the higher the head looks.
    const double c = std::cos(0.2);
    EXPECT_NEAR(aiming_error_rad(rig, {0.4, 0.2}, point), 2.0 * std::asin(c * std::sin(0.05)),
                1e-12);
}

TEST(Aim, KeepsWithinTheLimits) {
    const HeadLimits limits;
    const HeadAngles inside{limits.pan_rad, -limits.tilt_rad};
    EXPECT_EQ(within_limits(inside, limits), inside);
    EXPECT_EQ(within_limits({-3.0, 1.0}, limits), (HeadAngles{-limits.pan_rad, limits.tilt_rad}));
}

TEST(Steering, LeavesTheHeadAloneWithinTheDeadBand) {
    Steering steering({.dead_band_rad = 0.01}, HeadLimits{});
    EXPECT_EQ(steering.command_for({0.1, 0.2}, std::nullopt), (HeadAngles{0.1, 0.2}));
    const HeadAngles last{0.1, 0.2};
    EXPECT_EQ(steering.command_for({0.107, 0.207}, last), std::nullopt);
    EXPECT_EQ(steering.command_for({0.1, 0.2101}, last), (HeadAngles{0.1, 0.2101}));
    // High up, a pan step moves the axis by less than itself.
    Steering high({.dead_band_rad = 0.01}, HeadLimits{3.0, 1.5, 1.0, 1.0});
    EXPECT_EQ(high.command_for({0.015, 1.2}, HeadAngles{0.0, 1.2}), std::nullopt);
}

TEST(Steering, NeverCommandsBeyondTheLimitsAndSaysSo) {
    const HeadLimits limits;
    Steering steering({}, limits);
    std::mt19937 random(6);
    std::uniform_real_distribution<double> any(-3.2, 3.2);
    std::optional<HeadAngles> last;
    int at_limit = 0;
    for (int i = 0; i < 1000; ++i) {
        const HeadAngles wanted{any(random), any(random)};
        if (const auto command = steering.command_for(wanted, last)) {
            EXPECT_EQ(within_limits(*command, limits), *command);
            EXPECT_EQ(steering.at_limit(), *command != wanted);
            last = command;
        }
        at_limit += steering.at_limit() ? 1 : 0;
    }
    EXPECT_GT(at_limit, 100);
    steering.command_for({0.0, 0.0}, last);
    EXPECT_FALSE(steering.at_limit());
}

TEST(Steering, IsSilentWhileTheOperatorHasTheHead) {
    Steering steering({}, HeadLimits{});
    steering.set_automatic(false);
    EXPECT_EQ(steering.command_for({0.1, 0.2}, std::nullopt), std::nullopt);
    steering.set_automatic(true);
    EXPECT_TRUE(steering.command_for({0.1, 0.2}, std::nullopt));
}

TEST(Steering, KeepsTheIntervalBetweenCommands) {
    Steering steering({.min_interval_s = 0.1}, HeadLimits{});
    const std::int64_t start_ns = 5'000'000'000;
    ASSERT_TRUE(steering.command_for({0.1, 0.0}, std::nullopt, start_ns));
    const HeadAngles last{0.1, 0.0};
    EXPECT_FALSE(steering.command_for({0.3, 0.0}, last, start_ns + 99'000'000));
    EXPECT_TRUE(steering.command_for({0.3, 0.0}, last, start_ns + 100'000'000));
    EXPECT_FALSE(steering.command_for({0.5, 0.0}, last, start_ns + 199'000'000));
}

TEST(Steering, ARecordingThatWasWoundBackDoesNotSilenceIt) {
    Steering steering({.min_interval_s = 0.1}, HeadLimits{});
    ASSERT_TRUE(steering.command_for({0.1, 0.0}, std::nullopt, 60'000'000'000));
    EXPECT_TRUE(steering.command_for({0.3, 0.0}, HeadAngles{0.1, 0.0}, 2'000'000'000));
}

TEST(Steering, WithoutATargetNothingIsBeyondReach) {
    Steering steering({}, HeadLimits{});
    ASSERT_TRUE(steering.command_for({3.0, 0.0}, std::nullopt));
    ASSERT_TRUE(steering.at_limit());
    steering.nothing_wanted();
    EXPECT_FALSE(steering.at_limit());
}

TEST(Steering, DoesNotFollowWhatIsNoNumber) {
    Steering steering({}, HeadLimits{});
    const double nothing = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(steering.command_for({nothing, 0.0}, std::nullopt), std::nullopt);
    EXPECT_EQ(steering.command_for({0.0, nothing}, std::nullopt), std::nullopt);
}

}  // namespace
}  // namespace kambara
