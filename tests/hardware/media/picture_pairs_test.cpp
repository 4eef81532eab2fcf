// SPDX-License-Identifier: GPL-3.0-or-later
#include "hardware/media/picture_pairs.h"

#include <gtest/gtest.h>

#include <string>

namespace kambara {
namespace {

using Files = std::vector<std::filesystem::path>;

Files named(const std::string& side, const std::vector<long>& numbers) {
    Files files;
    for (const long number : numbers) {
        files.push_back(side + "/" + side + std::to_string(number) + ".png");
    }
    return files;
}

TEST(PicturePairs, APictureThatOneSideLacksIsNamed) {
    const auto gap = check_pairs(named("l", {0, 1, 2, 3}), named("r", {0, 1, 3}));
    ASSERT_FALSE(gap);
    EXPECT_NE(gap.error().cause.find("l/l2.png has no partner"), std::string::npos)
        << gap.error().cause;
    // Each lacks another one: as many on both sides.
    const auto both = check_pairs(named("l", {0, 2, 3, 4}), named("r", {0, 1, 2, 4}));
    ASSERT_FALSE(both);
    EXPECT_NE(both.error().cause.find("r/r1.png has no partner"), std::string::npos);
    EXPECT_FALSE(check_pairs(named("l", {0, 1, 2}), named("r", {1, 2})));
}

TEST(PicturePairs, WhatIsNumberedOtherwiseIsTakenAsItIs) {
    EXPECT_TRUE(check_pairs(named("l", {0, 1, 2}), named("r", {0, 1, 2})));
    EXPECT_TRUE(check_pairs(named("l", {0, 1, 2}), named("r", {0, 1})));  // ends earlier
    EXPECT_TRUE(check_pairs(named("l", {0, 1, 2}), named("r", {1, 2, 3})));
    EXPECT_TRUE(check_pairs(named("l", {100, 133, 167}), named("r", {101, 135, 166})));  // times
    EXPECT_TRUE(check_pairs({"left.png", "other.png"}, {"1.png", "2.png"}));
    EXPECT_TRUE(check_pairs({}, {}));
    // More digits than a number holds.
    EXPECT_TRUE(check_pairs({"99999999999999999999.png", "1.png"}, {"1.png", "2.png"}));
}

}  // namespace
}  // namespace kambara
