// SPDX-License-Identifier: GPL-3.0-or-later
// The transforms and the matcher against their definitions.
#include "core/matching/transform.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "core/matching/matcher.h"
#include "core/matching/peak.h"

namespace kambara {
namespace {

constexpr Transform all[] = {Transform::none,    Transform::gaussian, Transform::rank3,
                             Transform::rank5,   Transform::census,   Transform::sdog,
                             Transform::gradient};

Image noise(std::mt19937& random, int width, int height) {
    Image image(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            image.at(x, y) = static_cast<std::uint8_t>(random() % 256);
        }
    }
    return image;
}

Image whole(const Image& picture, Transform transform) {
    Image out;
    transform_region(picture, transformable(picture, transform), transform, out);
    return out;
}

int darker_neighbours(const Image& image, int x, int y, int radius) {
    int darker = 0;
    for (int v = -radius; v <= radius; ++v) {
        for (int u = -radius; u <= radius; ++u) {
            darker += image.at(x + u, y + v) < image.at(x, y) ? 1 : 0;
        }
    }
    return darker;
}

// A Gaussian by its definition, in floating point, cut off where the transform's is.
double smoothed(const Image& image, int x, int y, double sigma_px, int radius) {
    double sum = 0.0;
    double weights = 0.0;
    for (int v = -radius; v <= radius; ++v) {
        for (int u = -radius; u <= radius; ++u) {
            const double w = std::exp(-0.5 * (u * u + v * v) / (sigma_px * sigma_px));
            sum += w * image.at(x + u, y + v);
            weights += w;
        }
    }
    return sum / weights;
}

TEST(Transform, RankAndCensusCountTheDarkerNeighbours) {
    std::mt19937 random(1);
    const Image image = noise(random, 61, 40);
    const Image rank3 = whole(image, Transform::rank3);
    const Image rank5 = whole(image, Transform::rank5);
    const Image census = whole(image, Transform::census);
    for (int y = 2; y < 38; ++y) {
        for (int x = 2; x < 59; ++x) {
            ASSERT_EQ(rank3.at(x - 1, y - 1), darker_neighbours(image, x, y, 1));
            ASSERT_EQ(rank5.at(x - 2, y - 2), darker_neighbours(image, x, y, 2));
            int k = 0;
            for (int v = -2; v <= 2; ++v) {
                for (int u = -2; u <= 2; ++u) {
                    if (u == 0 && v == 0) {
                        continue;
                    }
                    const int bit = census.at(x - 2, y - 2, k / 8) >> (k % 8) & 1;
                    ASSERT_EQ(bit, image.at(x + u, y + v) < image.at(x, y) ? 1 : 0);
                    ++k;
                }
            }
        }
    }
}

TEST(Transform, SmoothsAsTheGaussianDoes) {
    std::mt19937 random(2);
    const Image image = noise(random, 50, 40);
    const Image smooth = whole(image, Transform::gaussian);
    const Image signs = whole(image, Transform::sdog);
    int clear = 0;
    for (int y = 6; y < 34; ++y) {
        for (int x = 6; x < 44; ++x) {
            const double less = smoothed(image, x, y, 0.8, 2);
            const double more = smoothed(image, x, y, 1.6, 4);
            ASSERT_NEAR(smooth.at(x - 3, y - 3), smoothed(image, x, y, 1.0, 3),
                        2.0);  // weights are rounded to 1/256
            if (std::abs(less - more) > 4.0) {
                ++clear;
                ASSERT_EQ(signs.at(x - 4, y - 4), less > more ? 1 : 0) << less - more;
            }
        }
    }
    EXPECT_GT(clear, 500);
}

// A Gaussian in whole numbers that sum to 256.
std::vector<int> whole_weights(double sigma_px, int radius) {
    double sum = 0.0;
    for (int i = -radius; i <= radius; ++i) {
        sum += std::exp(-0.5 * i * i / (sigma_px * sigma_px));
    }
    std::vector<int> weights;
    int others = 0;
    for (int i = -radius; i <= radius; ++i) {
        const double exact = 256.0 * std::exp(-0.5 * i * i / (sigma_px * sigma_px)) / sum;
        weights.push_back(static_cast<int>(std::lround(exact)));
        others += i == 0 ? 0 : weights.back();
    }
    weights[static_cast<std::size_t>(radius)] = 256 - others;
    return weights;
}

int weighted_sum(const Image& image, int x, int y, const std::vector<int>& weights) {
    const int radius = static_cast<int>(weights.size()) / 2;
    int sum = 0;
    for (int v = -radius; v <= radius; ++v) {
        for (int u = -radius; u <= radius; ++u) {
            sum += weights[static_cast<std::size_t>(v + radius)] *
                   weights[static_cast<std::size_t>(u + radius)] * image.at(x + u, y + v);
        }
    }
    return sum;
}

// Noise of few levels has many places where both are equal or almost so; black and white ones
// reach the ends of what the sums' numbers hold.
TEST(Transform, SignsAreTheExactOnesByEveryKernel) {
    std::mt19937 random(7);
    const std::vector<int> narrow = whole_weights(0.8, 2);
    const std::vector<int> wide = whole_weights(1.6, 4);
    for (int round = 0; round < 40; ++round) {
        Image image = noise(random, 9 + static_cast<int>(random() % 200), 9 + round % 7);
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x) {
                const int value = image.at(x, y);
                image.at(x, y) = static_cast<std::uint8_t>(
                    round % 3 == 0 ? value
                                   : (round % 3 == 1 ? value / 128 * 255 : 90 + value / 86));
            }
        }
        for (const Kernels& kernels : runnable_kernels()) {
            Image signs;
            transform_region(image, transformable(image, Transform::sdog), Transform::sdog, signs,
                             kernels.transforms);
            for (int y = 0; y < signs.height(); ++y) {
                for (int x = 0; x < signs.width(); ++x) {
                    const bool larger = weighted_sum(image, x + 4, y + 4, narrow) >
                                        weighted_sum(image, x + 4, y + 4, wide);
                    ASSERT_EQ(signs.at(x, y), larger ? 1 : 0) << kernels.name << " " << x;
                }
            }
        }
    }
}

