// SPDX-License-Identifier: GPL-3.0-or-later
#include "hardware/media/picture_file.h"

#include <gtest/gtest.h>

#include "tests/hardware/media/media_folder.h"

namespace kambara {
namespace {

using PictureFileTest = MediaFolderTest;

TEST_F(PictureFileTest, GivesBackEveryPixelOfALosslessFormat) {
    for (const int channels : {1, 3}) {
        const Image picture = textured_picture(37, 21, channels, 5);
        for (const std::string ending : {"png", "tiff", "bmp"}) {
            const std::string file = path("picture." + ending);
            ASSERT_TRUE(write_picture(file, picture));
            const auto read = read_picture(file);
            ASSERT_TRUE(read) << file << ": " << read.error().cause;
            EXPECT_EQ(*read, picture) << file;
        }
    }
}

TEST_F(PictureFileTest, RefusesAPictureCutShortAnywhere) {
    const Image picture = textured_picture(64, 48, 3, 1);
    for (const std::string ending : {"png", "jpg", "ppm", "tiff", "bmp", "webp"}) {
        ASSERT_TRUE(write_picture(path("whole." + ending), picture));
        ASSERT_TRUE(read_picture(path("whole." + ending))) << ending;
        for (const double part : {0.0, 0.02, 0.5, 0.99}) {
            cut("whole." + ending, "cut." + ending, part);
            const auto read = read_picture(path("cut." + ending));
            ASSERT_FALSE(read) << ending << " cut at " << part;
            EXPECT_NE(read.error().cause.find("cut." + ending), std::string::npos);
        }
    }
}

// A preview inside a JPEG has an end marker of its own, and some cameras append data after the end.
TEST_F(PictureFileTest, FindsTheEndOfTheJpegItselfNotOfItsPreview) {
    ASSERT_TRUE(write_picture(path("plain.jpg"), textured_picture(64, 48, 3, 2)));
    const std::string plain = bytes_of("plain.jpg");
    const std::string preview("\xFF\xE1\x00\x06\xFF\xD9\xFF\xD9", 8);
    const std::string whole = plain.substr(0, 2) + preview + plain.substr(2);

    write_bytes("appended.jpg", whole + std::string(5000, 'x'));
    EXPECT_TRUE(read_picture(path("appended.jpg")));
    write_bytes("cut.jpg", whole.substr(0, whole.size() - 2));
    EXPECT_FALSE(read_picture(path("cut.jpg")));
}

TEST_F(PictureFileTest, RefusesWhatIsNoPictureOrHasNoFormat) {
    EXPECT_FALSE(read_picture(path("missing.png")));
    write_bytes("text.png", "This is no picture.");
    EXPECT_FALSE(read_picture(path("text.png")));
    const auto written = write_picture(path("picture.odd"), Image(8, 8));
    ASSERT_FALSE(written);
    EXPECT_NE(written.error().cause.find("picture.odd"), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(path("picture.odd")));
}

TEST_F(PictureFileTest, OrdersAPatternByNumberAndLeavesOthersOut) {
    for (const char* name : {"a10.png", "a9.png", "a2.png", "b1.png", ".a1.png", "a1.txt"}) {
        write_bytes(name, "x");
    }
    const auto files = files_of_pattern(path("a*.png"));
    ASSERT_TRUE(files);
    ASSERT_EQ(files->size(), 3U);
    EXPECT_EQ((*files)[0].filename(), "a2.png");
    EXPECT_EQ((*files)[1].filename(), "a9.png");
    EXPECT_EQ((*files)[2].filename(), "a10.png");
    const auto every_png = files_of_pattern(path("*.png"));
    ASSERT_TRUE(every_png);
    EXPECT_EQ(every_png->size(), 4U);
}

TEST_F(PictureFileTest, CountsAPrintfFormFromItsFirstFile) {
    for (const char* name : {"000003.png", "000004.png", "000005.png"}) {
        write_bytes(name, "x");
    }
    const auto files = files_of_pattern(path("%06d.png"));
    ASSERT_TRUE(files);
    ASSERT_EQ(files->size(), 3U);
    EXPECT_EQ(files->front().filename(), "000003.png");
    EXPECT_FALSE(files_of_pattern(path("%s.png")));
    EXPECT_FALSE(files_of_pattern(path("%06d.jpg")));
}

}  // namespace
}  // namespace kambara
