// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/patch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "core/camera/nominal_rig.h"
#include "core/tracking/patch_search.h"
#include "tests/support/textured_plane.h"

namespace kambara {
namespace {

using testing_support::drawn;
using testing_support::TexturedPlane;

constexpr double range_z_mm = 1500.0;

// The point of the plane z = range that the left camera sees at the pixel.
Eigen::Vector3d on_plane(const Rig& rig, const Eigen::Vector2d& left_px, double z_mm) {
    const Ray ray = *rig.left.unproject(left_px);
    return ray.at(z_mm / ray.direction.z());
}

class PatchTest : public testing::Test {
  protected:
    PatchTest()
        : rig_(nominal_rig()),
          left_(std::make_shared<const Image>(drawn(plane_, rig_.left))),
          patch_{left_, {220.0, 200.0}, {31, 31}, on_plane(rig_, {220.0, 200.0}, range_z_mm)} {}

    double mean_difference(const RenderedPatch& drawn_patch, const Image& picture) const {
        double sum = 0.0;
        for (int y = 0; y < drawn_patch.picture.height(); ++y) {
            for (int x = 0; x < drawn_patch.picture.width(); ++x) {
                sum += std::abs(
                    drawn_patch.picture.at(x, y) -
                    picture.at(drawn_patch.top_left.x() + x, drawn_patch.top_left.y() + y));
            }
        }
        return sum / (drawn_patch.picture.width() * drawn_patch.picture.height());
    }

    TexturedPlane plane_{{0.0, 0.0, range_z_mm}};
    Rig rig_;
    ImagePtr left_;
    ReferencePatch patch_;
};

TEST_F(PatchTest, IsTheReferenceItselfWhereItWasCut) {
    const auto same = render_patch(patch_, rig_.left, rig_.left, patch_.point_in_rig_mm);
    ASSERT_TRUE(same);
    EXPECT_EQ(same->picture.width(), 31);
    EXPECT_EQ(same->top_left, Eigen::Vector2i(205, 185));
    for (int y = 0; y < 31; ++y) {
        for (int x = 0; x < 31; ++x) {
            EXPECT_EQ(same->picture.at(x, y), left_->at(205 + x, 185 + y));
        }
    }
}

TEST_F(PatchTest, LooksAsTheSceneDoesInTheOtherCamera) {
    const Image right = drawn(plane_, *rig_.right);
    const auto there = render_patch(patch_, rig_.left, *rig_.right, patch_.point_in_rig_mm);
    ASSERT_TRUE(there);
    EXPECT_LT(mean_difference(*there, right), 1.5);
}

TEST_F(PatchTest, LooksAsTheSceneDoesFarAcrossTheFieldAndNearer) {
    const Eigen::Vector3d shift(650.0, -180.0, -350.0);
    TexturedPlane moved = plane_;
    moved.origin_in_rig_mm += shift;
    const Image left = drawn(moved, rig_.left);
    const auto there = render_patch(patch_, rig_.left, rig_.left, patch_.point_in_rig_mm + shift);
    ASSERT_TRUE(there);
    EXPECT_GT(there->picture.width(), 31);  // nearer is larger
    EXPECT_LT(mean_difference(*there, left), 2.0);
}

TEST_F(PatchTest, IsNotDrawnWhereTheCameraDoesNotLook) {
    EXPECT_FALSE(render_patch(patch_, rig_.left, rig_.left, {0, 0, -500}));
    EXPECT_FALSE(render_patch(patch_, rig_.left, rig_.left, {5000, 0, 1000}));
}

// The point of it all: the lens bends the template across the field, and the place is found to a
// few hundredths of a pixel all the same.
TEST_F(PatchTest, IsFoundToAFewHundredthsOfAPixelAcrossTheField) {
    for (const auto& [x_mm, y_mm, z_mm] : {std::tuple{0.4, 0.3, 0.0},
                                           {250.7, 40.2, 30.0},
                                           {420.3, -120.6, 200.0},
                                           {640.1, 90.9, -200.0},
                                           {-130.8, 150.5, 400.0}}) {
        const Eigen::Vector3d shift(x_mm, y_mm, z_mm);
        TexturedPlane moved = plane_;
        moved.origin_in_rig_mm += shift;
        const Eigen::Vector3d place = patch_.point_in_rig_mm + shift;
        const Image left = drawn(moved, rig_.left);
        const auto truth = rig_.left.project(place);
        ASSERT_TRUE(truth);
        const Eigen::Vector3d guess = place + Eigen::Vector3d(14.0, -9.0, 0.0);
        const auto found = search_window(patch_, rig_.left, rig_.left, left, {guess, 12, 0.0},
                                         PatchSearchOptions{});
        ASSERT_TRUE(found);
        EXPECT_LT((found->pixel - *truth).norm(), 0.05);
        EXPECT_GT(found->quality, 0.98);
    }
}

TEST_F(PatchTest, IsFoundAlongTheEpipolarCurveWithoutAKnownDistance) {
    const Image right = drawn(plane_, *rig_.right);
    for (const Eigen::Vector2d& left_px :
         {Eigen::Vector2d(220, 200), Eigen::Vector2d(330, 90), Eigen::Vector2d(450, 400)}) {
        const ReferencePatch patch{left_, left_px, {31, 31}, on_plane(rig_, left_px, 900.0)};
        const auto found =
            search_epipolar(patch, rig_, right, {600.0, 1e6}, 2, PatchSearchOptions{});
        const auto truth = rig_.right->project(on_plane(rig_, left_px, range_z_mm));
        ASSERT_TRUE(found && truth);
        EXPECT_LT((found->pixel - *truth).norm(), 0.05);
        EXPECT_GT(found->distinctness, 0.05);
    }
}

}  // namespace
}  // namespace kambara
