// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/matching/temporal_filter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <random>

namespace kambara {
namespace {

using Kind = TemporalOptions::Kind;

Image random_picture(std::mt19937& random, int width, int height, int channels) {
    Image image(width, height, channels);
    for (int y = 0; y < height; ++y) {
        for (std::size_t i = 0; i < image.row_bytes(); ++i) {
            image.row(y)[i] = static_cast<std::uint8_t>(random() % 256);
        }
    }
    return image;
}

// The definition, pixel by pixel.
Image by_definition(Kind kind, const std::deque<Image>& pictures) {
    Image out = pictures.front();
    for (int y = 0; y < out.height(); ++y) {
        for (std::size_t i = 0; i < out.row_bytes(); ++i) {
            std::vector<int> values;
            for (const Image& picture : pictures) {
                values.push_back(picture.row(y)[i]);
            }
            std::sort(values.begin(), values.end());
            const int n = static_cast<int>(values.size());
            int sum = 0;
            for (const int value : values) {
                sum += value;
            }
            const auto half = values.size() / 2;
            const int median =
                n % 2 == 1 ? values[half] : (values[half - 1] + values[half] + 1) / 2;
            out.row(y)[i] =
                static_cast<std::uint8_t>(kind == Kind::mean ? (2 * sum + n) / (2 * n) : median);
        }
    }
    return out;
}

TEST(TemporalFilter, IsTheDefinitionFromTheFirstPictureOn) {
    std::mt19937 random(1);
    for (const Kind kind : {Kind::median, Kind::mean}) {
        for (int frames = 1; frames <= most_temporal_frames; ++frames) {
            const int channels = frames % 2 == 0 ? 3 : 1;
            TemporalFilter filter({kind, frames});
            std::deque<Image> last;
            for (int i = 0; i < 2 * frames + 1; ++i) {
                last.push_back(random_picture(random, 37, 9, channels));
                if (last.size() > static_cast<std::size_t>(frames)) {
                    last.pop_front();
                }
                ASSERT_EQ(filter.filter(last.back()), by_definition(kind, last))
                    << to_string(TemporalOptions{kind, frames}) << " at " << i;
            }
        }
    }
}

// Every sum that bytes can make, divided as the definition says.
TEST(TemporalFilter, MeansAreRoundedRightForEverySum) {
    for (int frames = 1; frames <= most_temporal_frames; ++frames) {
        for (int sum = 0; sum <= 255 * frames; ++sum) {
            TemporalFilter filter({Kind::mean, frames});
            int rest = sum;
            int mean = 0;
            for (int i = 0; i < frames; ++i) {
                const int value = std::min(rest, 255);
                rest -= value;
                mean = filter.filter(Image(1, 1, 1, static_cast<std::uint8_t>(value))).at(0, 0);
            }
            ASSERT_EQ(mean, (2 * sum + frames) / (2 * frames)) << sum << " / " << frames;
        }
    }
}

TEST(TemporalFilter, BeginsAnewWithAnotherSizeAndWhenTold) {
    for (const Kind kind : {Kind::median, Kind::mean}) {
        TemporalFilter filter({kind, 3});
        filter.filter(Image(8, 8, 1, 10));
        filter.filter(Image(8, 8, 1, 10));
        EXPECT_EQ(filter.filter(Image(4, 8, 1, 90)), Image(4, 8, 1, 90));
        EXPECT_EQ(filter.filter(Image(4, 8, 3, 70)), Image(4, 8, 3, 70));
        filter.reset();
        EXPECT_EQ(filter.filter(Image(4, 8, 3, 20)), Image(4, 8, 3, 20));
        EXPECT_TRUE(filter.filter(Image()).empty());
    }
}

TEST(TemporalFilter, NothingIsAllocatedOnceThePicturesAreThere) {
    TemporalFilter filter({Kind::median, 5});
    const std::uint8_t* place = nullptr;
    for (int i = 0; i < 12; ++i) {
        const Image& out = filter.filter(Image(40, 30, 1, static_cast<std::uint8_t>(i)));
        place = place == nullptr ? out.row(0) : place;
        EXPECT_EQ(out.row(0), place);
    }
}

TEST(TemporalFilter, NamesAreReadAndOthersRefused) {
    for (const char* name : {"median:5", "mean:1", "median:15"}) {
        EXPECT_EQ(to_string(*parse_temporal(name)), name);
    }
    for (const char* name : {"", "median", "median:", "median:0", "mean:16", "mode:3", "mean:3x"}) {
        const auto parsed = parse_temporal(name);
        ASSERT_FALSE(parsed) << name;
        EXPECT_NE(parsed.error().text().find("1 to 15"), std::string::npos);
    }
    EXPECT_THROW(TemporalFilter({Kind::mean, 16}), std::invalid_argument);
}

}  // namespace
}  // namespace kambara
