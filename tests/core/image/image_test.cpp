// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/image.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>
#include <stdexcept>
#include <string>

#include "core/image/opencv_view.h"
#include "core/image/rectangle.h"

namespace kambara {
namespace {

TEST(Rectangle, ReadsWhatItWrites) {
    const Rectangle rectangle{-3, 200, 31, 17};
    EXPECT_EQ(*parse_rectangle(to_string(rectangle)), rectangle);
    EXPECT_DOUBLE_EQ(rectangle.centre_x_px(), 12.0);
    EXPECT_DOUBLE_EQ(rectangle.centre_y_px(), 208.0);
}

TEST(Rectangle, RefusesWhatIsNotFourWholeNumbersWithAnArea) {
    for (const char* text : {"", "1,2,3", "1,2,3,4,5", "1,2,3,4 ", "1;2;3;4", "a,2,3,4",
                             "1,2,3.5,4", "1,2,0,4", "1,2,3,-4", "99999999999,2,3,4", ",1,2,3"}) {
        const auto read = parse_rectangle(text);
        ASSERT_FALSE(read) << text;
        EXPECT_NE(read.error().cause.find("\"" + std::string(text) + "\""), std::string::npos);
    }
}

TEST(Rectangle, InsideMeansEveryPixel) {
    EXPECT_TRUE((Rectangle{0, 0, 640, 480}.inside(640, 480)));
    EXPECT_TRUE((Rectangle{639, 479, 1, 1}.inside(640, 480)));
    EXPECT_FALSE((Rectangle{610, 0, 31, 31}.inside(640, 480)));
    EXPECT_FALSE((Rectangle{-1, 0, 31, 31}.inside(640, 480)));
    EXPECT_FALSE((Rectangle{2147483647, 0, 2147483647, 1}.inside(640, 480)));
}

TEST(Image, GreyIsTheWeightedSumRounded) {
    Image colour(2, 1, 3);
    colour.at(0, 0, 0) = 10;   // blue
    colour.at(0, 0, 1) = 200;  // green
    colour.at(0, 0, 2) = 100;  // red
    for (int c = 0; c < 3; ++c) {
        colour.at(1, 0, c) = 255;
    }
    const Image grey = grey_from(colour);
    EXPECT_EQ(grey.channels(), 1);
    EXPECT_EQ(grey.at(0, 0), 148);  // 1.14 + 117.4 + 29.9 = 148.44
    EXPECT_EQ(grey.at(1, 0), 255);
}

TEST(Image, AGreyPictureIsSharedNotCopied) {
    const ImagePtr grey = std::make_shared<const Image>(4, 3);
    EXPECT_EQ(grey_from(grey), grey);
    const ImagePtr colour = std::make_shared<const Image>(4, 3, 3, std::uint8_t{7});
    EXPECT_EQ(*grey_from(colour), Image(4, 3, 1, 7));
}

TEST(Image, GoesToOpenCvAndBackUnchanged) {
    Image picture(5, 3, 3);
    for (int y = 0; y < 3; ++y) {
        for (int i = 0; i < 15; ++i) {
            picture.row(y)[i] = static_cast<std::uint8_t>(50 * y + i);
        }
    }
    // A part of a larger matrix: its rows do not follow each other without gaps.
    const cv::Mat whole = opencv_view(picture);
    const Image part = image_from_opencv(whole(cv::Rect(1, 1, 3, 2)));
    EXPECT_EQ(image_from_opencv(whole), picture);
    EXPECT_EQ(part.width(), 3);
    EXPECT_EQ(part.at(2, 1, 2), picture.at(3, 2, 2));
    EXPECT_THROW(image_from_opencv(cv::Mat(2, 2, CV_16UC1)), std::invalid_argument);
    EXPECT_THROW(Image(2, 2, 2), std::invalid_argument);
}

}  // namespace
}  // namespace kambara
