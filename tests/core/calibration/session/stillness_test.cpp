// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/session/stillness.h"

#include <gtest/gtest.h>

#include "core/calibration/session/shot_checks.h"

namespace kambara {
namespace {

// Four corners in both fixed cameras, moved so far in each.
RigView square(double left_px, double right_px) {
    RigView view;
    for (int id = 0; id < 4; ++id) {
        const Eigen::Vector2d at(100.0 + 50.0 * (id % 2), 80.0 + 50.0 * (id / 2));
        view.sights[0].corners.push_back({id, at + Eigen::Vector2d(left_px, 0.0), 0.1, 2.0});
        view.sights[1].corners.push_back({id, at + Eigen::Vector2d(0.0, right_px), 0.1, 2.0});
    }
    return view;
}

TEST(Stillness, DistanceIsTheRootMeanSquareOfTheSharedCorners) {
    auto a = square(0.0, 0.0).sights[0].corners;
    auto b = square(3.0, 0.0).sights[0].corners;
    EXPECT_DOUBLE_EQ(*distance_px(a, b), 3.0);
    b.erase(b.begin());
    EXPECT_DOUBLE_EQ(*distance_px(a, b), 3.0);
    b.resize(1);
    EXPECT_FALSE(distance_px(a, b));
    EXPECT_FALSE(distance_px({}, {}));
}

TEST(Stillness, NeedsSeveralPairsInARow) {
    Stillness stillness({0.5, 3});
    EXPECT_FALSE(stillness.still_after(square(0.0, 0.0)));
    EXPECT_FALSE(stillness.still_after(square(0.1, 0.0)));
    EXPECT_FALSE(stillness.still_after(square(0.0, 0.1)));
    EXPECT_TRUE(stillness.still_after(square(0.1, 0.1)));
    EXPECT_TRUE(stillness.still_after(square(0.0, 0.0)));
    EXPECT_FALSE(stillness.still_after(square(0.0, 2.0)));
    stillness.forget();
    EXPECT_FALSE(stillness.still_after(square(0.0, 2.0)));
}

TEST(Stillness, SlowDriftIsMotion) {
    Stillness stillness({0.5, 3});
    for (int i = 0; i < 20; ++i) {
        EXPECT_FALSE(stillness.still_after(square(0.2 * i, 0.0))) << i;
    }
}

TEST(ShotChecks, NameTheCameraAtFault) {
    RigView view = square(0.0, 0.0);
    EXPECT_EQ(not_found(view, {true, true, false}), "");
    EXPECT_NE(not_found(view, {true, true, true}).find("pan_tilt"), std::string::npos);
    view.sights[1].corners.clear();
    view.sights[1].fault = "Two boxes are hidden.";
    EXPECT_EQ(not_found(view, {true, true, false}),
              "The right camera does not find the target: Two boxes are hidden.");
}

TEST(ShotChecks, TellBlurAndUncertainCorners) {
    RigView view = square(0.0, 0.0);
    EXPECT_EQ(not_sharp(view, {}), "");
    for (auto& corner : view.sights[1].corners) {
        corner.blur_px = 5.0;
    }
    EXPECT_NE(not_sharp(view, {}).find("right picture is blurred"), std::string::npos);
    for (auto& corner : view.sights[0].corners) {
        corner.sigma_px = 0.9;
    }
    EXPECT_NE(not_sharp(view, {}).find("left picture"), std::string::npos);
}

TEST(ShotChecks, ARepeatLiesCloseInEveryCamera) {
    EXPECT_TRUE(repeats(square(5.0, 5.0), square(0.0, 0.0), 15.0));
    EXPECT_FALSE(repeats(square(5.0, 20.0), square(0.0, 0.0), 15.0));
    EXPECT_FALSE(repeats(RigView{}, square(0.0, 0.0), 15.0));
}

}  // namespace
}  // namespace kambara
