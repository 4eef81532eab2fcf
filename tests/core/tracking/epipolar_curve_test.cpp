// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/epipolar_curve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/camera/nominal_rig.h"

namespace kambara {
namespace {

bool at_border(const EpipolarSample& sample) {
    const Eigen::Vector2d& p = sample.right_px;
    return p.x() < 3.0 || p.y() < 3.0 || p.x() > 636.0 || p.y() > 476.0;
}

TEST(EpipolarCurve, LiesOnTheLeftRayAndHasNoGaps) {
    const Rig rig = nominal_rig();
    std::mt19937 random(1);
    std::uniform_real_distribution<double> x(20, 620);
    std::uniform_real_distribution<double> y(20, 460);
    int seen = 0;
    for (int i = 0; i < 50; ++i) {
        const Eigen::Vector2d left_px(x(random), y(random));
        const auto curve = epipolar_curve(rig, left_px, {400.0, 1e6}, 3.0);
        for (std::size_t k = 0; k < curve.size(); ++k) {
            EXPECT_LT((*rig.left.project(curve[k].point_in_rig_mm) - left_px).norm(), 1e-6);
            EXPECT_LT((*rig.right->project(curve[k].point_in_rig_mm) - curve[k].right_px).norm(),
                      1e-9);
            // Only where the curve leaves the picture and comes back is there a gap.
            const bool leaves = k > 0 && (at_border(curve[k]) && at_border(curve[k - 1]));
            if (k > 0 && !leaves) {
                EXPECT_LE((curve[k].right_px - curve[k - 1].right_px).norm(), 3.0 + 1e-9);
            }
        }
        seen += curve.empty() ? 0 : 1;
    }
    EXPECT_GT(seen, 40);
}

TEST(EpipolarCurve, PassesThroughEveryPointOfTheRay) {
    const Rig rig = nominal_rig();
    const Eigen::Vector2d left_px(420.0, 90.0);
    const auto curve = epipolar_curve(rig, left_px, {400.0, 1e6}, 2.0);
    for (const double range_mm : {700.0, 1500.0, 8000.0}) {
        const auto pixel = rig.right->project(rig.left.unproject(left_px)->at(range_mm));
        ASSERT_TRUE(pixel);
        double nearest = 1e9;
        for (const auto& sample : curve) {
            nearest = std::min(nearest, (sample.right_px - *pixel).norm());
        }
        EXPECT_LE(nearest, 1.0 + 1e-6);  // half a step
    }
}

TEST(EpipolarCurve, BendsWithTheLensAndIsNoHorizontalRow) {
    const Rig rig = nominal_rig();
    const auto curve = epipolar_curve(rig, {560.0, 60.0}, {500.0, 1e6}, 2.0);
    ASSERT_GT(curve.size(), 20U);
    // How far its middle lies from the line between its ends.
    const Eigen::Vector2d a = curve.front().right_px;
    const Eigen::Vector2d along = (curve.back().right_px - a).normalized();
    double farthest = 0.0;
    for (const auto& sample : curve) {
        const Eigen::Vector2d d = sample.right_px - a;
        farthest = std::max(farthest, std::abs(along.x() * d.y() - along.y() * d.x()));
    }
    EXPECT_GT(farthest, 2.0);
    EXPECT_GT(std::abs(curve.front().right_px.y() - curve.back().right_px.y()), 3.0);
}

TEST(EpipolarCurve, IsEmptyWhereTheRightCameraSeesNothing) {
    const Rig rig = nominal_rig();
    // The far left of the left picture, near by: outside the right one.
    EXPECT_TRUE(epipolar_curve(rig, {5.0, 240.0}, {250.0, 400.0}, 2.0).empty());
}

}  // namespace
}  // namespace kambara
