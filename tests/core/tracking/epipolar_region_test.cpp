// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/epipolar_region.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <set>
#include <utility>

#include "core/camera/nominal_rig.h"

namespace kambara {
namespace {

using Places = std::set<std::pair<int, int>>;

Places places_of(const SearchRegion& region) {
    Places places;
    for (const Rectangle& r : region.positions) {
        for (int y = r.y; y < r.y + r.height; ++y) {
            for (int x = r.x; x < r.x + r.width; ++x) {
                EXPECT_TRUE(places.emplace(x, y).second) << "twice: " << x << ", " << y;
            }
        }
    }
    return places;
}

// Squares about every place of a finely sampled curve.
Places by_definition(const Rig& rig, const Eigen::Vector2d& left_px, const RangeBounds& bounds,
                     int band_px, int width, int height) {
    Places places;
    for (const auto& sample : epipolar_curve(rig, left_px, bounds, 0.5, band_px)) {
        const auto place = top_left_for(sample.right_px, width, height);
        for (int y = -band_px; y <= band_px; ++y) {
            for (int x = -band_px; x <= band_px; ++x) {
                places.emplace(place.x() + x, place.y() + y);
            }
        }
    }
    return places;
}

// The nominal rig's cameras one above the other: the curves run down the picture.
Rig upright_rig() {
    Rig rig = nominal_rig();
    rig.right->T_camera_from_rig = rig.left.T_camera_from_rig;
    rig.right->T_camera_from_rig.t_mm.y() -= 300.0;
    return rig;
}

TEST(EpipolarRegion, IsTheCurveWidenedByTheBandEachPositionOnce) {
    for (const Rig& rig : {nominal_rig(), upright_rig()}) {
        for (const Eigen::Vector2d& left_px :
             {Eigen::Vector2d(320, 240), Eigen::Vector2d(560.3, 60.7), Eigen::Vector2d(500, 430)}) {
            for (const int band_px : {0, 1, 4}) {
                const RangeBounds bounds{400.0, 1e6};
                const auto region = epipolar_region(rig, left_px, bounds, band_px, 14, 19);
                EXPECT_FALSE(region.positions.empty());
                EXPECT_EQ(places_of(region), by_definition(rig, left_px, bounds, band_px, 14, 19));
            }
        }
    }
}

TEST(EpipolarRegion, HoldsTheRightPixelOfEveryDistance) {
    const Rig rig = nominal_rig();
    const Eigen::Vector2d left_px(520.0, 90.0);
    const auto places = places_of(epipolar_region(rig, left_px, {500.0, 9000.0}, 1, 15, 15));
    for (double range_mm = 505.0; range_mm < 9000.0; range_mm *= 1.01) {
        const auto pixel = rig.right->project(rig.left.unproject(left_px)->at(range_mm));
        ASSERT_TRUE(pixel);
        const auto place = top_left_for(*pixel, 15, 15);
        EXPECT_TRUE(!rig.right->sees(*pixel) || places.count({place.x(), place.y()}) == 1)
            << range_mm;
    }
}

TEST(EpipolarRegion, IsFarSmallerThanThePictureAndEmptyWhereNothingIsSeen) {
    const Rig rig = nominal_rig();
    EXPECT_LT(places_of(epipolar_region(rig, {400.0, 200.0}, {400.0, 1e6}, 2, 15, 15)).size(),
              640U * 480U / 40U);
    EXPECT_TRUE(epipolar_region(rig, {5.0, 240.0}, {250.0, 400.0}, 2, 15, 15).positions.empty());
}

}  // namespace
}  // namespace kambara
