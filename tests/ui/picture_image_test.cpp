// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/video/picture_image.h"

#include <gtest/gtest.h>

namespace kambara::ui {
namespace {

TEST(PictureImage, SharesThePixelsAndKeepsThemAlive) {
    auto picture = std::make_shared<Image>(7, 5, 1);
    for (int y = 0; y < 5; ++y) {
        for (int x = 0; x < 7; ++x) {
            picture->at(x, y) = static_cast<std::uint8_t>(10 * y + x);
        }
    }
    const std::weak_ptr<const Image> alive = picture;
    QImage copy;
    {
        const QImage image = image_sharing(picture);
        EXPECT_EQ(image.constBits(), picture->row(0));
        copy = image;
    }
    picture.reset();
    ASSERT_FALSE(alive.expired());
    EXPECT_EQ(qGray(copy.pixel(6, 4)), 46);
    copy = {};
    EXPECT_TRUE(alive.expired());
}

TEST(PictureImage, KnowsTheOrderOfColours) {
    auto picture = std::make_shared<Image>(2, 1, 3);
    picture->at(1, 0, 0) = 10;  // blue
    picture->at(1, 0, 1) = 20;
    picture->at(1, 0, 2) = 30;  // red
    EXPECT_EQ(image_sharing(picture).pixel(1, 0), qRgb(30, 20, 10));
    EXPECT_TRUE(image_sharing(nullptr).isNull());
}

}  // namespace
}  // namespace kambara::ui
