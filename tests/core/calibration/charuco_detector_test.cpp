// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/charuco_detector.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/calibration/target_detector.h"

namespace kambara {
namespace {

constexpr int samples = 6;  // a pixel, each way

// The grey of the target's surface at a point, mm.
double grey_at(const std::vector<TargetPatch>& patches, double x, double y) {
    double grey = 128.0;
    for (const TargetPatch& patch : patches) {
        const double u = x - patch.origin_mm.x();
        const double v = y - patch.origin_mm.y();
        if (u >= 0.0 && v >= 0.0 && u < patch.across_mm.x() && v < patch.down_mm.y()) {
            grey = patch.dark ? 30.0 : 220.0;
        }
    }
    return grey;
}

// The board seen straight on: `px_per_mm`, its first inner corner at (x0, y0).
Image picture_of(const Target& target, double x0, double y0, double px_per_mm) {
    const auto patches = patches_of(target);
    Image picture(320, 320, 1);
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            double sum = 0.0;
            for (int i = 0; i < samples * samples; ++i) {
                // Over one and a half pixels: lenses blur that much.
                const double dx = 1.5 * ((i % samples + 0.5) / samples - 0.5);
                const double dy = 1.5 * ((i / samples + 0.5) / samples - 0.5);
                sum += grey_at(patches, (x + dx - x0) / px_per_mm, (y + dy - y0) / px_per_mm);
            }
            picture.at(x, y) = static_cast<std::uint8_t>(std::lround(sum / (samples * samples)));
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
        detect_target(picture_of(CharucoTarget{}, 80.3, 60.7, 0.9), CharucoTarget{});
    ASSERT_TRUE(corners) << corners.error().text();
    EXPECT_EQ(corners->size(), 24U);
    expect_in_place(*corners, 80.3, 60.7, 0.9);
}

TEST(CharucoDetector, APartOfTheBoardIsEnough) {
    // Moved out to the left and the top: two columns and two rows are gone.
    const auto corners = detect_charuco(picture_of(CharucoTarget{}, -45.2, -50.4, 1.1), {});
    ASSERT_TRUE(corners) << corners.error().text();
    EXPECT_GE(corners->size(), 6U);
    EXPECT_LT(corners->size(), 24U);
    expect_in_place(*corners, -45.2, -50.4, 1.1);
}

TEST(CharucoDetector, SaysWhatIsWrong) {
    EXPECT_NE(detect_charuco(Image(320, 240, 1, 128), {}).error().cause.find("No marker"),
              std::string::npos);
    EXPECT_FALSE(detect_charuco(picture_of(ChessboardTarget{4, 6, 40.0}, 80, 60, 0.9), {}));
    EXPECT_NE(detect_target(Image(320, 240, 1, 128), PointTarget{}).error().cause.find("points"),
              std::string::npos);
}

}  // namespace
}  // namespace kambara
