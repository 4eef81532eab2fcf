// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/matching/texture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace kambara {
namespace {

Image drawn(int width, int height, auto grey) {
    Image image(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            image.at(x, y) = static_cast<std::uint8_t>(std::lround(grey(x, y)));
        }
    }
    return image;
}

const Rectangle middle{20, 20, 31, 31};

TEST(CheckTemplate, AcceptsAPatternInBothDirections) {
    const Image image = drawn(
        80, 80, [](int x, int y) { return 128.0 + 50.0 * std::sin(0.4 * x) * std::cos(0.3 * y); });
    EXPECT_TRUE(check_template(image, middle));
}

TEST(CheckTemplate, RefusesNoiseAlone) {
    std::mt19937 random(1);
    std::normal_distribution<double> noise(0.0, 2.5);
    const Image image = drawn(80, 80, [&](int, int) { return 120.0 + noise(random); });
    EXPECT_NE(check_template(image, middle).error().cause.find("no texture"), std::string::npos);
}

TEST(CheckTemplate, RefusesAnEdgeThatSlidesOnItself) {
    const Image image = drawn(80, 80, [](int x, int) { return x < 35 ? 60.0 : 190.0; });
    EXPECT_NE(check_template(image, middle).error().cause.find("one direction"), std::string::npos);
}

TEST(CheckTemplate, RefusesWhatIsOutsideOrTooSmall) {
    const Image image = drawn(80, 80, [](int x, int y) { return (x * 37 + y * 91) % 256; });
    EXPECT_NE(check_template(image, {60, 60, 31, 31}).error().cause.find("not inside"),
              std::string::npos);
    EXPECT_FALSE(check_template(image, {-1, 0, 31, 31}));
    EXPECT_NE(check_template(image, {10, 10, 5, 31}).error().cause.find("too small"),
              std::string::npos);
}

// The covariance must tell the scatter: many noisy copies of a pattern, each matched to the clean
// one by least squares along x.
TEST(MatchCovariance, TellsTheScatterOfNoisyMatches) {
    constexpr double sigma = 6.0;
    const auto pattern = [](double x, double y) {
        return 128.0 + 45.0 * std::sin(0.5 * x + 0.1 * y) + 35.0 * std::cos(0.45 * y);
    };
    const Image templ = drawn(21, 21, [&](int x, int y) { return pattern(x + 10, y + 10); });
    std::mt19937 random(2);
    std::normal_distribution<double> noise(0.0, sigma);
    double squares = 0.0;
    double predicted = 0.0;
    constexpr int rounds = 300;
    for (int round = 0; round < rounds; ++round) {
        const Image image = drawn(41, 41, [&](int x, int y) {
            return std::clamp(pattern(x, y) + noise(random), 0.0, 255.0);
        });
        double gg = 0.0;
        double ge = 0.0;
        for (int y = 10; y < 31; ++y) {
            for (int x = 10; x < 31; ++x) {
                const double g = 0.5 * (pattern(x + 1, y) - pattern(x - 1, y));
                gg += g * g;
                ge += g * (image.at(x, y) - pattern(x, y));
            }
        }
        squares += (ge / gg) * (ge / gg);
        predicted += match_covariance_px2(image, templ, {0, 0, templ.width(), templ.height()}, 10,
                                          10, 0.0)(0, 0);
    }
    // The picture's own noise adds to its gradients, so the prediction is a little low.
    EXPECT_NEAR(std::sqrt(predicted / squares), 1.0, 0.2);
}

}  // namespace
}  // namespace kambara
