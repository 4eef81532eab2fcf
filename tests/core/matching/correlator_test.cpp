// SPDX-License-Identifier: GPL-3.0-or-later
// Every implementation of the inner loops against the definitions.
#include "core/matching/correlator.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <random>
#include <string>

namespace kambara {
namespace {

enum class Content { random, flat, saturated, almost_flat, dither };

Image picture_of(Content content, std::mt19937& random, int width, int height, int channels) {
    Image image(width, height, channels);
    const auto flat = static_cast<std::uint8_t>(random() % 256);
    for (int y = 0; y < height; ++y) {
        for (std::size_t i = 0; i < image.row_bytes(); ++i) {
            int value = flat;
            switch (content) {
                case Content::random:
                    value = static_cast<int>(random() % 256);
                    break;
                case Content::flat:
                    break;
                case Content::saturated:
                    value = random() % 4 == 0 ? 0 : 255;
                    break;
                case Content::almost_flat:
                    value = random() % 97 == 0 ? (flat ^ 1) : flat;
                    break;
                case Content::dither:
                    value = 200 + static_cast<int>(random() % 2);
                    break;
            }
            image.row(y)[i] = static_cast<std::uint8_t>(value);
        }
    }
    return image;
}

struct Case {
    Image picture;
    Image templ;
    Image mask;
    int step = 1;
    bool masked = false;
};

// A picture and a template of sizes that don't fit the vectors.
Case random_case(std::mt19937& random, Content content, int channels, bool small = true) {
    const auto up_to = [&](unsigned most) { return static_cast<int>(1 + random() % most); };
    Case c;
    const int width = small ? 2 + up_to(21) : 60 + up_to(195);
    const int height = small ? 2 + up_to(21) : 60 + up_to(195);
    c.picture = picture_of(content, random, width + up_to(150), height + up_to(40), channels);
    c.templ = picture_of(content, random, width, height, channels);
    c.mask = picture_of(Content::dither, random, width, height, 1);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            c.mask.at(x, y) = static_cast<std::uint8_t>(c.mask.at(x, y) - 200);
        }
    }
    c.mask.at(0, 0) = 1;
    c.masked = random() % 2 == 0;
    c.step = random() % 3 == 0 ? up_to(4) : 1;
    return c;
}

// The definition at one position, in 64-bit arithmetic on exact sums.
double by_definition(const Case& c, Measure measure, int x, int y) {
    std::int64_t n = 0, I = 0, T = 0, II = 0, TT = 0, IT = 0, sad = 0, bits = 0;
    for (int v = 0; v < c.templ.height(); v += c.step) {
        for (int u = 0; u < c.templ.width(); u += c.step) {
            if (c.masked && c.mask.at(u, v) == 0) {
                continue;
            }
            for (int channel = 0; channel < c.templ.channels(); ++channel) {
                const int i = c.picture.at(x + u, y + v, channel);
                const int t = c.templ.at(u, v, channel);
                ++n;
                I += i;
                T += t;
                II += i * i;
                TT += t * t;
                IT += i * t;
                sad += std::abs(i - t);
                bits += std::popcount(static_cast<unsigned>(i ^ t));
            }
        }
    }
    if (measure == Measure::sad || measure == Measure::hamming) {
        return static_cast<double>(measure == Measure::sad ? sad : bits);
    }
    const bool zero_mean = measure == Measure::zncc;
    const auto a = static_cast<double>(zero_mean ? n * II - I * I : II);
    const auto b = static_cast<double>(zero_mean ? n * TT - T * T : TT);
    const auto p = static_cast<double>(zero_mean ? n * IT - I * T : IT);
    return a == 0.0 || b == 0.0 ? 0.0 : p / std::sqrt(a) / std::sqrt(b);
}

std::string label(const Kernels& kernels, const Case& c, Measure measure) {
    return kernels.name + " " + to_string(measure) + " " + std::to_string(c.templ.width()) + "x" +
           std::to_string(c.templ.height()) + "x" + std::to_string(c.templ.channels()) + " in " +
           std::to_string(c.picture.width()) + "x" + std::to_string(c.picture.height()) +
           (c.masked ? " masked" : "") + " step " + std::to_string(c.step);
}

