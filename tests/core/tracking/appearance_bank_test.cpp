// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/appearance_bank.h"

#include <gtest/gtest.h>

#include <memory>

#include "core/camera/nominal_rig.h"
#include "tests/support/textured_plane.h"

namespace kambara {
namespace {

ReferencePatch numbered(int number) {
    ReferencePatch patch;
    patch.left_grey = std::make_shared<const Image>(64, 64, 1, 90);
    patch.centre_px = {number, 32.0};
    patch.size_px = {15, 15};
    patch.point_in_rig_mm = {0.0, 0.0, 1500.0};
    return patch;
}

TEST(AppearanceBank, NeverGrowsPastItsRoomAndNeverDropsTheFirst) {
    AppearanceBank bank(numbered(0), 3);
    for (int i = 1; i <= 10; ++i) {
        bank.add(numbered(i));
        EXPECT_LE(bank.size(), 3U);
        EXPECT_EQ(bank.first().centre_px.x(), 0.0);
        EXPECT_EQ(bank.at(bank.size() - 1).centre_px.x(), i);
    }
}

TEST(AppearanceBank, DropsWhatHasNotFittedForLongest) {
    AppearanceBank bank(numbered(0), 3);
    bank.add(numbered(1));
    bank.add(numbered(2));
    bank.used(1);
    bank.add(numbered(3));
    ASSERT_EQ(bank.size(), 3U);
    EXPECT_EQ(bank.at(1).centre_px.x(), 1.0);
    EXPECT_EQ(bank.at(2).centre_px.x(), 3.0);
    EXPECT_EQ(bank.later_by_use(), (std::vector<std::size_t>{2, 1}));
}

TEST(AppearanceBank, TheMeanTakesItsShareOfWhatIsSeenAndStays) {
    const Rig rig = nominal_rig();
    const auto dark = std::make_shared<const Image>(rig.left.width_px, rig.left.height_px, 1, 40);
    const Image light(rig.left.width_px, rig.left.height_px, 1, 140);
    const Eigen::Vector2d middle(320.0, 240.0);
    const auto place = place_at_depth(rig.left, middle, 1500.0);
    ASSERT_TRUE(place);
    AppearanceBank bank({dark, middle, {15, 15}, *place}, 2);
    EXPECT_EQ(bank.anchors(), 1U);
    bank.blend(rig.left, light, *place, 0.1);
    ASSERT_EQ(bank.anchors(), 2U);
    const auto grey_of_mean = [&] { return bank.at(1).left_grey->at(7, 7); };
    EXPECT_EQ(grey_of_mean(), 50);
    bank.blend(rig.left, light, *place, 0.1);
    EXPECT_EQ(grey_of_mean(), 59);
    bank.add(numbered(1));
    bank.add(numbered(2));
    EXPECT_EQ(bank.anchors(), 2U);
    EXPECT_EQ(grey_of_mean(), 59);
    EXPECT_EQ(bank.first().left_grey, dark);
}

TEST(AppearanceBank, AllLooksTurnAndGrowTogether) {
    AppearanceBank bank(numbered(0));
    bank.add(numbered(1));
    bank.change({1.1, 0.2});
    bank.change({1.1, -0.1});
    for (std::size_t i = 0; i < bank.size(); ++i) {
        EXPECT_NEAR(bank.at(i).change.scale, 1.21, 1e-12);
        EXPECT_NEAR(bank.at(i).change.turn_rad, 0.1, 1e-12);
    }
}

}  // namespace
}  // namespace kambara
