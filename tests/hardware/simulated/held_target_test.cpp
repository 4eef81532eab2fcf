// SPDX-License-Identifier: GPL-3.0-or-later
#include "hardware/simulated/held_target.h"

#include <gtest/gtest.h>

namespace kambara {
namespace {

HeldTarget::Options exact() {
    HeldTarget::Options options;
    options.off_mm = 0.0;
    options.off_rad = 0.0;
    return options;
}

const HeldTarget::Pose start{{0.0, 0.0, 1000.0}, Eigen::Quaterniond::Identity()};
const HeldTarget::Pose goal{{350.0, 0.0, 1000.0}, Eigen::Quaterniond::Identity()};

TEST(HeldTarget, IsNobodysUntilHeldAndAgainWhenLetGo) {
    HeldTarget hand(exact());
    EXPECT_FALSE(hand.at(0.0, start));
    hand.hold(goal, false);
    EXPECT_TRUE(hand.at(0.0, start));
    hand.let_go();
    EXPECT_FALSE(hand.at(0.1, start));
}

TEST(HeldTarget, MovesNoFasterThanAHandAndThenStandsStill) {
    HeldTarget hand(exact());
    hand.hold(goal, false);
    EXPECT_EQ(hand.at(0.0, start)->pose.middle_mm, start.middle_mm);
    const auto half = hand.at(0.5, start);
    EXPECT_NEAR(half->pose.middle_mm.x(), 175.0, 1e-9);
    EXPECT_EQ(half->still_since, -1);
    (void)hand.at(1.01, start);
    const auto there = hand.at(1.1, start);
    EXPECT_EQ(there->pose.middle_mm, goal.middle_mm);
    EXPECT_GE(there->still_since, 0);
    EXPECT_EQ(hand.at(2.0, start)->still_since, there->still_since);
    hand.hold(start, false);
    (void)hand.at(9.0, start);
    EXPECT_NE(hand.at(9.1, start)->still_since, there->still_since);
}

TEST(HeldTarget, TellsALateCameraWhatItToldTheOther) {
    HeldTarget hand(exact());
    hand.hold(goal, false);
    (void)hand.at(0.0, start);
    const auto at_once = hand.at(0.2, start);
    (void)hand.at(0.4, start);
    hand.hold(start, false);
    EXPECT_EQ(hand.at(0.2, start)->pose.middle_mm, at_once->pose.middle_mm);
    EXPECT_NEAR(hand.at(0.3, start)->pose.middle_mm.x(), 105.0, 1e-9);
}

TEST(HeldTarget, AHelpersHandIsALittleOff) {
    HeldTarget hand;
    hand.hold(goal, true);
    (void)hand.at(0.0, start);
    const auto there = hand.at(9.0, start);
    const double off_mm = (there->pose.middle_mm - goal.middle_mm).norm();
    EXPECT_GT(off_mm, 0.1);
    EXPECT_LT(off_mm, 30.0);
    EXPECT_GT(there->pose.turned.angularDistance(goal.turned), 0.001);
}

}  // namespace
}  // namespace kambara