void expect_definition(const Kernels& kernels, const Case& c, Measure measure, std::mt19937& random,
                       int checks) {
    SCOPED_TRACE(label(kernels, c, measure));
    Correlator correlator(kernels);
    correlator.set_template(measure, c.templ, c.masked ? &c.mask : nullptr, c.step);
    ScoreMap map;
    correlator.scores(c.picture, {-5, -5, 5000, 5000}, map);
    const int reach_x = (c.templ.width() - 1) / c.step * c.step;
    const int reach_y = (c.templ.height() - 1) / c.step * c.step;
    ASSERT_EQ(map.positions,
              (Rectangle{0, 0, c.picture.width() - reach_x, c.picture.height() - reach_y}));
    for (int k = 0; k < checks; ++k) {
        const int x = static_cast<int>(random() % static_cast<unsigned>(map.positions.width));
        const int y = static_cast<int>(random() % static_cast<unsigned>(map.positions.height));
        const double expected = by_definition(c, measure, x, y);
        if (is_cost(measure)) {
            ASSERT_EQ(map.at(x, y), expected) << x << ", " << y;
        } else {
            ASSERT_NEAR(map.at(x, y), expected, 1e-6) << x << ", " << y;
        }
    }
}

class CorrelatorTest : public testing::TestWithParam<std::size_t> {
  protected:
    const Kernels& kernels() const { return runnable_kernels()[GetParam()]; }
    std::mt19937 random_{static_cast<unsigned>(GetParam()) + 1};
};

INSTANTIATE_TEST_SUITE_P(Kernels, CorrelatorTest,
                         testing::Range<std::size_t>(0, runnable_kernels().size()),
                         [](const auto& each) { return runnable_kernels()[each.param].name; });

TEST_P(CorrelatorTest, IsTheDefinitionForEveryMeasureContentMaskAndStep) {
    for (const Content content : {Content::random, Content::flat, Content::saturated,
                                  Content::almost_flat, Content::dither}) {
        for (const Measure measure :
             {Measure::sad, Measure::ncc, Measure::zncc, Measure::hamming}) {
            for (int round = 0; round < 12; ++round) {
                Case c = random_case(random_, content, round % 2 == 0 ? 1 : 3);
                if (measure == Measure::hamming && c.templ.channels() == 1) {
                    for (Image* image : {&c.picture, &c.templ}) {
                        for (int y = 0; y < image->height(); ++y) {
                            for (int x = 0; x < image->width(); ++x) {
                                image->at(x, y) &= 1;
                            }
                        }
                    }
                }
                expect_definition(kernels(), c, measure, random_, 60);
                if (HasFatalFailure()) {
                    return;
                }
            }
        }
    }
}

TEST_P(CorrelatorTest, NothingOverflowsInTheLargestTemplates) {
    for (const int channels : {1, 3}) {
        for (const Measure measure : {Measure::sad, Measure::ncc, Measure::zncc}) {
            Case c;
            c.picture = picture_of(Content::saturated, random_, 260, 258, channels);
            c.templ = picture_of(Content::saturated, random_, 255, 255, channels);
            expect_definition(kernels(), c, measure, random_, 8);
            c.templ = Image(255, 255, channels, 0);
            c.picture = Image(260, 258, channels, 255);
            expect_definition(kernels(), c, measure, random_, 2);
            c.templ = Image(255, 255, channels, 255);
            expect_definition(kernels(), c, measure, random_, 2);
        }
    }
}

