// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/matching/score_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/matching/peak.h"

namespace kambara {
namespace {

Image random_image(std::mt19937& random, int width, int height, int channels) {
    std::uniform_int_distribution<int> grey(0, 255);
    Image image(width, height, channels);
    for (int y = 0; y < height; ++y) {
        for (std::size_t i = 0; i < image.row_bytes(); ++i) {
            image.row(y)[i] = static_cast<std::uint8_t>(grey(random));
        }
    }
    return image;
}

Image cut(const Image& image, const Rectangle& r) {
    Image piece(r.width, r.height, image.channels());
    for (int y = 0; y < r.height; ++y) {
        for (int x = 0; x < r.width; ++x) {
            for (int c = 0; c < image.channels(); ++c) {
                piece.at(x, y, c) = image.at(r.x + x, r.y + y, c);
            }
        }
    }
    return piece;
}

// The definitions, word by word, in long double.
double by_definition(Measure measure, const Image& image, const Image& templ, int x, int y) {
    long double n = 0, sum_i = 0, sum_t = 0;
    const auto each = [&](auto&& visit) {
        for (int v = 0; v < templ.height(); ++v) {
            for (int u = 0; u < templ.width(); ++u) {
                for (int c = 0; c < templ.channels(); ++c) {
                    visit(static_cast<long double>(image.at(x + u, y + v, c)),
                          static_cast<long double>(templ.at(u, v, c)));
                }
            }
        }
    };
    each([&](long double i, long double t) {
        n += 1;
        sum_i += i;
        sum_t += t;
    });
    const long double mean_i = measure == Measure::zncc ? sum_i / n : 0;
    const long double mean_t = measure == Measure::zncc ? sum_t / n : 0;
    long double sad = 0, ii = 0, tt = 0, it = 0;
    each([&](long double i, long double t) {
        sad += std::abs(i - t);
        ii += (i - mean_i) * (i - mean_i);
        tt += (t - mean_t) * (t - mean_t);
        it += (i - mean_i) * (t - mean_t);
    });
    if (measure == Measure::sad) {
        return static_cast<double>(sad);
    }
    return ii <= 0 || tt <= 0 ? 0.0 : static_cast<double>(it / std::sqrt(ii * tt));
}

TEST(ScoreMap, AgreesWithTheDefinitionsOnRandomPictures) {
    std::mt19937 random(1);
    for (int round = 0; round < 12; ++round) {
        const int channels = round % 3 == 0 ? 3 : 1;
        const int w = 1 + static_cast<int>(random() % 12);
        const int h = 1 + static_cast<int>(random() % 12);
        const Image image = random_image(random, 20 + w, 17 + h, channels);
        const Image templ = random_image(random, w, h, channels);
        for (const Measure measure : {Measure::sad, Measure::ncc, Measure::zncc}) {
            const ScoreMap map = score_map(measure, image, templ, all_positions(image, templ));
            ASSERT_EQ(map.positions, (Rectangle{0, 0, 21, 18}));
            for (int y = 0; y < 18; ++y) {
                for (int x = 0; x < 21; ++x) {
                    const double exact = by_definition(measure, image, templ, x, y);
                    EXPECT_NEAR(map.at(x, y), exact, measure == Measure::sad ? 0.0 : 1e-6);
                    EXPECT_NEAR(score_at(measure, image, templ, x, y), exact,
                                measure == Measure::sad ? 0.0 : 1e-12);
                }
            }
        }
    }
}

TEST(ScoreMap, SumsOfALargeBrightTemplateDoNotOverflow) {
    const Image image(300, 300, 3, 255);
    Image templ(255, 255, 3, 255);
    templ.at(0, 0) = 254;
    const ScoreMap map = score_map(Measure::ncc, image, templ, all_positions(image, templ));
    EXPECT_NEAR(map.at(3, 4), by_definition(Measure::ncc, image, templ, 3, 4), 1e-6);
    const Image dark(300, 300, 3, 0);
    EXPECT_EQ(score_at(Measure::sad, dark, templ, 0, 0), 3.0 * 255.0 * 255.0 * 255.0 - 1.0);
}

TEST(ScoreMap, AFlatPatchIsNoMatchAndNeverNotANumber) {
    std::mt19937 random(2);
    const Image flat(30, 30, 1, 90);
    const Image templ = random_image(random, 7, 7, 1);
    for (const float score :
         score_map(Measure::zncc, flat, templ, all_positions(flat, templ)).scores) {
        EXPECT_EQ(score, 0.0F);
    }
    EXPECT_EQ(score_at(Measure::zncc, templ, Image(5, 5, 1, 7), 0, 0), 0.0);
    EXPECT_EQ(score_at(Measure::ncc, Image(9, 9), Image(5, 5), 0, 0), 0.0);
}

TEST(ScoreMap, IsClippedToFullOverlapAndEmptyWhereThereIsNone) {
    std::mt19937 random(3);
    const Image image = random_image(random, 30, 20, 1);
    const Image templ = random_image(random, 9, 5, 1);
    EXPECT_EQ(score_map(Measure::sad, image, templ, {-5, -5, 100, 100}).positions,
              (Rectangle{0, 0, 22, 16}));
    EXPECT_TRUE(score_map(Measure::sad, image, templ, {22, 0, 5, 5}).empty());
    EXPECT_TRUE(score_map(Measure::sad, templ, image, {0, 0, 5, 5}).empty());
}

TEST(Peak, FindsWhereATemplateWasCutWithFullQuality) {
    std::mt19937 random(4);
    for (int round = 0; round < 20; ++round) {
        const Image image = random_image(random, 60, 50, 1);
        const Rectangle r{static_cast<int>(random() % 48), static_cast<int>(random() % 38), 12, 12};
        const Image templ = cut(image, r);
        for (const Measure measure : {Measure::sad, Measure::ncc, Measure::zncc}) {
            const auto peak =
                best_peak(score_map(measure, image, templ, all_positions(image, templ)), measure);
            ASSERT_TRUE(peak);
            EXPECT_EQ(peak->whole_x, r.x);
            EXPECT_EQ(peak->whole_y, r.y);
            EXPECT_NEAR(quality(measure, peak->score, templ), 1.0, 1e-6);
        }
    }
}

// A smooth pattern moved by a part of a pixel: the parabola must find that part.
TEST(Peak, FindsAPartOfAPixel) {
    const auto pattern = [](double x, double y) {
        return 128.0 + 60.0 * std::sin(0.45 * x + 0.2 * y) + 50.0 * std::cos(0.5 * y - 0.15 * x);
    };
    for (const double shift : {0.0, 0.2, 0.4, -0.3}) {
        Image image(60, 60);
        Image templ(21, 21);
        for (int y = 0; y < 60; ++y) {
            for (int x = 0; x < 60; ++x) {
                image.at(x, y) =
                    static_cast<std::uint8_t>(std::lround(pattern(x - shift, y + 0.5 * shift)));
            }
        }
        for (int y = 0; y < 21; ++y) {
            for (int x = 0; x < 21; ++x) {
                templ.at(x, y) = static_cast<std::uint8_t>(std::lround(pattern(x + 20, y + 18)));
            }
        }
        const auto peak =
            best_peak(score_map(Measure::zncc, image, templ, {14, 12, 13, 13}), Measure::zncc);
        ASSERT_TRUE(peak);
        EXPECT_NEAR(peak->x, 20.0 + shift, 0.03);
        EXPECT_NEAR(peak->y, 18.0 - 0.5 * shift, 0.03);
        EXPECT_FALSE(peak->on_border);
    }
}

TEST(Peak, TellsTheRunnerUpOfARepeatedPattern) {
    std::mt19937 random(5);
    Image image = random_image(random, 80, 40, 1);
    for (int y = 0; y < 12; ++y) {
        for (int x = 0; x < 12; ++x) {
            image.at(50 + x, 20 + y) = image.at(10 + x, 8 + y);
        }
    }
    const Image templ = cut(image, {10, 8, 12, 12});
    const ScoreMap map = score_map(Measure::zncc, image, templ, all_positions(image, templ));
    const auto peak = best_peak(map, Measure::zncc);
    ASSERT_TRUE(peak);
    const auto next = runner_up(map, Measure::zncc, *peak, 4);
    ASSERT_TRUE(next);
    EXPECT_NEAR(*next, 1.0, 1e-6);
}

TEST(Quality, OfSadIsNothingForAFlatPatchOfTheTemplatesMean) {
    std::mt19937 random(6);
    const Image templ = random_image(random, 15, 15, 1);
    double sum = 0.0;
    for (int y = 0; y < 15; ++y) {
        for (int x = 0; x < 15; ++x) {
            sum += templ.at(x, y);
        }
    }
    const Image flat(15, 15, 1, static_cast<std::uint8_t>(std::lround(sum / 225.0)));
    EXPECT_NEAR(quality(Measure::sad, score_at(Measure::sad, flat, templ, 0, 0), templ), 0.0, 0.02);
    EXPECT_EQ(quality(Measure::zncc, -0.4, templ), 0.0);
}

TEST(Measure, NamesAreReadAndOthersRefused) {
    for (const Measure measure : {Measure::sad, Measure::ncc, Measure::zncc}) {
        EXPECT_EQ(*parse_measure(to_string(measure)), measure);
    }
    EXPECT_NE(parse_measure("ssd").error().text().find("sad, ncc, zncc or hamming"),
              std::string::npos);
}

}  // namespace
}  // namespace kambara
