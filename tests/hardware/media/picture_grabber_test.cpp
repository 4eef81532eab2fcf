// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "hardware/media/open_media.h"
#include "hardware/media/picture_file.h"
#include "tests/hardware/media/media_folder.h"

namespace kambara {
namespace {

class PictureGrabberTest : public MediaFolderTest {
  protected:
    void write_numbered(int count, int width = 32, int height = 24) const {
        for (int i = 0; i < count; ++i) {
            ASSERT_TRUE(write_picture(path(std::to_string(i) + ".png"),
                                      textured_picture(width, height, 1, seed(i))));
        }
    }
    static std::uint32_t seed(int i) { return static_cast<std::uint32_t>(i + 1); }
};

TEST_F(PictureGrabberTest, DeliversEveryPictureWithItsNumberAndTime) {
    write_numbered(12);
    const auto grabber = open_media(path("*.png"), {.start = 0, .pictures_rate_hz = 4.0});
    ASSERT_TRUE(grabber) << grabber.error().cause;
    EXPECT_EQ((*grabber)->info().width_px, 32);
    EXPECT_FALSE((*grabber)->info().live);
    for (int i = 0; i < 12; ++i) {
        const auto frame = (*grabber)->grab({});
        ASSERT_TRUE(frame && *frame) << i;
        EXPECT_EQ((**frame).index, i);
        EXPECT_EQ((**frame).time_ns, i * std::int64_t{250'000'000});
        EXPECT_EQ(*(**frame).picture, textured_picture(32, 24, 1, seed(i))) << i;
    }
    const auto end = (*grabber)->grab({});
    ASSERT_TRUE(end);
    EXPECT_FALSE(end->has_value());
}

TEST_F(PictureGrabberTest, BeginsAtAFrameAndKeepsTheNumbering) {
    write_numbered(5);
    const auto grabber = open_media(path("%d.png"), {.start = 3});
    ASSERT_TRUE(grabber);
    const auto frame = (*grabber)->grab({});
    ASSERT_TRUE(frame && *frame);
    EXPECT_EQ((**frame).index, 3);
    EXPECT_EQ(*(**frame).picture, textured_picture(32, 24, 1, seed(3)));

    const auto past = open_media(path("%d.png"), {.start = 5});
    ASSERT_FALSE(past);
    EXPECT_NE(past.error().cause.find("5 pictures"), std::string::npos);
    EXPECT_FALSE(open_media(path("%d.png"), {.start = -1}));
}

TEST_F(PictureGrabberTest, AGapInTheNumbersIsNoEnd) {
    write_numbered(5);
    ASSERT_TRUE(std::filesystem::remove(path("2.png")));
    const auto numbered = open_media(path("%d.png"));
    ASSERT_FALSE(numbered);
    EXPECT_NE(numbered.error().cause.find("2.png is missing"), std::string::npos);
    EXPECT_NE(numbered.error().cause.find("3.png"), std::string::npos);
    EXPECT_TRUE(open_media(path("*.png")));
}

TEST_F(PictureGrabberTest, NamesThePictureOfAnotherSizeAndStaysFailed) {
    write_numbered(2);
    ASSERT_TRUE(write_picture(path("2.png"), Image(40, 24)));
    const auto grabber = open_media(path("*.png"));
    ASSERT_TRUE(grabber);
    ASSERT_TRUE((*grabber)->grab({}));
    ASSERT_TRUE((*grabber)->grab({}));
    for (int i = 0; i < 2; ++i) {
        const auto odd = (*grabber)->grab({});
        ASSERT_FALSE(odd);
        for (const char* part : {"2.png", "40 x 24", "32 x 24"}) {
            EXPECT_NE(odd.error().cause.find(part), std::string::npos) << odd.error().cause;
        }
    }
}

TEST_F(PictureGrabberTest, StopsWhenAsked) {
    write_numbered(1);
    const auto grabber = open_media(path("0.png"));
    ASSERT_TRUE(grabber);
    std::stop_source stop;
    stop.request_stop();
    const auto frame = (*grabber)->grab(stop.get_token());
    ASSERT_TRUE(frame);
    EXPECT_FALSE(frame->has_value());
}

TEST_F(PictureGrabberTest, TakesAnExistingFileByItsNameWhateverItsCharacters) {
    ASSERT_TRUE(write_picture(path("dive 50% done?.png"), Image(32, 24)));
    EXPECT_TRUE(open_media(path("dive 50% done?.png")));
}

TEST_F(PictureGrabberTest, RefusesFoldersAndPatternsThatNameNothing) {
    const auto folder = open_media(folder_.string());
    ASSERT_FALSE(folder);
    EXPECT_NE(folder.error().remedy.find("*.png"), std::string::npos);
    const auto nothing = open_media(path("*.png"));
    ASSERT_FALSE(nothing);
    EXPECT_NE(nothing.error().cause.find("*.png"), std::string::npos);
    EXPECT_FALSE(open_media(path("missing.png")));
}

}  // namespace
}  // namespace kambara
