// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/point_list.h"

#include <gtest/gtest.h>

namespace kambara {
namespace {

TEST(PointList, OneCamerasLinesAreRead) {
    const auto list = point_list_from_text("# target\n\n1 2 3 4.5 5\n-1,2e1;+3\t4 5 # corner\r\n");
    ASSERT_TRUE(list) << list.error().text();
    ASSERT_EQ(list->left.size(), 2U);
    EXPECT_TRUE(list->right.empty());
    EXPECT_EQ(list->lines, (std::vector<int>{3, 4}));
    EXPECT_EQ(list->left[1].in_world_mm, Eigen::Vector3d(-1, 20, 3));
    EXPECT_EQ(list->left[0].seen_px, Eigen::Vector2d(4.5, 5));
}

TEST(PointList, TwoCamerasLinesAreRead) {
    const auto list = point_list_from_text("1 2 3 4 5 6 7");
    ASSERT_TRUE(list);
    EXPECT_EQ(list->left[0].seen_px, Eigen::Vector2d(4, 5));
    EXPECT_EQ(list->right[0].seen_px, Eigen::Vector2d(6, 7));
    EXPECT_EQ(list->right[0].in_world_mm, Eigen::Vector3d(1, 2, 3));
}

TEST(PointList, AnythingElseIsRefusedByLine) {
    for (const char* text :
         {"1 2 3 4\n", "1 2 3 4 5 6\n", "1 2 3 4 5 6 7 8\n", "1 2 3 4 x\n", "1 2 3 4 5mm\n",
          "1 2 3 nan 5\n", "1 2 3 4 inf\n", "1 2 3 4 1e999\n"}) {
        const auto list = point_list_from_text(text);
        ASSERT_FALSE(list) << text;
        EXPECT_NE(list.error().cause.find("Line 1"), std::string::npos) << list.error().cause;
        EXPECT_FALSE(list.error().remedy.empty());
    }
    const auto mixed = point_list_from_text("1 2 3 4 5\n1 2 3 4 5 6 7\n");
    ASSERT_FALSE(mixed);
    EXPECT_NE(mixed.error().cause.find("Line 2"), std::string::npos);
    EXPECT_FALSE(point_list_from_text(""));
    EXPECT_FALSE(point_list_from_text("# nothing\n"));
}

}  // namespace
}  // namespace kambara
