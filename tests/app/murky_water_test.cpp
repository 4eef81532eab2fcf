// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/murky_water.h"

#include <gtest/gtest.h>

#include "core/tracking/tracker_options.h"

namespace kambara {
namespace {

class MurkyWater : public testing::TestWithParam<const char*> {};

TEST_P(MurkyWater, HidesTheTargetFromTheMethodsOf1999ButNotFromTheDefault) {
    const MurkyScene scene = murky_scene(GetParam(), 2, 12.0);
    KeptFrames by_default;
    KeptFrames by_ncc;
    follow(scene, TrackerOptions{}.search.method, by_default);
    follow(scene, {Measure::ncc, Transform::none}, by_ncc);
    EXPECT_EQ(by_default.refused, 0);
    EXPECT_GE(by_default.kept_to_3_lengths(), 0.99);
    EXPECT_LE(by_default.wrong_to_3_lengths(), 0.01);
    EXPECT_LT(by_ncc.kept_to_3_lengths(), by_default.kept_to_3_lengths());
}

INSTANTIATE_TEST_SUITE_P(Waters, MurkyWater, testing::ValuesIn(murky_waters));

}  // namespace
}  // namespace kambara
