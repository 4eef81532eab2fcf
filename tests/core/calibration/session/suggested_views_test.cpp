// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "tests/core/calibration/session/guided_study.h"

namespace kambara {
namespace {

using testing_support::GuidedStudy;
using testing_support::run;

void expect_twelve_to_reach_twenty_five(const Target& target) {
    GuidedStudy study;
    study.target = target;
    const auto result = run(study, 2);
    EXPECT_EQ(result.suggested.good, 2);
    EXPECT_LE(result.suggested.reported, result.random.reported);
    // What is off in truth scatters from seed to seed; within what the report says of it.
    EXPECT_LE(result.suggested.truly, 2.0 * result.suggested.reported);
}

TEST(SuggestedViews, TwelveReachTwentyFiveAtRandomWithBoxes) {
    expect_twelve_to_reach_twenty_five(two_plane_24());
}

TEST(SuggestedViews, TwelveReachTwentyFiveAtRandomWithABoard) {
    expect_twelve_to_reach_twenty_five(ChessboardTarget{9, 6, 30.0});
}

}  // namespace
}  // namespace kambara
