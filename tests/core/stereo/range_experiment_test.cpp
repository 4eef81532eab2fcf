// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/stereo/range_experiment.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "core/geometry/rigid_transform.h"

namespace kambara {
namespace {

// Seventy-five places of three heights, five depths and five places across, measured `factor` too
// far away, with noise along the ray.
std::vector<RangeStation> stations(double factor, double noise_share, unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0.0, noise_share);
    std::vector<RangeStation> all;
    for (const double y : {-250.0, 0.0, 250.0}) {
        for (const double z : {1000.0, 1250.0, 1500.0, 1750.0, 2000.0}) {
            for (const double angle_deg : {-26.0, -13.0, 0.0, 13.0, 26.0}) {
                const Eigen::Vector3d place(225.0 + z * std::tan(angle_deg * 0.017453292519943295),
                                            y, z);
                RangeStation station{place, {}};
                for (int i = 0; i < 4; ++i) {
                    station.readings_in_left_mm.push_back(factor * (1.0 + noise(random)) * place);
                }
                all.push_back(station);
            }
        }
    }
    return all;
}

TEST(RangeExperiment, ABaselineThatIsWrongIsFoundAndTakenOff) {
    const auto result = judge_ranges(stations(1.15, 0.0, 1), {517.5, std::nullopt, false});
    ASSERT_TRUE(result) << result.error().text();
    EXPECT_NEAR(result->before.mean_range_pct, 15.0, 1e-9);
    EXPECT_NEAR(result->before.worst_depth_pct, 15.0, 1e-9);
    EXPECT_NEAR(result->corrected_baseline_mm, 450.0, 1e-9);
    EXPECT_LT(result->after.worst_range_pct, 1e-9);
    EXPECT_LT(result->after.worst_position_mm, 1e-9);
    EXPECT_EQ(result->verdict, RangeVerdict::good_corrected);
    EXPECT_TRUE(result->baseline_found);
}

TEST(RangeExperiment, ABaselineFoundFromAFewPlacesProvesNothing) {
    auto few = stations(1.1, 0.0, 1);
    const RangeExperimentOptions found{495.0, std::nullopt, false};
    for (const std::size_t count : {3U, 1U}) {
        few.resize(count);
        const auto result = judge_ranges(few, found);
        ASSERT_TRUE(result) << result.error().text();
        EXPECT_LT(result->after.worst_range_pct, 1e-9);
        EXPECT_EQ(result->verdict, RangeVerdict::too_few_places) << count;
    }
    const auto by_tape = judge_ranges(few, {495.0, 450.0, false});
    ASSERT_TRUE(by_tape);
    EXPECT_EQ(by_tape->verdict, RangeVerdict::good_corrected) << "a tape proves it";
    EXPECT_FALSE(by_tape->baseline_found);
    const auto right = judge_ranges({stations(1.0, 0.0, 1)[40]}, {450.0, std::nullopt, false});
    ASSERT_TRUE(right);
    EXPECT_EQ(right->verdict, RangeVerdict::good) << "nothing was fitted";
}

TEST(RangeExperiment, ABaselineThatCannotBeIsRefused) {
    const auto wrong = judge_ranges(stations(1.485, 0.0, 1), {450.0, std::nullopt, false});
    ASSERT_FALSE(wrong);
    EXPECT_NE(wrong.error().cause.find("303 mm"), std::string::npos) << wrong.error().cause;
    EXPECT_NE(wrong.error().cause.find("48.5 %"), std::string::npos) << wrong.error().cause;
    const auto by_tape = judge_ranges(stations(1.485, 0.0, 1), {450.0, 448.0, false});
    ASSERT_TRUE(by_tape) << "a tape is believed";
    EXPECT_EQ(by_tape->verdict, RangeVerdict::not_good);
}

TEST(RangeExperiment, ATargetThatMovedProvesNothing) {
    auto all = stations(1.0, 0.0, 1);
    const RangeExperimentOptions options{450.0, std::nullopt, false};
    ASSERT_EQ(judge_ranges(all, options)->verdict, RangeVerdict::good);
    // 120 mm sideways: its range hardly changes.
    auto& readings = all[7].readings_in_left_mm;
    for (std::size_t i = 0; i < readings.size(); ++i) {
        readings[i].x() += 40.0 * (static_cast<double>(i) - 1.5);
    }
    const auto moved = judge_ranges(all, options);
    ASSERT_TRUE(moved);
    EXPECT_EQ(moved->verdict, RangeVerdict::moved);
    EXPECT_FALSE(moved->before.stations[7].steady);
    EXPECT_NEAR(moved->before.stations[7].spread_mm, 40.0 * std::sqrt(1.25), 1e-9);
    EXPECT_TRUE(moved->before.stations[8].steady);
    // A steady one's noise, four times what a rig of that kind shows, is no motion.
    EXPECT_EQ(judge_ranges(stations(1.0, 0.002, 1), options)->verdict, RangeVerdict::good);
}

TEST(RangeExperiment, AMeasuredBaselineIsTakenAsItIs) {
    const auto result = judge_ranges(stations(1.15, 0.0, 1), {517.5, 455.0, false});
    ASSERT_TRUE(result) << result.error().text();
    EXPECT_EQ(result->corrected_baseline_mm, 455.0);
    EXPECT_EQ(result->corrected_baseline_sigma_mm, 0.0);
    EXPECT_NEAR(result->after.mean_range_pct, 100.0 * (455.0 / 450.0 - 1.0), 1e-9);
}

// The deviation told of the found baseline is that of the baselines found over 200 experiments.
TEST(RangeExperiment, ItsDeviationIsWhatRepetitionShows) {
    double squares = 0.0;
    double told = 0.0;
    const int times = 200;
    for (unsigned seed = 0; seed < times; ++seed) {
        const auto result = judge_ranges(stations(1.0, 0.01, seed), {450.0, std::nullopt, false});
        ASSERT_TRUE(result);
        squares += std::pow(result->corrected_baseline_mm - 450.0, 2) / times;
        told += result->corrected_baseline_sigma_mm / times;
        EXPECT_NEAR(result->before.stations[40].scatter_mm,
                    0.01 * result->before.stations[40].known_in_left_mm.norm(), 40.0);
    }
    EXPECT_NEAR(told / std::sqrt(squares), 1.0, 0.15);
}

TEST(RangeExperiment, AFrameThatIsNotKnownIsLaidUponTheMeasuredPlaces) {
    auto all = stations(1.1, 0.0, 1);
    const RigidTransform T_own_from_left{rotation_about_y(0.4) * rotation_about_x(-0.2),
                                         {3000.0, -500.0, 200.0}};
    for (RangeStation& station : all) {
        station.known_mm = T_own_from_left * station.known_mm;
    }
    const auto result = judge_ranges(all, {495.0, std::nullopt, true});
    ASSERT_TRUE(result) << result.error().text();
    EXPECT_GT(result->before.worst_position_mm, 10.0);
    EXPECT_NEAR(result->corrected_baseline_mm, 450.0, 1e-6);
    EXPECT_LT(result->after.worst_position_mm, 1e-6);
}

TEST(RangeExperiment, RefusesWhatCannotBeJudged) {
    const RangeExperimentOptions options{450.0, std::nullopt, false};
    EXPECT_FALSE(judge_ranges({}, options));
    EXPECT_FALSE(judge_ranges({{{0.0, 0.0, 1000.0}, {}}}, options));
    EXPECT_FALSE(judge_ranges({{{0.0, 0.0, NAN}, {{0.0, 0.0, 1000.0}}}}, options));
    EXPECT_FALSE(judge_ranges({{{0.0, 0.0, -5.0}, {{0.0, 0.0, 1000.0}}}}, options));
    EXPECT_FALSE(judge_ranges({{{0.0, 0.0, 1000.0}, {{0.0, 0.0, -1.0}}}}, options));
    EXPECT_FALSE(judge_ranges(stations(1.0, 0.0, 1), {0.0, std::nullopt, false}));
    std::vector<RangeStation> line;
    for (const double z : {1000.0, 1100.0, 1200.0, 1300.0, 1400.0}) {
        line.push_back({{0.0, 0.0, z}, {{0.0, 0.0, z}}});
    }
    EXPECT_TRUE(judge_ranges(line, options));
    EXPECT_FALSE(judge_ranges(line, {450.0, std::nullopt, true}));
}

}  // namespace
}  // namespace kambara
