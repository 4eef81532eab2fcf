// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>

#include "hardware/media/open_media.h"
#include "tests/hardware/media/media_folder.h"

namespace kambara {
namespace {

constexpr int frames = 20;

class VideoGrabberTest : public MediaFolderTest {
  protected:
    // The grey level of a frame is its number times 10.
    void write_video(const std::string& name, const char* code) const {
        cv::VideoWriter writer(path(name), cv::CAP_FFMPEG,
                               cv::VideoWriter::fourcc(code[0], code[1], code[2], code[3]), 25.0,
                               cv::Size(160, 120));
        ASSERT_TRUE(writer.isOpened()) << "this OpenCV can't write " << name;
        cv::RNG random(1);
        for (int i = 0; i < frames; ++i) {
            cv::Mat pixels(120, 160, CV_8UC3, cv::Scalar::all(10 * i));
            random.fill(pixels(cv::Rect(0, 0, 60, 60)), cv::RNG::UNIFORM, 0, 255);
            writer.write(pixels);
        }
    }

    struct Reading {
        int frames = 0;
        std::string failure;  // empty where the video came to its end
    };

    Reading read_all(const std::string& name) const {
        const auto grabber = open_media(path(name));
        if (!grabber) {
            return {0, grabber.error().cause};
        }
        for (int count = 0;; ++count) {
            const auto frame = (*grabber)->grab({});
            if (!frame || !*frame) {
                return {count, frame ? "" : frame.error().cause};
            }
        }
    }
};

TEST_F(VideoGrabberTest, DeliversEveryFrameOfTheUsualContainers) {
    const std::pair<const char*, const char*> kinds[] = {
        {"a.avi", "MJPG"}, {"a.mkv", "FFV1"}, {"a.mp4", "mp4v"}};
    for (const auto& [name, code] : kinds) {
        write_video(name, code);
        const auto reading = read_all(name);
        EXPECT_EQ(reading.frames, frames) << name;
        EXPECT_EQ(reading.failure, "") << name;
    }
}

TEST_F(VideoGrabberTest, BeginsAtExactlyTheFrameAskedFor) {
    write_video("a.mp4", "mp4v");
    const auto grabber = open_media(path("a.mp4"), {.start = 13});
    ASSERT_TRUE(grabber) << grabber.error().cause;
    EXPECT_NEAR((*grabber)->info().rate_hz, 25.0, 1e-9);
    const auto frame = (*grabber)->grab({});
    ASSERT_TRUE(frame && *frame);
    EXPECT_EQ((**frame).index, 13);
    EXPECT_EQ((**frame).time_ns, 13 * std::int64_t{40'000'000});
    EXPECT_NEAR((**frame).picture->at(140, 100), 130, 4);

    const auto past = open_media(path("a.mp4"), {.start = frames + 1});
    ASSERT_FALSE(past);
    EXPECT_NE(past.error().cause.find("20 frames"), std::string::npos);
}

TEST_F(VideoGrabberTest, SaysThatAVideoIsCutShort) {
    const std::pair<const char*, const char*> kinds[] = {{"a.avi", "MJPG"}, {"a.mkv", "FFV1"}};
    for (const auto& [name, code] : kinds) {
        write_video(name, code);
        cut(name, std::string("cut_") + name, 0.6);
        const auto reading = read_all(std::string("cut_") + name);
        EXPECT_GT(reading.frames, frames / 2 - 2) << name;
        EXPECT_LT(reading.frames, frames) << name;
        const std::string expected =
            "announces 20 frames, but only " + std::to_string(reading.frames);
        EXPECT_NE(reading.failure.find(expected), std::string::npos) << reading.failure;
    }
    // The index of an MP4 stands at its end: without it nothing can be read.
    write_video("a.mp4", "mp4v");
    cut("a.mp4", "cut_a.mp4", 0.9);
    EXPECT_NE(read_all("cut_a.mp4").failure.find("cut_a.mp4"), std::string::npos);
}

// Matroska stores a duration, from which the decoder derives the number of frames; sound may last
// longer than the pictures, and that is no fault.
TEST_F(VideoGrabberTest, TakesAWholeMatroskaFileThatLastsLongerThanItsPictures) {
    write_video("a.mkv", "FFV1");
    std::string bytes = bytes_of("a.mkv");
    const auto duration = bytes.find("\x44\x89\x88");
    ASSERT_NE(duration, std::string::npos);
    const std::string two_seconds_as_double("\x40\x9F\x40\x00\x00\x00\x00\x00", 8);  // 2000 ms
    bytes.replace(duration + 3, 8, two_seconds_as_double);
    write_bytes("sound.mkv", bytes);
    const auto reading = read_all("sound.mkv");
    EXPECT_EQ(reading.frames, frames);
    EXPECT_EQ(reading.failure, "");
    cut("sound.mkv", "cut.mkv", 0.6);
    EXPECT_NE(read_all("cut.mkv").failure.find("announces 50 frames"), std::string::npos);
}

TEST_F(VideoGrabberTest, RefusesWhatIsNoVideo) {
    EXPECT_NE(read_all("missing.avi").failure.find("There is no file"), std::string::npos);
    write_bytes("text.avi", "This is no video.");
    EXPECT_NE(read_all("text.avi").failure.find("can't be read as a video"), std::string::npos);
    write_bytes("empty.mp4", "");
    EXPECT_NE(read_all("empty.mp4").failure.find("can't be read as a video"), std::string::npos);
    std::filesystem::create_directory(path("session"));
    EXPECT_NE(read_all("session").failure.find("is a folder"), std::string::npos);
}

TEST_F(VideoGrabberTest, KeepsTheTerminalQuietAboutDamage) {
    write_video("a.mkv", "FFV1");
    cut("a.mkv", "cut.mkv", 0.6);
    testing::internal::CaptureStderr();
    testing::internal::CaptureStdout();
    const auto reading = read_all("cut.mkv");
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_NE(reading.failure, "");
}

TEST(VideoGrabberRealDataTest, ReadsARealVideoToItsEnd) {
    const std::string file = std::string(KAMBARA_DATA) + "/hand_stereo_video/cam0_test.mp4";
    if (!std::filesystem::exists(file)) {
        GTEST_SKIP() << "skipped: there is no " << file;
    }
    const auto grabber = open_media(file, {.start = 370});
    ASSERT_TRUE(grabber) << grabber.error().cause;
    EXPECT_EQ((*grabber)->info().width_px, 720);
    int count = 0;
    for (auto frame = (*grabber)->grab({}); frame && *frame; frame = (*grabber)->grab({})) {
        ++count;
    }
    EXPECT_EQ(count, 8);
    EXPECT_TRUE((*grabber)->grab({}));
}

}  // namespace
}  // namespace kambara