// Of templates with few bits one narrow sum holds all; of others it is emptied on the way.
TEST_P(CorrelatorTest, CountsAllBitsOfSmallAndLargeTemplates) {
    for (const auto& [width, height] : {std::pair(15, 17), std::pair(16, 16), std::pair(3, 85),
                                        std::pair(60, 61), std::pair(255, 255)}) {
        for (const int channels : {1, 3}) {
            const auto all = static_cast<std::uint8_t>(channels == 1 ? 1 : 255);
            Case c;
            c.picture = Image(width + 70, height + 6, channels, all);
            c.templ = Image(width, height, channels, 0);
            expect_definition(kernels(), c, Measure::hamming, random_, 8);
            c.picture = picture_of(Content::random, random_, width + 70, height + 6, channels);
            c.templ = picture_of(Content::random, random_, width, height, channels);
            for (Image* image : {&c.picture, &c.templ}) {
                for (int y = 0; y < image->height(); ++y) {
                    for (std::size_t i = 0; i < image->row_bytes(); ++i) {
                        image->row(y)[i] &= all;
                    }
                }
            }
            expect_definition(kernels(), c, Measure::hamming, random_, 20);
        }
    }
}

TEST_P(CorrelatorTest, GivesTheSameBitsAsThePlainLoops) {
    for (int round = 0; round < 40; ++round) {
        const Case c = random_case(random_, round % 2 == 0 ? Content::random : Content::almost_flat,
                                   round % 3 == 0 ? 3 : 1);
        for (const Measure measure : {Measure::sad, Measure::ncc, Measure::zncc}) {
            SCOPED_TRACE(label(kernels(), c, measure));
            ScoreMap maps[2];
            for (int i = 0; i < 2; ++i) {
                Correlator correlator(i == 0 ? kernels() : plain_kernels());
                correlator.set_template(measure, c.templ, c.masked ? &c.mask : nullptr, c.step);
                correlator.scores(c.picture, {3, 2, 70, 30}, maps[i]);
            }
            ASSERT_EQ(maps[0].scores, maps[1].scores);
            ASSERT_EQ(maps[0].costs, maps[1].costs);
        }
    }
}

TEST_P(CorrelatorTest, TheStepsAboutTheTransformAreThePlainOnes) {
    std::mt19937 random(11);
    constexpr int count = 45;
    constexpr SpectrumPart part{3, 8, 13};
    std::vector<std::uint8_t> pixels(count);
    std::vector<double> left(2 * 3 * 13);
    std::vector<double> right(left.size());
    for (std::uint8_t& pixel : pixels) {
        pixel = static_cast<std::uint8_t>(random());
    }
    for (std::size_t i = 0; i < left.size(); ++i) {
        left[i] = static_cast<double>(random() % 2001) - 1000.0;
        right[i] = static_cast<double>(random() % 2001) - 1000.0;
    }
    const auto results = [&](const Kernels& by) {
        std::vector<double> values(count);
        by.centred_values(pixels.data(), count, values.data());
        std::vector<double> products(left.size(), 5.0);
        by.multiply_spectra(left.data(), right.data(), part, false, products.data());
        by.multiply_spectra(left.data(), left.data(), part, true, products.data());
        std::vector<std::int32_t> whole(count);
        by.whole_numbers(left.data(), count, 1.0 / 3.0, 0.1, whole.data());
        values.insert(values.end(), products.begin(), products.end());
        values.insert(values.end(), whole.begin(), whole.end());
        return values;
    };
    EXPECT_EQ(results(kernels()), results(plain_kernels()));
}

TEST(Correlator, ThroughTheSpectrumTheSameBitsComeOut) {
    std::mt19937 random(9);
    for (int round = 0; round < 24; ++round) {
        const auto content = static_cast<Content>(round % 5);
        Case c = random_case(random, content, round % 4 == 0 ? 3 : 1, round % 2 == 0);
        if (c.templ.channels() == 3 && c.templ.width() * c.templ.height() > 20000) {
            continue;
        }
        for (const Measure measure : {Measure::ncc, Measure::zncc}) {
            ScoreMap maps[2];
            for (int i = 0; i < 2; ++i) {
                Correlator correlator;
                correlator.set_way(i == 0 ? Correlator::Way::spectrum : Correlator::Way::kernels);
                correlator.set_template(measure, c.templ, nullptr, c.step);
                correlator.scores(c.picture, {0, 0, 5000, 5000}, maps[i]);
            }
            ASSERT_EQ(maps[0].scores, maps[1].scores) << c.templ.width() << "x" << c.templ.height();
        }
    }
}

