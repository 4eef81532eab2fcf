// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/matching/subpixel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "core/matching/cubic_spline.h"
#include "core/matching/matcher.h"
#include "core/matching/peak.h"

namespace kambara {
namespace {

// A random texture known at every place: waves with the spectrum of noise under a Gaussian blur.
class Texture {
  public:
    Texture(std::mt19937& random, double blur_px, double contrast_grey) {
        std::normal_distribution<double> frequency(0.0, 1.0 / blur_px);
        std::uniform_real_distribution<double> phase(0.0, 2.0 * std::numbers::pi);
        constexpr int waves = 60;
        for (int i = 0; i < waves; ++i) {
            waves_.push_back({frequency(random), frequency(random), phase(random)});
        }
        amplitude_ = contrast_grey * std::sqrt(2.0 / waves);
    }
    double at(double x, double y) const {
        double sum = 0.0;
        for (const Wave& w : waves_) {
            sum += std::cos(w.x * x + w.y * y + w.phase);
        }
        return 128.0 + amplitude_ * sum;
    }

  private:
    struct Wave {
        double x, y, phase;
    };
    std::vector<Wave> waves_;
    double amplitude_;
};

Image drawn(const Texture& texture, int width, int height, double shift_x, double shift_y,
            double noise_grey, std::mt19937& random) {
    std::normal_distribution<double> noise(0.0, noise_grey);
    Image image(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const double value = texture.at(x - shift_x, y - shift_y) + noise(random);
            image.at(x, y) = static_cast<std::uint8_t>(std::clamp(value + 0.5, 0.0, 255.0));
        }
    }
    return image;
}

TEST(CubicSpline, PassesThroughThePixelsAndFollowsASmoothSurface) {
    std::mt19937 random(1);
    const Texture texture(random, 3.0, 30.0);
    const Image image = drawn(texture, 40, 30, 0.0, 0.0, 0.0, random);
    const CubicSpline spline(image, {2, 3, 35, 25});
    for (int y = 5; y < 26; ++y) {
        for (int x = 5; x < 34; ++x) {
            ASSERT_NEAR(spline.value(x, y), image.at(x, y), 1e-9);
            ASSERT_NEAR(spline.value(x + 0.37, y + 0.61), texture.at(x + 0.37, y + 0.61), 1.5);
            const auto slope = spline.gradient(x + 0.37, y + 0.61);
            const double h = 1e-4;
            ASSERT_NEAR(
                slope.x,
                (spline.value(x + 0.37 + h, y + 0.61) - spline.value(x + 0.37 - h, y + 0.61)) /
                    (2 * h),
                1e-4);
            ASSERT_NEAR(
                slope.y,
                (spline.value(x + 0.37, y + 0.61 + h) - spline.value(x + 0.37, y + 0.61 - h)) /
                    (2 * h),
                1e-4);
        }
    }
}

struct Spread {
    double bias_px = 0.0;  // the worst mean error over the shifts, in x or y
    double deviation_px = 0.0;
    double expected_px = 0.0;  // what the covariance says
    double parabola_px = 0.0;  // the worst mean error of the parabola through the scores
};

// Template and picture with noise of their own, shifted by known parts of a pixel.
Spread measured(int width, int height, double blur_px) {
    constexpr int shifts = 10;
    constexpr int rounds = 20;
    std::mt19937 random(7);
    Spread spread;
    double squares = 0.0;
    double expected = 0.0;
    int n = 0;
    for (int s = 0; s < shifts; ++s) {
        const double shift = static_cast<double>(s) / shifts - 0.45;
        Eigen::Vector2d sum = Eigen::Vector2d::Zero();
        Eigen::Vector2d sum_parabola = Eigen::Vector2d::Zero();
        std::vector<Eigen::Vector2d> errors;
        for (int round = 0; round < rounds; ++round) {
            const Texture texture(random, blur_px, 30.0);
            const Image a = drawn(texture, 43, 43, 0.0, 0.0, 2.0, random);
            const Image b = drawn(texture, 43, 43, shift, -0.6 * shift, 2.0, random);
            const Rectangle place{11, 11, width, height};
            Matcher matcher;
            matcher.set_template(a, place);
            ScoreMap map;
            matcher.scores(b, {8, 8, 7, 7}, map);
            const auto peak = best_peak(map, Measure::zncc);
            const Eigen::Vector2d truth(11.0 + shift, 11.0 - 0.6 * shift);
            const auto refined = refine_match(b, a, place, {peak->x, peak->y});
            EXPECT_TRUE(refined);
            if (!refined) {
                continue;
            }
            errors.push_back(refined->position_px - truth);
            sum += errors.back();
            sum_parabola += Eigen::Vector2d(peak->x, peak->y) - truth;
            expected += refined->covariance_px2.trace();
        }
        const Eigen::Vector2d mean = sum / rounds;
        spread.bias_px = std::max(spread.bias_px, mean.cwiseAbs().maxCoeff());
        spread.parabola_px =
            std::max(spread.parabola_px, (sum_parabola / rounds).cwiseAbs().maxCoeff());
        for (const auto& error : errors) {
            squares += error.squaredNorm();
            n += 2;
        }
    }
    spread.deviation_px = std::sqrt(squares / n);
    spread.expected_px = std::sqrt(expected / n);
    return spread;
}

TEST(Subpixel, IsUnbiasedAndSteadyOnTexture) {
    for (const auto& [width, height] : {std::pair(14, 18), std::pair(21, 21)}) {
        for (const double blur_px : {1.0, 2.0, 3.0}) {
            const Spread spread = measured(width, height, blur_px);
            std::printf(
                "%d x %d, blur %.0f px: bias %.4f px (parabola %.4f), deviation %.4f px, "
                "by the covariance %.4f px\n",
                width, height, blur_px, spread.bias_px, spread.parabola_px, spread.deviation_px,
                spread.expected_px);
            EXPECT_LE(spread.bias_px, 0.02);
            EXPECT_LE(spread.deviation_px, 0.05);
            EXPECT_NEAR(spread.expected_px / spread.deviation_px, 1.0, 0.5);
        }
    }
}

TEST(Subpixel, GivesGainAndOffset) {
    std::mt19937 random(3);
    const Texture texture(random, 2.0, 30.0);
    const Image a = drawn(texture, 60, 60, 0.0, 0.0, 0.0, random);
    Image b = drawn(texture, 60, 60, 0.3, 0.2, 0.0, random);
    for (int y = 0; y < 60; ++y) {
        for (int x = 0; x < 60; ++x) {
            b.at(x, y) = static_cast<std::uint8_t>(std::lround(0.5 * b.at(x, y) + 60.0));
        }
    }
    const auto match = refine_match(b, a, {20, 20, 21, 21}, {20.0, 20.0});
    ASSERT_TRUE(match);
    EXPECT_NEAR(match->gain, 0.5, 0.01);
    EXPECT_NEAR(match->offset_grey, 60.0, 1.5);
    EXPECT_LT((match->position_px - Eigen::Vector2d(20.3, 20.2)).norm(), 0.03);
}

TEST(Subpixel, RefusesWhatIsFlatSlidesOrIsNotThere) {
    std::mt19937 random(4);
    const Image flat(60, 60, 1, 90);
    EXPECT_FALSE(refine_match(flat, flat, {20, 20, 21, 21}, {20.0, 20.0}));
    Image edge(60, 60, 1, 40);
    for (int y = 0; y < 60; ++y) {
        for (int x = 30; x < 60; ++x) {
            edge.at(x, y) = 200;
        }
    }
    EXPECT_FALSE(refine_match(edge, edge, {20, 20, 21, 21}, {20.0, 20.0}));
    const Texture texture(random, 2.0, 30.0);
    const Image a = drawn(texture, 60, 60, 0.0, 0.0, 0.0, random);
    EXPECT_FALSE(refine_match(a, a, {20, 20, 21, 21}, {-30.0, 20.0}));
    EXPECT_FALSE(refine_match(a, a, {20, 20, 21, 21}, {39.5, 20.0}));
}

}  // namespace
}  // namespace kambara