TEST(Transform, EveryKernelGivesTheSame) {
    std::mt19937 random(8);
    for (int round = 0; round < 10; ++round) {
        const Image image = noise(random, 12 + static_cast<int>(random() % 150), 12);
        for (const Transform transform : all) {
            Image plain;
            const Rectangle region = transformable(image, transform);
            transform_region(image, region, transform, plain, plain_kernels().transforms);
            for (const Kernels& kernels : runnable_kernels()) {
                Image other;
                transform_region(image, region, transform, other, kernels.transforms);
                ASSERT_EQ(other, plain) << kernels.name << " " << to_string(transform);
            }
        }
    }
}

TEST(Transform, GradientIsAQuarterOfSobels) {
    std::mt19937 random(3);
    const Image image = noise(random, 40, 30);
    const Image gradient = whole(image, Transform::gradient);
    for (int y = 1; y < 29; ++y) {
        for (int x = 1; x < 39; ++x) {
            const auto p = [&](int u, int v) { return static_cast<int>(image.at(x + u, y + v)); };
            const int gx = p(1, -1) + 2 * p(1, 0) + p(1, 1) - p(-1, -1) - 2 * p(-1, 0) - p(-1, 1);
            const int gy = p(-1, 1) + 2 * p(0, 1) + p(1, 1) - p(-1, -1) - 2 * p(0, -1) - p(1, -1);
            const double size = 0.25 * std::hypot(gx, gy);
            ASSERT_EQ(gradient.at(x - 1, y - 1), std::min(255, static_cast<int>(size)));
        }
    }
}

// Order among neighbours survives what water and lamps do to brightness; plain levels don't.
TEST(Transform, RankCensusAndSignsIgnoreGainAndOffset) {
    std::mt19937 random(4);
    Image image = noise(random, 40, 30);
    Image dim = image;
    for (int y = 0; y < 30; ++y) {
        for (int x = 0; x < 40; ++x) {
            image.at(x, y) = static_cast<std::uint8_t>(image.at(x, y) / 4 * 2);
            dim.at(x, y) = static_cast<std::uint8_t>(image.at(x, y) / 2 + 90);
        }
    }
    for (const Transform t : {Transform::rank3, Transform::rank5, Transform::census}) {
        EXPECT_EQ(whole(image, t), whole(dim, t)) << to_string(t);
    }
    EXPECT_EQ(whole(image, Transform::sdog), whole(dim, Transform::sdog));
}

