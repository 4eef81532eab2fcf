// SPDX-License-Identifier: GPL-3.0-or-later
// Printed targets as a printer sees them: pages drawn by an independent program at a known number
// of pixels a millimetre, then found and measured by the detectors.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/calibration/target_detector.h"
#include "core/calibration/target_file.h"
#include "hardware/media/picture_file.h"
#include "tests/support/process.h"

namespace kambara {
namespace {

namespace fs = std::filesystem;
using testing_support::fresh_folder;
using testing_support::run_program;
using testing_support::text_of;

constexpr double most_error_mm = 0.1;

struct Printed {
    nlohmann::json told;
    std::vector<Image> pages;
};

class TargetPdfTest : public testing::Test {
  protected:
    void SetUp() override {
        folder_ = fresh_folder(testing::UnitTest::GetInstance()->current_test_info()->name());
    }
    void TearDown() override { fs::remove_all(folder_); }

    // Empty where the target could not be printed or drawn; the test has failed then.
    Printed printed(const std::string& target, int px_per_10_mm, std::size_t pages) {
        Printed result;
        const auto made = run_program(
            KAMBARA_CLI, {"target", "--target", target, "--out", "target.pdf", "--json", "t.json"},
            folder_);
        EXPECT_EQ(made.exit_code, 0) << made.errors;
        result.told = nlohmann::json::parse(text_of(folder_ / "t.json"));
        const auto drawn = run_program(
            "pdftoppm", {"-r", std::to_string(2.54 * px_per_10_mm), "-gray", "target.pdf", "page"},
            folder_);
        EXPECT_EQ(drawn.exit_code, 0) << drawn.errors;
        for (std::size_t i = 1; i <= pages; ++i) {
            const auto page = read_picture(folder_ / ("page-" + std::to_string(i) + ".pgm"));
            EXPECT_TRUE(page);
            if (page) {
                result.pages.push_back(grey_from(*page));
            }
        }
        return result;
    }

    // Every corner at its place on the page, where the sheet's first one is at `first_mm` from the
    // page's corner. Pixel centres are whole numbers; a page begins at -0.5.
    void expect_true_to_scale(const Image& page, const Target& target,
                              const Eigen::Vector2d& first_mm, double px_per_mm) {
        const auto corners = detect_target(page, target);
        ASSERT_TRUE(corners) << corners.error().text();
        const auto at = corners_in_target_mm(target);
        EXPECT_EQ(corners->size(), at.size());
        for (const DetectedCorner& corner : *corners) {
            const Eigen::Vector2d mm = (corner.px + Eigen::Vector2d(0.5, 0.5)) / px_per_mm;
            const Eigen::Vector2d due =
                first_mm + at[static_cast<std::size_t>(corner.id)].head<2>();
            EXPECT_LT((mm - due).norm(), most_error_mm) << corner.id;
            worst_mm_ = std::max(worst_mm_, (mm - due).norm());
        }
    }

    Eigen::Vector2d sheet_at_mm(const Printed& print, std::size_t page) {
        const auto& at = print.told["pages"][page]["sheet_at_mm"];
        return {at[0].get<double>(), at[1].get<double>()};
    }

    fs::path folder_;
    double worst_mm_ = 0.0;
};

TEST_F(TargetPdfTest, BothPlanesOfTheBoxTargetAreFoundAtTheirTrueSize) {
    const Printed print = printed("two-plane-24", 40, 2);
    ASSERT_EQ(print.pages.size(), 2U);
    BoxTarget one = two_plane_24();
    one.planes = {{3, 180.0, 0.0, 0.0}};
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_NEAR(print.pages[i].width(), 4 * 297, 1);
        EXPECT_NEAR(print.pages[i].height(), 4 * 420, 1);
        expect_true_to_scale(print.pages[i], one,
                             sheet_at_mm(print, i) + Eigen::Vector2d(25.0, 25.0), 4.0);
    }
    RecordProperty("worst_mm", std::to_string(worst_mm_));
}

TEST_F(TargetPdfTest, LightBoxesOnADarkSheetAreFound) {
    BoxTarget one = two_plane_24();
    one.planes = {{3, 180.0, 0.0, 0.0}};
    one.dark_on_light = false;
    ASSERT_TRUE(write_target_file(folder_ / "light.yaml", one));
    const Printed print = printed("light.yaml", 40, 1);
    ASSERT_EQ(print.pages.size(), 1U);
    expect_true_to_scale(print.pages[0], one, sheet_at_mm(print, 0) + Eigen::Vector2d(25.0, 25.0),
                         4.0);
}

TEST_F(TargetPdfTest, AChessboardIsFoundAtItsTrueSize) {
    const Printed print = printed("chessboard:9x6:25", 40, 1);
    ASSERT_EQ(print.pages.size(), 1U);
    EXPECT_EQ(print.told["paper"], "A4");
    EXPECT_NEAR(print.pages[0].width(), 4 * 297, 1);  // turned
    expect_true_to_scale(print.pages[0], ChessboardTarget{9, 6, 25.0},
                         sheet_at_mm(print, 0) + Eigen::Vector2d(25.0, 25.0), 4.0);
    RecordProperty("worst_mm", std::to_string(worst_mm_));
}

TEST_F(TargetPdfTest, ACharucoBoardIsFoundAtItsTrueSize) {
    for (const char* dictionary : {"DICT_6X6_250", "DICT_4X4_50"}) {
        const std::string board = std::string("charuco:5x7:40:20:") + dictionary;
        const Printed print = printed(board, 40, 1);
        ASSERT_EQ(print.pages.size(), 1U);
        expect_true_to_scale(print.pages[0], *parse_target(board),
                             sheet_at_mm(print, 0) + Eigen::Vector2d(40.0, 40.0), 4.0);
    }
    RecordProperty("worst_mm", std::to_string(worst_mm_));
}

// The ruler itself: its line, and a tick at either end, 200 mm apart.
TEST_F(TargetPdfTest, TheRulerIsAsLongAsItSays) {
    const Printed print = printed("charuco:5x7:40:20:DICT_6X6_250", 100, 1);
    ASSERT_EQ(print.pages.size(), 1U);
    const Image& page = print.pages[0];
    // Below the pattern, the first row that is dark from end to end is the ruler's line.
    const int below = static_cast<int>(10.0 * (sheet_at_mm(print, 0).y() + 280.0)) + 10;
    const auto dark = [&](int x, int y) { return page.at(x, y) < 128; };
    int row = below;
    while (row < page.height() && !dark(1000, row)) {
        ++row;
    }
    ASSERT_LT(row, page.height());
    // 3 mm lower only the ticks of 10 mm are left.
    int first = 0;
    while (first < page.width() && !dark(first, row + 35)) {
        ++first;
    }
    int last = first;
    int ticks = 0;
    for (int x = first; x < first + 2200 && x < page.width(); ++x) {
        if (dark(x, row + 35) && !dark(x - 1, row + 35)) {
            ++ticks;
            last = x;
        }
    }
    EXPECT_EQ(ticks, 21);
    EXPECT_NEAR(last - first, 2000, 10.0 * most_error_mm);
}

TEST_F(TargetPdfTest, WhatDoesNotFitIsRefusedAndNothingIsWritten) {
    const auto refused = run_program(
        KAMBARA_CLI, {"target", "--target", "two-plane-24", "--paper", "A4", "--out", "t.pdf"},
        folder_);
    EXPECT_EQ(refused.exit_code, 1);
    EXPECT_NE(refused.errors.find("A3"), std::string::npos);
    EXPECT_FALSE(fs::exists(folder_ / "t.pdf"));
}

}  // namespace
}  // namespace kambara
