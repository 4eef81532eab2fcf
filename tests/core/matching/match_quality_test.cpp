// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/matching/match_quality.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace kambara {
namespace {

// All that can be written, the methods that make no sense included.
std::vector<MatchMethod> every_method() {
    std::vector<MatchMethod> methods;
    for (const Measure measure : {Measure::sad, Measure::ncc, Measure::zncc, Measure::hamming}) {
        for (const Transform transform :
             {Transform::none, Transform::gaussian, Transform::rank3, Transform::rank5,
              Transform::census, Transform::sdog, Transform::gradient}) {
            methods.push_back({measure, transform, 1});
        }
    }
    return methods;
}

TEST(MatchQuality, IsAProbabilityWhateverTheEvidence) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr double inf = std::numeric_limits<double>::infinity();
    const double values[] = {-inf, -1.0, 0.0, 1e-300, 0.3, 1.0 - 1e-16, 1.0, 7.0, inf, nan};
    for (const MatchMethod& method : every_method()) {
        for (const double likeness : values) {
            for (const double rival : values) {
                const double p = match_probability(method, {likeness, rival});
                EXPECT_TRUE(p >= 0.0 && p <= 1.0) << likeness << " " << rival;
            }
            const double alone = match_probability(method, {likeness, std::nullopt});
            EXPECT_TRUE(alone >= 0.0 && alone <= 1.0) << likeness;
        }
    }
}

TEST(MatchQuality, NeverFallsAsTheEvidenceImproves) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    for (const MatchMethod& method : every_method()) {
        const auto p = [&](double likeness, std::optional<double> rival) {
            return match_probability(method, {likeness, rival}) + 1e-12;
        };
        for (int i = 0; i < 2000; ++i) {
            const double likeness = uniform(random);
            const double rival = likeness * uniform(random);
            const double more = (1.0 - likeness) * uniform(random);
            EXPECT_GE(p(likeness + more, rival), p(likeness, rival) - 1e-12);
            EXPECT_GE(p(likeness + more, rival + more), p(likeness, rival) - 1e-12);
            EXPECT_GE(p(likeness, rival * uniform(random)), p(likeness, rival) - 1e-12);
            EXPECT_GE(p(likeness + more, std::nullopt), p(likeness, std::nullopt) - 1e-12);
        }
    }
}

TEST(MatchQuality, TellsTheOnlyPlaceFromOneOfTwo) {
    for (const MatchMethod& method : every_method()) {
        EXPECT_GT(match_probability(method, {1.0, 0.3}), 0.9);
        EXPECT_LT(match_probability(method, {0.5, 0.5}), 0.5);
        const double usual = quality_model(method).usual_rival;
        EXPECT_EQ(match_probability(method, {0.9, std::nullopt}),
                  match_probability(method, {0.9, usual}));
    }
}

TEST(MatchQuality, MethodsThatWereFittedHaveModelsOfTheirOwn) {
    const QualityModel& pooled = quality_model({Measure::hamming, Transform::none});
    int own = 0;
    for (const MatchMethod& method : every_method()) {
        const QualityModel& model = quality_model(method);
        own += &model != &pooled ? 1 : 0;
        for (std::size_t i = 1; i < model.weights.size(); ++i) {
            EXPECT_GE(model.weights[i], 0.0);
        }
        MatchMethod sparse = method;
        sparse.step = 3;
        EXPECT_EQ(&quality_model(sparse), &model);
    }
    EXPECT_EQ(own, 20);
}

Image noise(int width, int height) {
    std::mt19937 random(5);
    Image picture(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            picture.at(x, y) = static_cast<std::uint8_t>(random() % 256U);
        }
    }
    return picture;
}

TEST(MatchQuality, TheRivalLiesApartFromThePeak) {
    Image picture = noise(80, 60);
    for (int y = 0; y < 9; ++y) {  // the same again, but for one pixel, 20 px to the right
        for (int x = 0; x < 9; ++x) {
            picture.at(40 + x, 30 + y) = picture.at(20 + x, 30 + y);
        }
    }
    picture.at(44, 34) = static_cast<std::uint8_t>(255 - picture.at(44, 34));
    Matcher matcher;
    ScoreMap map;
    matcher.set_template(picture, {20, 30, 9, 9});
    const auto evidence_in = [&](const Rectangle& positions) {
        matcher.scores(picture, positions, map);
        return match_evidence(matcher, map, *best_peak(map, Measure::zncc));
    };
    const MatchEvidence twice = evidence_in({10, 20, 40, 20});
    EXPECT_NEAR(twice.likeness, 1.0, 1e-6);
    EXPECT_GT(twice.runner_up.value(), 0.9);
    const MatchEvidence once = evidence_in({10, 20, 20, 20});
    EXPECT_LT(once.runner_up.value(), 0.6);
    EXPECT_GT(match_probability(matcher.method(), once), 0.95);
    EXPECT_LT(match_probability(matcher.method(), twice),
              match_probability(matcher.method(), once));
    EXPECT_FALSE(evidence_in({19, 29, 3, 3}).runner_up);
    EXPECT_EQ(apart_px(9, 40), 3);
    EXPECT_EQ(apart_px(31, 41), 10);
}

TEST(MatchQuality, AFlatTemplateIsNoEvidence) {
    const Image grey = noise(40, 40);
    const Image flat(40, 40, 1, 90);
    for (const MatchMethod method :
         {MatchMethod{}, MatchMethod{Measure::sad, Transform::none, 1}}) {
        Matcher matcher(method);
        ScoreMap map;
        matcher.set_template(flat, {10, 10, 11, 11});
        for (const Image* picture : {&grey, &flat}) {
            matcher.scores(*picture, {5, 5, 15, 15}, map);
            const auto peak = best_peak(map, method.measure);
            const double p = match_probability(method, match_evidence(matcher, map, *peak));
            EXPECT_TRUE(p >= 0.0 && p < 0.2) << p;
        }
    }
}

}  // namespace
}  // namespace kambara
