// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/charuco_detector.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/calibration/target_detector.h"

namespace kambara {
namespace {

constexpr int fine = 8;   // steps a pixel; all edges below lie on whole steps
constexpr int blur = 12;  // steps over which a pixel sees: lenses blur that much
constexpr int size_px = 320;

// The board seen straight on: `px_per_mm`, its first inner corner at (x0, y0).
Image picture_of(const Target& target, double x0, double y0, double px_per_mm) {
    constexpr int side = (size_px + 2) * fine;  // a pixel more all around
    std::vector<std::uint8_t> steps(static_cast<std::size_t>(side) * side, 128);
    for (const TargetPatch& patch : patches_of(target)) {
        const auto step = [&](double mm, double from) {
            const double px = from + px_per_mm * mm + 1.5;
            return std::clamp(static_cast<int>(std::lround(px * fine)), 0, side);
        };
        const int left = step(patch.origin_mm.x(), x0);
        const int right = step(patch.origin_mm.x() + patch.across_mm.x(), x0);
        const int bottom = step(patch.origin_mm.y() + patch.down_mm.y(), y0);
        for (int y = step(patch.origin_mm.y(), y0); y < bottom; ++y) {
            const auto row = steps.begin() + static_cast<std::ptrdiff_t>(y) * side;
            std::fill(row + left, row + right, static_cast<std::uint8_t>(patch.dark ? 30 : 220));
        }
    }
    Image picture(size_px, size_px, 1);
    for (int y = 0; y < size_px; ++y) {
        for (int x = 0; x < size_px; ++x) {
            const int from_x = (x + 1) * fine + fine / 2 - blur / 2;
            const int from_y = (y + 1) * fine + fine / 2 - blur / 2;
            int sum = 0;
            for (int i = 0; i < blur * blur; ++i) {
                sum +=
                    steps[static_cast<std::size_t>((from_y + i / blur) * side + from_x + i % blur)];
            }
            picture.at(x, y) = static_cast<std::uint8_t>((sum + blur * blur / 2) / (blur * blur));
        }
    }
    return picture;
}

void expect_in_place(const DetectedCorners& corners, double x0, double y0, double px_per_mm) {
    const auto at = corners_in_target_mm(CharucoTarget{});
    for (const DetectedCorner& corner : corners) {
        const Eigen::Vector3d& p = at[static_cast<std::size_t>(corner.id)];
        EXPECT_NEAR(corner.px.x(), x0 + px_per_mm * p.x(), 0.03) << corner.id;
        EXPECT_NEAR(corner.px.y(), y0 + px_per_mm * p.y(), 0.03) << corner.id;
        EXPECT_GT(corner.sigma_px, 0.0);
        EXPECT_LT(corner.sigma_px, 0.1);
    }
}

TEST(CharucoDetector, FindsEveryCornerByItsNumber) {
    const auto corners =
        detect_target(picture_of(CharucoTarget{}, 80.375, 60.75, 0.8), CharucoTarget{});
    ASSERT_TRUE(corners) << corners.error().text();
    EXPECT_EQ(corners->size(), 24U);
    expect_in_place(*corners, 80.375, 60.75, 0.8);
}

TEST(CharucoDetector, APartOfTheBoardIsEnough) {
    // Moved out to the left and the top: two columns and two rows are gone.
    const auto corners = detect_charuco(picture_of(CharucoTarget{}, -45.25, -50.375, 1.2), {});
    ASSERT_TRUE(corners) << corners.error().text();
    EXPECT_GE(corners->size(), 6U);
    EXPECT_LT(corners->size(), 24U);
    expect_in_place(*corners, -45.25, -50.375, 1.2);
}

TEST(CharucoDetector, SaysWhatIsWrong) {
    EXPECT_NE(detect_charuco(Image(320, 240, 1, 128), {}).error().cause.find("No marker"),
              std::string::npos);
    EXPECT_FALSE(detect_charuco(picture_of(ChessboardTarget{4, 6, 40.0}, 80, 60, 0.8), {}));
    EXPECT_NE(detect_target(Image(320, 240, 1, 128), PointTarget{}).error().cause.find("points"),
              std::string::npos);
}

}  // namespace
}  // namespace kambara
