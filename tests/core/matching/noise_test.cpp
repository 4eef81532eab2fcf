// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/matching/noise.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/matching/matcher.h"
#include "core/matching/score_map.h"

namespace kambara {
namespace {

// A smooth pattern, its grey levels rounded after noise is added.
Image smooth(double contrast_grey, double noise_grey, std::mt19937& random) {
    std::normal_distribution<double> noise(0.0, 1.0);
    Image image(80, 80);
    for (int y = 0; y < 80; ++y) {
        for (int x = 0; x < 80; ++x) {
            const double pattern = std::sin(0.31 * x + 0.2 * y) + std::cos(0.23 * x - 0.37 * y);
            const double grey = 120.0 + contrast_grey * pattern + noise_grey * noise(random);
            image.at(x, y) = static_cast<std::uint8_t>(std::clamp(grey + 0.5, 0.0, 255.0));
        }
    }
    return image;
}

const Rectangle piece{20, 20, 41, 41};

double likeness_of(const Image& a, const Image& b, const MatchMethod& method) {
    Matcher matcher(method);
    ScoreMap map;
    matcher.set_template(a, piece);
    matcher.scores(b, {piece.x, piece.y, 1, 1}, map);
    return map.at(piece.x, piece.y);
}

TEST(Noise, IsMeasuredOnSmoothTexture) {
    std::mt19937 random(1);
    for (const double noise : {1.0, 2.0, 4.0}) {
        EXPECT_NEAR(noise_grey(smooth(20.0, noise, random), piece), noise, 0.12 * noise + 0.1);
    }
    EXPECT_EQ(noise_grey(Image(80, 80, 1, 90), piece), 0.0);
    EXPECT_EQ(noise_grey(Image(80, 80, 1, 90), {3, 3, 2, 9}), 0.0);
}

// The law is checked against what noise really takes, over many draws.
TEST(Noise, TakesFromTheLikenessWhatTheLawSays) {
    std::mt19937 random(2);
    for (const Transform transform : {Transform::none, Transform::gaussian}) {
        const MatchMethod method{Measure::zncc, transform};
        for (const double contrast : {20.0, 6.0, 3.0}) {
            double seen = 0.0;
            double said = 0.0;
            constexpr int draws = 40;
            for (int i = 0; i < draws; ++i) {
                const Image a = smooth(contrast, 2.0, random);
                const Image b = smooth(contrast, 2.0, random);
                seen += likeness_of(a, b, method) / draws;
                said += likeness_kept(method, a, piece, b, piece) / draws;
            }
            EXPECT_NEAR(said, seen, 0.03) << to_string(transform) << ", contrast " << contrast;
        }
    }
}

// Were it said to be clear, the tracker would take the noise for the target's own texture.
TEST(Noise, LeavesNextToNothingOfWhatIsNoiseAlone) {
    std::mt19937 random(3);
    const Image a = smooth(0.0, 2.0, random);
    const Image b = smooth(0.0, 2.0, random);
    EXPECT_LT(likeness_kept({Measure::zncc, Transform::none}, a, piece, b, piece), 0.4);
    EXPECT_EQ(likeness_kept({Measure::sad, Transform::none}, a, piece, b, piece), 1.0);
    EXPECT_EQ(likeness_kept({Measure::zncc, Transform::rank3}, a, piece, b, piece), 1.0);
}

}  // namespace
}  // namespace kambara