// A picture wide enough for several tiles.
TEST(Correlator, TheSpectrumsTilesFitTogether) {
    std::mt19937 random(10);
    const Image picture = picture_of(Content::saturated, random, 1500, 900, 1);
    const Image templ = picture_of(Content::saturated, random, 127, 90, 1);
    ScoreMap maps[2];
    for (int i = 0; i < 2; ++i) {
        Correlator correlator;
        correlator.set_way(i == 0 ? Correlator::Way::spectrum : Correlator::Way::kernels);
        correlator.set_template(Measure::zncc, templ);
        correlator.scores(picture, {0, 0, 5000, 5000}, maps[i]);
    }
    EXPECT_EQ(maps[0].scores, maps[1].scores);
}

// Widths about whole multiples of the vectors' and the cache's sizes, rows of any stride.
TEST_P(CorrelatorTest, IsTheDefinitionInVeryLargePicturesAndWithEvenTemplates) {
    for (const auto& [width, height] : {std::pair(4096, 60), std::pair(70, 4096)}) {
        for (const int channels : {1, 3}) {
            for (const Measure measure : {Measure::sad, Measure::ncc, Measure::zncc}) {
                Case c;
                c.picture = picture_of(Content::random, random_, width, height, channels);
                c.templ = picture_of(Content::random, random_, 6 + 2 * channels, 8, channels);
                expect_definition(kernels(), c, measure, random_, 40);
            }
        }
    }
}

TEST(Correlator, SearchesAPictureOf4096By4096) {
    std::mt19937 random(12);
    const Image picture = picture_of(Content::dither, random, 4096, 4096, 1);
    Image templ(255, 255);
    for (int y = 0; y < 255; ++y) {
        std::copy_n(picture.row(3830 + y) + 3800, 255, templ.row(y));
    }
    for (const Measure measure : {Measure::sad, Measure::zncc}) {
        Correlator correlator;
        correlator.set_template(measure, templ);
        ScoreMap map;
        correlator.scores(picture, {3780, 3800, 5000, 5000}, map);
        ASSERT_EQ(map.positions, (Rectangle{3780, 3800, 62, 42}));
        EXPECT_NEAR(map.at(3800, 3830), measure == Measure::sad ? 0.0 : 1.0, 1e-6);
    }
    Correlator correlator;
    correlator.set_template(Measure::sad, Image(9, 9, 1, 200));
    ScoreMap map;
    correlator.scores(picture, {0, 0, 5000, 5000}, map);
    EXPECT_EQ(map.positions, (Rectangle{0, 0, 4088, 4088}));
    EXPECT_LE(map.at(4087, 4087), 81.0);
}

TEST(Correlator, AFlatPatchScoresNothing) {
    const Image picture(40, 30, 1, 77);
    std::mt19937 random(3);
    const Image templ = picture_of(Content::random, random, 9, 9, 1);
    Correlator correlator;
    correlator.set_template(Measure::zncc, templ);
    ScoreMap map;
    correlator.scores(picture, {0, 0, 100, 100}, map);
    for (const float score : map.scores) {
        ASSERT_EQ(score, 0.0F);
    }
}

TEST(Correlator, GivesNoMapWhereTheTemplateFitsNowhere) {
    Correlator correlator;
    correlator.set_template(Measure::sad, Image(30, 30, 1, 5));
    ScoreMap map;
    correlator.scores(Image(29, 40, 1, 5), {0, 0, 100, 100}, map);
    EXPECT_TRUE(map.empty());
    correlator.scores(Image(60, 60, 1, 5), {40, 0, 10, 10}, map);
    EXPECT_TRUE(map.empty());
    EXPECT_THROW(correlator.set_template(Measure::sad, Image(256, 9)), std::invalid_argument);
}

}  // namespace
}  // namespace kambara
