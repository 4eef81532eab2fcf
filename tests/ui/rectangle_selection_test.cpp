// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/video/rectangle_selection.h"

#include <gtest/gtest.h>

#include <random>

namespace kambara::ui {
namespace {

TEST(RectangleSelection, IsTheSameFromAnyCorner) {
    for (const auto& [from, to] : {std::pair<QPointF, QPointF>{{10, 20}, {40, 35}},
                                   {{40, 35}, {10, 20}},
                                   {{10, 35}, {40, 20}}}) {
        RectangleSelection selection({100, 80}, from);
        selection.drag_to(to);
        EXPECT_EQ(selection.rectangle(), (Rectangle{10, 20, 31, 16}));
        EXPECT_TRUE(selection.large_enough());
    }
}

TEST(RectangleSelection, AClickIsNotLargeEnough) {
    RectangleSelection selection({100, 80}, {50, 50});
    EXPECT_FALSE(selection.large_enough());
    selection.drag_to({53, 90});
    EXPECT_FALSE(selection.large_enough());
}

TEST(RectangleSelection, NeverLeavesThePicture) {
    std::mt19937 random(3);
    std::uniform_int_distribution<int> step(-60, 60);
    auto selection = RectangleSelection::centred({100, 80}, 41);
    EXPECT_EQ(selection.rectangle(), (Rectangle{29, 19, 41, 41}));
    for (int i = 0; i < 500; ++i) {
        if (i % 3 == 0) {
            selection.grow(step(random) / 4, step(random) / 4);
        } else {
            selection.move(step(random), step(random));
        }
        EXPECT_TRUE(selection.rectangle().inside(100, 80)) << to_string(selection.rectangle());
        EXPECT_TRUE(selection.large_enough());
    }
    selection = RectangleSelection({100, 80}, {-500, 40});
    selection.drag_to({900, 900});
    EXPECT_EQ(selection.rectangle(), (Rectangle{0, 40, 100, 40}));
}

}  // namespace
}  // namespace kambara::ui
