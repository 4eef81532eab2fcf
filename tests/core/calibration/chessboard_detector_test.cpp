// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/chessboard_detector.h"

#include <gtest/gtest.h>

#include <cmath>

namespace kambara {
namespace {

// One row of squares, from the one before the first corner to the one behind the last: the mean
// over a pixel, which sees 2 px (lenses blur that much), of the share on the board and of the
// squares' sign.
struct Row {
    double share = 0.0;
    double sign = 0.0;
};

Row mean_over_pixel(double pixel, double first, double square, int corners) {
    constexpr int samples = 400;
    Row row;
    for (int i = 0; i < samples; ++i) {
        const double u = (pixel + (2.0 * i + 1.0) / samples - 1.0 - first) / square;
        if (u >= -1.0 && u < corners) {
            row.share += 1.0 / samples;
            row.sign += (static_cast<int>(std::floor(u)) % 2 == 0 ? 1.0 : -1.0) / samples;
        }
    }
    return row;
}

// A board seen straight on: squares of `square` px, the first inner corner at (x0, y0).
Image board(double x0, double y0, double square, int across, int down) {
    Image picture(320, 240, 1);
    for (int y = 0; y < picture.height(); ++y) {
        const Row v = mean_over_pixel(y, y0, square, down);
        for (int x = 0; x < picture.width(); ++x) {
            const Row u = mean_over_pixel(x, x0, square, across);
            const double dark = 0.5 * (u.share * v.share + u.sign * v.sign);
            picture.at(x, y) = static_cast<std::uint8_t>(std::lround(220.0 - 190.0 * dark));
        }
    }
    return picture;
}

TEST(ChessboardDetector, FindsTheCornersToAFiftiethOfAPixel) {
    const double x0 = 60.37;
    const double y0 = 50.81;
    const double square = 20.3;
    const auto corners = detect_chessboard(board(x0, y0, square, 9, 6), {9, 6, 30.0});
    ASSERT_TRUE(corners) << corners.error().text();
    ASSERT_EQ(corners->size(), 54U);
    const bool reversed = corners->front().px.x() > corners->back().px.x();
    for (int i = 0; i < 54; ++i) {
        const auto& found = (*corners)[static_cast<std::size_t>(reversed ? 53 - i : i)].px;
        EXPECT_NEAR(found.x(), x0 + square * (i % 9), 0.02);
        EXPECT_NEAR(found.y(), y0 + square * (i / 9), 0.02);
    }
}

TEST(ChessboardDetector, SaysWhatIsWrong) {
    EXPECT_NE(detect_chessboard(Image(320, 240, 1, 128), {9, 6, 30.0})
                  .error()
                  .cause.find("9 x 6 inner corners"),
              std::string::npos);
    // Partly outside.
    EXPECT_FALSE(detect_chessboard(board(-30.0, 50.0, 20.0, 9, 6), {9, 6, 30.0}));
    // Another board.
    EXPECT_FALSE(detect_chessboard(board(60.0, 50.0, 20.0, 7, 6), {9, 6, 30.0}));
}

}  // namespace
}  // namespace kambara
