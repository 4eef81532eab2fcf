// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/target.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

namespace kambara {
namespace {

TEST(Target, ShortFormsAreReadAndWritten) {
    const auto board = parse_target("chessboard:9x6:30");
    ASSERT_TRUE(board);
    EXPECT_EQ(std::get<ChessboardTarget>(*board), (ChessboardTarget{9, 6, 30.0}));
    EXPECT_EQ(to_string(*parse_target("chessboard:7x5:25.4")), "chessboard:7x5:25.4");
    EXPECT_EQ(to_string(*parse_target("two-plane-24")), "two-plane-24");
}

TEST(Target, OthersAreRefusedWithWhatWouldDo) {
    for (const char* text : {"", "chess", "chessboard:", "chessboard:9x6", "chessboard:9x6:",
                             "chessboard:9x6:30mm", "chessboard:2x6:30", "chessboard:9x6:-1",
                             "chessboard:9x6:nan", "chessboard:9x600:30", "two-plane-25"}) {
        const auto target = parse_target(text);
        ASSERT_FALSE(target) << text;
        EXPECT_FALSE(target.error().remedy.empty());
    }
}

TEST(Target, AChessboardsCornersGoRowByRow) {
    const auto corners = corners_in_target_mm(ChessboardTarget{9, 6, 30.0});
    ASSERT_EQ(corners.size(), 54U);
    EXPECT_EQ(corners[0], Eigen::Vector3d(0, 0, 0));
    EXPECT_EQ(corners[1], Eigen::Vector3d(30, 0, 0));
    EXPECT_EQ(corners[9], Eigen::Vector3d(0, 30, 0));
    EXPECT_EQ(corners.back(), Eigen::Vector3d(240, 150, 0));
}

// The drawing's numbers: boxes 50 x 70, pitch 75 x 95, the edge at x = 225.
TEST(Target, TheTwoPlaneTargetIsAsDrawn) {
    const auto c = corners_in_target_mm(two_plane_24());
    ASSERT_EQ(c.size(), 96U);
    EXPECT_EQ(c[0], Eigen::Vector3d(0, 0, 0));
    EXPECT_EQ(c[1], Eigen::Vector3d(50, 0, 0));
    EXPECT_EQ(c[2], Eigen::Vector3d(50, 70, 0));
    EXPECT_EQ(c[3], Eigen::Vector3d(0, 70, 0));
    EXPECT_EQ(c[4 * 2 + 1], Eigen::Vector3d(200, 0, 0));        // third box of the left plane
    EXPECT_EQ(c[4 * 3], Eigen::Vector3d(225, 0, -25));          // first of the right plane
    EXPECT_EQ(c[4 * 5 + 1], Eigen::Vector3d(225, 0, -225));     // its last
    EXPECT_EQ(c[4 * 6], Eigen::Vector3d(0, 95, 0));             // second row
    EXPECT_EQ(c[4 * 23 + 2], Eigen::Vector3d(225, 355, -225));  // the very last box
}

TEST(Target, ThePatchesCoverWhatTheCornersSay) {
    const Target target = two_plane_24();
    const auto corners = corners_in_target_mm(target);
    std::size_t next = 0;
    int sheets = 0;
    for (const TargetPatch& patch : patches_of(target)) {
        if (patch.sheet) {
            ++sheets;
            continue;
        }
        EXPECT_LT((patch.origin_mm - corners[next]).norm(), 1e-9);
        EXPECT_LT((patch.origin_mm + patch.across_mm + patch.down_mm - corners[next + 2]).norm(),
                  1e-9);
        next += 4;
    }
    EXPECT_EQ(sheets, 2);
    EXPECT_EQ(next, corners.size());
    // A board of 9 x 6 inner corners has 10 x 7 squares, half of them dark.
    EXPECT_EQ(patches_of(ChessboardTarget{9, 6, 30.0}).size(), 1U + 35U);
}

TEST(Target, CharucoBoardsAreReadAndWritten) {
    const auto target = parse_target("charuco:5x7:40:20:DICT_6X6_250");
    ASSERT_TRUE(target);
    EXPECT_EQ(*target, Target(CharucoTarget{5, 7, 40.0, 20.0, "DICT_6X6_250"}));
    EXPECT_EQ(to_string(*target), "charuco:5x7:40:20:DICT_6X6_250");
    const auto corners = corners_in_target_mm(*target);
    ASSERT_EQ(corners.size(), 24U);
    EXPECT_EQ(corners[4], Eigen::Vector3d(0, 40, 0));
    for (const char* text : {"charuco:5x7:40:40:DICT_6X6_250", "charuco:5x7:40:20:DICT_6X6",
                             "charuco:5x7:40:20", "charuco:30x30:40:20:DICT_6X6_250"}) {
        EXPECT_FALSE(parse_target(text)) << text;
    }
}

// Squares, markers and their light cells: 35 squares, 18 of them dark, 17 with markers.
TEST(Target, ACharucoBoardIsDrawnWithItsMarkers) {
    const auto patches = patches_of(CharucoTarget{});
    EXPECT_TRUE(patches[0].sheet);
    int dark = 0;
    for (const TargetPatch& patch : patches) {
        dark += patch.dark ? 1 : 0;
    }
    EXPECT_EQ(dark, 18 + 17);
}

TEST(Target, MeasuredCornersStandWhereTheyWereMeasured) {
    Target target = two_plane_24();
    accuracy_of(target) = {0.02, {{5, {75.3, 0.1, -0.2}, 0.004}}};
    EXPECT_EQ(target_fault(target), "");
    EXPECT_EQ(corners_in_target_mm(target)[5], Eigen::Vector3d(75.3, 0.1, -0.2));
    EXPECT_EQ(drawn_corners_mm(target)[5], Eigen::Vector3d(125, 0, 0));
    EXPECT_EQ(corner_sigmas_mm(target)[5], 0.004);
    EXPECT_EQ(corner_sigmas_mm(target)[6], 0.02);
    accuracy_of(target).measured.push_back({96, {1, 2, 3}, 0.1});
    EXPECT_NE(target_fault(target).find("no corner 96"), std::string::npos);
}

// Three planes of two columns, 120 degrees inside: a half hexagon's run.
TEST(Target, PlanesFollowEachOtherAtTheirAngles) {
    BoxTarget target;
    target.rows = 2;
    target.planes = {{2, 180, 0, 10}, {2, 120, 10, 10}, {2, 120, 10, 0}};
    const auto frames = plane_frames(target);
    ASSERT_EQ(frames.size(), 3U);
    EXPECT_LT((frames[1].across - Eigen::Vector3d(0.5, 0, -std::sqrt(0.75))).norm(), 1e-12);
    EXPECT_LT((frames[2].across - Eigen::Vector3d(-0.5, 0, -std::sqrt(0.75))).norm(), 1e-12);
    const Eigen::Vector3d edge(135, 0, 0);  // two boxes and the gap
    EXPECT_LT((frames[1].origin_mm - (edge + 10.0 * frames[1].across)).norm(), 1e-12);
}

}  // namespace
}  // namespace kambara
