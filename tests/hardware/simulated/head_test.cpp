// SPDX-License-Identifier: GPL-3.0-or-later
#include "hardware/simulated/simulated_head.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace kambara {
namespace {

HeadAngles degrees(double pan, double tilt) {
    return {rad_from_deg(pan), rad_from_deg(tilt)};
}

class SimulatedHeadTest : public testing::Test {
  protected:
    HeadStatus after_s(double seconds) {
        clock_->set_ns(static_cast<std::int64_t>(std::llround(seconds * 1e9)));
        return head_.status().value();
    }

    std::shared_ptr<ManualClock> clock_ = std::make_shared<ManualClock>();
    SimulatedHead head_{clock_};
};

TEST_F(SimulatedHeadTest, EachAxisTurnsAtItsOwnSpeed) {
    // 40 degrees of pan take 0.5 s at 80 degrees/s; 20 of tilt take 0.4 s at 50.
    ASSERT_TRUE(head_.move_to(degrees(40, -20)).ok());
    for (const double t : {0.0, 0.1, 0.25, 0.45, 0.5, 3.0}) {
        const HeadStatus status = after_s(t);
        EXPECT_NEAR(deg_from_rad(status.angles.pan_rad), std::min(80.0 * t, 40.0), 1e-9) << t;
        EXPECT_NEAR(deg_from_rad(status.angles.tilt_rad), -std::min(50.0 * t, 20.0), 1e-9) << t;
        EXPECT_EQ(status.moving, t < 0.5) << t;
        EXPECT_EQ(status.time_ns, clock_->now_ns());
    }
}

TEST_F(SimulatedHeadTest, ANewerCommandStartsFromWhereTheHeadIs) {
    ASSERT_TRUE(head_.move_to(degrees(80, 0)).ok());
    after_s(0.5);  // at 40 degrees
    ASSERT_TRUE(head_.move_to(degrees(0, 25)).ok());
    const HeadStatus back = after_s(0.75);
    EXPECT_NEAR(deg_from_rad(back.angles.pan_rad), 20.0, 1e-9);
    EXPECT_NEAR(deg_from_rad(back.angles.tilt_rad), 12.5, 1e-9);
    ASSERT_TRUE(head_.halt().ok());
    const HeadStatus halted = after_s(9.0);
    EXPECT_EQ(halted.angles, back.angles);
    EXPECT_FALSE(halted.moving);
}

TEST_F(SimulatedHeadTest, ComesToRestOnWholeSteps) {
    ASSERT_TRUE(head_.move_to(degrees(10.03, 3.03)).ok());
    const HeadAngles rest = after_s(5.0).angles;
    EXPECT_NEAR(deg_from_rad(rest.pan_rad), 88 / 8.8, 1e-9);
    EXPECT_NEAR(deg_from_rad(rest.tilt_rad), 36 / 12.0, 1e-9);

    SimulatedHead::Options coarse;
    coarse.pan_steps_per_deg = 0.5;
    coarse.limits.tilt_rad = rad_from_deg(24.99);
    SimulatedHead other(clock_, coarse);
    ASSERT_TRUE(other.move_to(degrees(5.5, 24.99)).ok());
    const HeadAngles rough = (after_s(10.0), other.status().value().angles);
    EXPECT_NEAR(deg_from_rad(rough.pan_rad), 6.0, 1e-9);
    EXPECT_NEAR(deg_from_rad(rough.tilt_rad), 299 / 12.0, 1e-9) << "a step beyond the limit";
}

// From where it stands to where it is told, rounding must not keep it moving for ever.
TEST_F(SimulatedHeadTest, KnowsThatItHasArrivedWhereverItCameFrom) {
    for (int i = 0; i < 200; ++i) {
        ASSERT_TRUE(head_.move_to(degrees(37 * i % 180 - 90, 11 * i % 48 - 24)).ok());
        EXPECT_FALSE(after_s(5.0 * (i + 1)).moving) << i;
    }
}

TEST_F(SimulatedHeadTest, RefusesWhatItCannotReachAndKeepsToWhatItWasDoing) {
    EXPECT_TRUE(head_.move_to(degrees(-100, 25)).ok());
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const HeadAngles& beyond :
         {degrees(100.1, 0), degrees(0, -25.1), degrees(nan, 0), degrees(0, nan)}) {
        const auto refused = head_.move_to(beyond);
        ASSERT_FALSE(refused.ok());
        EXPECT_NE(refused.error().remedy.find("100"), std::string::npos);
    }
    const HeadAngles rest = after_s(10.0).angles;
    EXPECT_NEAR(deg_from_rad(rest.pan_rad), -100.0, 1e-9);
    EXPECT_NEAR(deg_from_rad(rest.tilt_rad), 25.0, 1e-9);
}

