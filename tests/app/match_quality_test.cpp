// SPDX-License-Identifier: GPL-3.0-or-later
// Whether the calibrated quality of a match is the probability that it is right, on the halves of
// real recordings that it was not fitted to. See tests/benchmark/quality_calibration.cpp.
#include "core/matching/match_quality.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <vector>

#include "tests/support/logistic_fit.h"
#include "tests/support/real_searches.h"
#include "tests/support/reliability.h"

namespace kambara {
namespace {

using namespace testing_support;

TEST(Reliability, ComparesByTenths) {
    const Reliability reliability =
        reliability_of({{0.95, true}, {0.95, true}, {0.85, false}, {1.0, true}, {0.05, true}});
    EXPECT_EQ(reliability.count, 5);
    EXPECT_EQ(reliability.bins[9].count, 3);
    EXPECT_DOUBLE_EQ(reliability.bins[9].share_true, 1.0);
    EXPECT_NEAR(reliability.bins[9].mean_probability, 2.9 / 3.0, 1e-12);
    EXPECT_NEAR(reliability.calibration_error, (0.1 + 0.85 + 0.95) / 5.0, 1e-12);
    EXPECT_NEAR(reliability.brier_score, (2 * 0.0025 + 0.7225 + 0.9025) / 5.0, 1e-12);
    EXPECT_EQ(reliability_of({}).count, 0);
}

TEST(LogisticFit, FindsTheModelThatMadeTheOutcomesWithinItsBounds) {
    constexpr int count = 20000;
    LogisticSamples samples{Eigen::MatrixXd(count, 3), Eigen::VectorXd(count)};
    Random random(1);
    for (Eigen::Index i = 0; i < count; ++i) {
        const double a = random.between(0.0, 1.0);
        const double b = random.between(0.0, 1.0);
        const double p = 1.0 / (1.0 + std::exp(2.0 - 5.0 * a + b));  // b speaks against it
        samples.features.row(i) << 1.0, a, b;
        samples.outcomes[i] = random.between(0.0, 1.0) < p ? 1.0 : 0.0;
    }
    const Eigen::VectorXd bounded = fit_logistic(samples);
    EXPECT_NEAR(bounded[1], 5.0, 0.3);
    EXPECT_EQ(bounded[2], 0.0);
    samples.features.col(2) *= -1.0;
    const Eigen::VectorXd free = fit_logistic(samples);
    EXPECT_NEAR(free[0], -2.0, 0.2);
    EXPECT_NEAR(free[1], 5.0, 0.3);
    EXPECT_NEAR(free[2], 1.0, 0.3);
}

// With 1200 matches a perfect model shows an error of about 0.02 by chance alone.
constexpr int searches_per_half = 200;
constexpr double most_calibration_error = 0.05;

TEST(RealDataMatchQuality, IsTheShareOfMatchesThatAreRight) {
    const std::filesystem::path data = KAMBARA_DATA;
    if (!std::filesystem::is_directory(data)) {
        GTEST_SKIP() << "skipped: there is no folder of real recordings at " << data;
    }
    const auto sets = real_searches(data, searches_per_half);
    ASSERT_TRUE(sets) << sets.error().cause;
    for (const MatchMethod method : {MatchMethod{Measure::zncc, Transform::none, 1},
                                     MatchMethod{Measure::zncc, Transform::gaussian, 1},
                                     MatchMethod{Measure::zncc, Transform::gradient, 1},
                                     MatchMethod{Measure::zncc, Transform::rank3, 1},
                                     MatchMethod{Measure::zncc, Transform::rank5, 1},
                                     MatchMethod{Measure::zncc, Transform::sdog, 1},
                                     MatchMethod{Measure::sad, Transform::none, 1},
                                     MatchMethod{Measure::hamming, Transform::census, 1}}) {
        std::vector<Forecast> forecasts;
        for (const SearchSet& set : *sets) {
            for (const MatchSample& sample : samples_of(method, set.held_out)) {
                forecasts.push_back({match_probability(method, sample.evidence), sample.right});
            }
        }
        const Reliability reliability = reliability_of(forecasts);
        std::printf("%s %s: %d matches, %.1f %% right, calibration error %.3f, Brier score %.3f\n",
                    to_string(method.measure).c_str(), to_string(method.transform).c_str(),
                    reliability.count, 100.0 * reliability.share_true,
                    reliability.calibration_error, reliability.brier_score);
        EXPECT_GE(reliability.count, 1100);
        EXPECT_LE(reliability.calibration_error, most_calibration_error);
        EXPECT_GE(reliability.bins[9].count, 100);
        EXPECT_GE(reliability.bins[9].share_true, 0.9);  // as its matches promise
    }
}

}  // namespace
}  // namespace kambara
