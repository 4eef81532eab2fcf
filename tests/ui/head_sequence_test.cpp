// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/experiments/head_sequence.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace kambara::ui {
namespace {

using Asks = HeadSequence::Asks;

HeadSnapshot at(const HeadAngles& angles, bool moving = false) {
    HeadSnapshot head;
    head.angles = angles;
    head.moving = moving;
    return head;
}

TEST(HeadSteps, SpanWhatTheCalibrationNeedsFromBothSides) {
    const auto steps = head_steps_about({0.1, -0.05}, HeadLimits{});
    ASSERT_EQ(steps.size(), 18U);
    const auto [least, most] = std::minmax_element(
        steps.begin(), steps.end(),
        [](const auto& a, const auto& b) { return a.goal.pan_rad < b.goal.pan_rad; });
    EXPECT_GT(deg_from_rad(most->goal.pan_rad - least->goal.pan_rad), 20.0);
    for (const HeadStep& one : steps) {
        // Each position is come to from the other side, too.
        EXPECT_TRUE(std::any_of(steps.begin(), steps.end(), [&](const HeadStep& other) {
            return other.goal == one.goal && other.approach.pan == -one.approach.pan &&
                   other.approach.tilt == -one.approach.tilt;
        }));
        EXPECT_EQ(one.goal.pan_rad > one.from.pan_rad ? 1 : -1, one.approach.pan);
        EXPECT_EQ(one.goal.tilt_rad > one.from.tilt_rad ? 1 : -1, one.approach.tilt);
    }
    // What the head does not reach is left out.
    EXPECT_LT(head_steps_about({0.0, rad_from_deg(20.0)}, HeadLimits{}).size(), 18U);
    EXPECT_TRUE(head_steps_about({rad_from_deg(130.0), 0.0}, HeadLimits{}).empty());
}

TEST(HeadSequence, GoesToTheRunUpThenToTheGoalAndWaitsUntilItIsStill) {
    HeadSequence sequence;
    EXPECT_EQ(sequence.see(at({}), 0).asks, Asks::nothing);
    const HeadStep step{{-0.1, 0.0}, {0.1, 0.05}, {1, 1}};
    sequence.begin({step, step});
    auto request = sequence.see(at({}), 0);
    EXPECT_EQ(request.asks, Asks::move);
    EXPECT_EQ(request.angles, step.from);
    EXPECT_EQ(sequence.see(at({}), 100).asks, Asks::nothing);
    EXPECT_EQ(sequence.see(at(step.from, true), 200).asks, Asks::nothing) << "it moves still";
    EXPECT_EQ(sequence.see(at(step.from), 300).asks, Asks::nothing);
    request = sequence.see(at(step.from), 400);
    EXPECT_EQ(request.asks, Asks::move);
    EXPECT_EQ(request.angles, step.goal);
    EXPECT_EQ(sequence.see(at(step.goal), 500).asks, Asks::nothing);
    EXPECT_EQ(sequence.see(at(step.goal), 600).asks, Asks::nothing) << "pictures are still older";
    EXPECT_EQ(sequence.see(at(step.goal), 1300).asks, Asks::view);
    EXPECT_EQ(sequence.see(at(step.goal), 1400).asks, Asks::nothing) << "a view is asked for once";
    sequence.next();
    EXPECT_TRUE(sequence.going());
    EXPECT_EQ(sequence.see(at(step.goal), 1500).asks, Asks::move);
    sequence.next();
    EXPECT_FALSE(sequence.going());
}

TEST(HeadSequence, GivesUpOnAHeadThatDoesNotArrive) {
    HeadSequence sequence;
    sequence.begin({{{-0.1, 0.0}, {0.1, 0.05}, {1, 1}}});
    EXPECT_EQ(sequence.see(at({}), 0).asks, Asks::move);
    EXPECT_EQ(sequence.see(at({}), 14000).asks, Asks::nothing);
    EXPECT_EQ(sequence.see(at({}), 16000).asks, Asks::give_up);
}

}  // namespace
}  // namespace kambara::ui
