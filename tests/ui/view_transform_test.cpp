// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/video/view_transform.h"

#include <gtest/gtest.h>

#include <random>

namespace kambara::ui {
namespace {

TEST(ViewTransform, FitsWithTheAspectKept) {
    const QSize picture(640, 480);
    const auto wide = ViewTransform::fitted(picture, {2000, 240});
    EXPECT_DOUBLE_EQ(wide.zoom(), 0.5);
    EXPECT_EQ(wide.picture_area(picture), QRectF(840, 0, 320, 240));
    const auto high = ViewTransform::fitted(picture, {320, 1000});
    EXPECT_EQ(high.picture_area(picture), QRectF(0, 380, 320, 240));
    EXPECT_DOUBLE_EQ(ViewTransform::fitted({}, {320, 1000}).zoom(), 1.0);
}

TEST(ViewTransform, PixelCoordinatesNamePixelCentres) {
    const auto view = ViewTransform::fitted({10, 10}, {100, 100});
    EXPECT_EQ(view.widget_from_pixel({0, 0}), QPointF(5, 5));
    EXPECT_EQ(view.widget_from_pixel({-0.5, 9.5}), QPointF(0, 100));
}

TEST(ViewTransform, GoesThereAndBackAndKeepsTheAnchor) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(-500.0, 1500.0);
    std::uniform_real_distribution<double> factor(0.3, 3.0);
    auto view = ViewTransform::fitted({640, 480}, {800, 700});
    for (int i = 0; i < 200; ++i) {
        const QPointF anchor(place(random), place(random));
        const QPointF pixel = view.pixel_from_widget(anchor);
        view = view.zoomed(factor(random), anchor);
        EXPECT_GE(view.zoom(), ViewTransform::least_zoom);
        EXPECT_LE(view.zoom(), ViewTransform::most_zoom);
        const QPointF kept = view.pixel_from_widget(anchor);
        EXPECT_NEAR(kept.x(), pixel.x(), 1e-6);
        EXPECT_NEAR(kept.y(), pixel.y(), 1e-6);
        const QPointF back = view.widget_from_pixel(kept);
        EXPECT_NEAR(back.x(), anchor.x(), 1e-6);
        view = ViewTransform::fitted({640, 480}, {800, 700}).zoomed(view.zoom(), {3, 4});
    }
}

}  // namespace
}  // namespace kambara::ui