TEST_F(SimulatedHeadTest, IsDrivenAtWholeSpeedsUpToItsLimits) {
    // 80 degrees/s in 24 steps of 3.33, 50 in 20 of 2.5; what lies between is the slower one.
    ASSERT_TRUE(head_.drive(rad_from_deg(12.0), rad_from_deg(-6.0)).ok());
    const HeadStatus driven = after_s(1.0);
    EXPECT_NEAR(deg_from_rad(driven.angles.pan_rad), 10.0, 1e-9);
    EXPECT_NEAR(deg_from_rad(driven.angles.tilt_rad), -5.0, 1e-9);
    EXPECT_TRUE(driven.moving);
    ASSERT_TRUE(head_.drive(rad_from_deg(0.1), 0.0).ok());
    const HeadStatus slow = after_s(2.0);
    EXPECT_NEAR(deg_from_rad(slow.angles.pan_rad), 10.0 + 80.0 / 24, 1e-9);
    EXPECT_NEAR(deg_from_rad(slow.angles.tilt_rad), -5.0, 1e-9);
    ASSERT_TRUE(head_.drive(rad_from_deg(-800.0), 0.0).ok());
    const HeadStatus fast = after_s(2.5);
    EXPECT_NEAR(deg_from_rad(fast.angles.pan_rad), 10.0 + 80.0 / 24 - 40.0, 1e-9);
    const HeadStatus stopped = after_s(20.0);
    EXPECT_NEAR(deg_from_rad(stopped.angles.pan_rad), -100.0, 1e-9);
    EXPECT_FALSE(stopped.moving);
    ASSERT_TRUE(head_.drive(0.5, 0.5).ok());
    after_s(21.0);
    ASSERT_TRUE(head_.halt().ok());
    const HeadAngles halted = after_s(21.0).angles;
    EXPECT_EQ(after_s(30.0).angles, halted);
    EXPECT_FALSE(head_.drive(std::nan(""), 0.0).ok());
}

TEST_F(SimulatedHeadTest, ItsLensIsAnEviD30s) {
    const LensStatus wide = head_.lens().value();
    EXPECT_EQ(wide.zoom_share, 0.0);
    EXPECT_NEAR(deg_from_rad(wide.horizontal_view_rad), 48.8, 0.1);
    EXPECT_EQ(wide.magnification(), 1.0);
    EXPECT_TRUE(wide.autofocus);
    ASSERT_TRUE(head_.zoom_to(1.0).ok());
    after_s(1.0);
    EXPECT_NEAR(head_.lens().value().zoom_share, 0.5, 1e-9);
    EXPECT_NEAR(head_.lens().value().magnification(), std::sqrt(12.0), 1e-9);
    after_s(3.0);
    EXPECT_NEAR(head_.lens().value().magnification(), 12.0, 1e-9);
    EXPECT_NEAR(deg_from_rad(head_.lens().value().horizontal_view_rad), 4.3, 0.1);
    ASSERT_TRUE(head_.focus_to(0.8).ok());
    after_s(6.0);
    EXPECT_FALSE(head_.lens().value().autofocus);
    EXPECT_NEAR(head_.lens().value().focus_share, 0.8, 1e-9);
    ASSERT_TRUE(head_.autofocus().ok());
    after_s(9.0);
    EXPECT_TRUE(head_.lens().value().autofocus);
    EXPECT_NEAR(head_.lens().value().focus_share, wide.focus_share, 1e-9);
    for (const double no_share : {-0.1, 1.1, std::nan("")}) {
        EXPECT_FALSE(head_.zoom_to(no_share).ok());
        EXPECT_FALSE(head_.focus_to(no_share).ok());
    }
}

TEST_F(SimulatedHeadTest, PresetsBringBackAnglesAndLens) {
    EXPECT_EQ(head_.abilities().presets, 6);
    ASSERT_TRUE(head_.move_to(degrees(50, -10)).ok());
    ASSERT_TRUE(head_.zoom_to(0.75).ok());
    ASSERT_TRUE(head_.focus_to(0.5).ok());
    const HeadAngles there = after_s(10.0).angles;
    ASSERT_TRUE(head_.keep_preset(5).ok());
    const auto nothing = head_.recall_preset(0);
    ASSERT_FALSE(nothing.ok());
    EXPECT_EQ(nothing.error().cause, "Nothing was kept in preset 0.");
    EXPECT_EQ(after_s(20.0).angles, there) << "it stays where it is";
    EXPECT_NEAR(head_.lens().value().zoom_share, 0.75, 1e-9);
    ASSERT_TRUE(head_.move_to({}).ok());
    ASSERT_TRUE(head_.zoom_to(0.0).ok());
    ASSERT_TRUE(head_.autofocus().ok());
    EXPECT_EQ(after_s(25.0).angles, HeadAngles{});
    ASSERT_TRUE(head_.recall_preset(5).ok());
    EXPECT_EQ(after_s(30.0).angles, there);
    EXPECT_NEAR(head_.lens().value().zoom_share, 0.75, 1e-9);
    EXPECT_NEAR(head_.lens().value().focus_share, 0.5, 1e-9);
    EXPECT_FALSE(head_.lens().value().autofocus);
    EXPECT_FALSE(head_.keep_preset(6).ok());
    EXPECT_FALSE(head_.recall_preset(-1).ok());
}

}  // namespace
}  // namespace kambara
