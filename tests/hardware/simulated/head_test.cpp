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

}  // namespace
}  // namespace kambara