TEST(Transform, APieceIsThatPieceOfTheWhole) {
    std::mt19937 random(5);
    const Image image = noise(random, 90, 70);
    for (const Transform t : all) {
        const Image of_all = whole(image, t);
        const Rectangle region{20, 15, 33, 21};
        Image piece;
        transform_region(image, region, t, piece);
        const int m = margin_px(t);
        for (int y = 0; y < region.height; ++y) {
            for (int x = 0; x < region.width; ++x) {
                for (int c = 0; c < piece.channels(); ++c) {
                    ASSERT_EQ(piece.at(x, y, c), of_all.at(region.x + x - m, region.y + y - m, c));
                }
            }
        }
        EXPECT_EQ(*parse_transform(to_string(t)), t);
        EXPECT_THROW(transform_region(image, {0, 0, 91, 70}, t, piece), std::invalid_argument);
    }
    EXPECT_FALSE(parse_transform("wavelet"));
}

TEST(Matcher, FindsATemplateByEveryMethod) {
    std::mt19937 random(6);
    const Image image = noise(random, 120, 90);
    for (const Measure measure : {Measure::sad, Measure::ncc, Measure::zncc, Measure::hamming}) {
        for (const Transform transform : all) {
            auto method = parse_method(to_string(measure), to_string(transform));
            if (!method) {
                continue;
            }
            for (method->step = 1; method->step <= 3; ++method->step) {
                Matcher matcher(*method);
                matcher.set_template(image, {47, 32, 16, 13});
                for (const Rectangle& where :
                     {Rectangle{0, 0, 120, 90}, Rectangle{40, 28, 15, 9}}) {
                    ScoreMap map;
                    matcher.scores(image, where, map);
                    const auto peak = best_peak(map, measure);
                    ASSERT_TRUE(peak);
                    EXPECT_EQ(peak->whole_x, 47) << to_string(measure) << to_string(transform);
                    EXPECT_EQ(peak->whole_y, 32);
                    EXPECT_NEAR(matcher.quality(peak->score), 1.0, 1e-6);
                    const auto next = runner_up(map, measure, *peak, 5);
                    if (next) {
                        EXPECT_LT(matcher.quality(*next), 0.995);
                    }
                }
            }
        }
    }
}

TEST(Matcher, RefusesBitsAndLevelsThatDoNotGoTogether) {
    EXPECT_NE(parse_method("hamming", "none").error().text().find("census or sdog"),
              std::string::npos);
    EXPECT_NE(parse_method("zncc", "census").error().text().find("hamming"), std::string::npos);
    EXPECT_TRUE(parse_method("ncc", "sdog"));
}

TEST(Peak, OfEqualPlacesTheNearestToTheExpectedOneIsTaken) {
    ScoreMap map;
    map.positions = {10, 20, 100, 50};
    map.costs.assign(5000, 9);
    for (const auto& [x, y] : {std::pair(15, 25), std::pair(90, 60), std::pair(90, 64)}) {
        map.costs[map.index(x, y)] = 3;
    }
    EXPECT_EQ(best_peak(map, Measure::sad)->whole_x, 15);
    const auto near = best_peak(map, Measure::sad, Eigen::Vector2d(88, 63));
    EXPECT_EQ(near->whole_x, 90);
    EXPECT_EQ(near->whole_y, 64);
    const auto between = best_peak(map, Measure::sad, Eigen::Vector2d(90, 62));
    EXPECT_EQ(between->whole_y, 60);  // the first row of two at the same distance
    EXPECT_EQ(*runner_up(map, Measure::sad, *between, 3), 3.0);
    EXPECT_EQ(*runner_up(map, Measure::sad, *between, 30), 3.0);
    EXPECT_FALSE(runner_up(map, Measure::sad, *between, 100));
}

}  // namespace
}  // namespace kambara
