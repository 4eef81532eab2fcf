// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/compare_scene.h"

#include <gtest/gtest.h>

#include <cmath>

#include "app/cli/compare_run.h"
#include "app/cli/compare_score.h"
#include "app/cli/compare_truth.h"
#include "app/cli/compare_verdict.h"
#include "hardware/simulated/simulated_profile.h"

namespace kambara::cli {
namespace {

using Seen = std::optional<Sighting>;

Sighting at(double x_px, double y_px, double right_x_px, double range_mm) {
    return {{x_px, y_px}, Eigen::Vector2d(right_x_px, y_px), range_mm};
}

CompareRun run_of(std::vector<Seen> seen) {
    CompareRun run;
    run.seen = std::move(seen);
    return run;
}

CompareScene scene_of(std::vector<Seen> truth) {
    CompareScene scene;
    scene.truth = std::move(truth);
    return scene;
}

TEST(CompareScore, TellsOnTargetFromOffAndLost) {
    const Sighting place = at(100, 50, 60, 1000);
    const auto scene = scene_of({place, place, place, place, std::nullopt});
    const auto score = score_of(scene,
                                run_of({at(100, 51, 60, 1002), at(102, 50, 60, 1004),
                                        at(100, 50, 64, 1000), std::nullopt, at(1, 1, 1, 1)}),
                                scene.truth);
    EXPECT_DOUBLE_EQ(score.kept, 0.75);
    EXPECT_DOUBLE_EQ(score.on_target, 0.5);
    EXPECT_DOUBLE_EQ(score.off_target, 0.25);  // in the right picture
    EXPECT_NEAR(score.error_px, 1.5, 1e-12);
    EXPECT_NEAR(score.range_error_pct, 0.3, 1e-12);
    EXPECT_FALSE(score.there_and_back);
    EXPECT_TRUE(std::isnan(score_of(scene, run_of(std::vector<Seen>(5)), scene.truth).error_px));
}

TEST(CompareScore, WithoutATruthTheMedianAndTheWayBackCount) {
    const auto scene = scene_of(std::vector<Seen>(2));
    std::vector<CompareRun> runs{run_of({Sighting{{10, 20}, {}, {}}, Sighting{{0, 0}, {}, {}}}),
                                 run_of({Sighting{{11, 21}, {}, {}}, std::nullopt}),
                                 run_of({Sighting{{90, 90}, {}, {}}, Sighting{{1, 1}, {}, {}}})};
    const auto reference = reference_of(scene, runs);
    ASSERT_TRUE(reference[0]);
    EXPECT_EQ(reference[0]->left_px, Eigen::Vector2d(11, 21));
    EXPECT_FALSE(reference[1]);  // two voices are no majority
    runs[0].seen_back = {Sighting{{10, 22}, {}, {}}, Sighting{{9, 9}, {}, {}}};
    runs[0].best_left_px = {Eigen::Vector2d(11, 19), std::nullopt};
    const auto score = score_of(scene, runs[0], reference);
    EXPECT_DOUBLE_EQ(score.found, 0.5);
    EXPECT_DOUBLE_EQ(score.kept, 1.0);
    EXPECT_DOUBLE_EQ(score.on_target, 0.5);
    EXPECT_DOUBLE_EQ(score.there_and_back.value(), 0.5);
    EXPECT_TRUE(std::isnan(score.range_error_pct));
}

SceneResult result_of(double shipped_share, double other_share) {
    SceneResult result;
    result.scene = scene_of({at(0, 0, 0, 1000), at(0, 0, 0, 1000)});
    result.scene.name = "pond";
    result.scene.disturbed = true;
    result.scene.attenuation_lengths = {1.2, 2.9};
    result.runs = {run_of(result.scene.truth), run_of({at(0, 0, 0, 1000), at(9, 9, 9, 1000)})};
    result.runs[0].method = {Measure::sad, Transform::none, 1};
    result.runs[1].method = {Measure::zncc, Transform::census, 1};
    result.scores.resize(2);
    result.scores[0].on_target = shipped_share;
    result.scores[1].on_target = other_share;
    return result;
}

TEST(CompareVerdict, FollowsTheNumbers) {
    const MatchMethod shipped{Measure::sad, Transform::none, 1};
    const auto good = verdict_on({result_of(1.0, 0.5)}, shipped);
    ASSERT_EQ(good.size(), 3U);
    EXPECT_NE(good[0].find("The default is sad."), std::string::npos) << good[0];
    EXPECT_NE(good[0].find("the first of 2"), std::string::npos) << good[0];
    EXPECT_NE(good[1].find("none is in more"), std::string::npos) << good[1];
    EXPECT_NE(good[2].find("on target in 100.0 %"), std::string::npos) << good[2];
    const auto bad = verdict_on({result_of(0.5, 1.0)}, shipped);
    EXPECT_NE(bad[0].find("would be the better default"), std::string::npos) << bad[0];
    EXPECT_NE(bad[1].find("not the best here"), std::string::npos) << bad[1];
    // The other way round, the attenuation's numbers are the other method's.
    const auto missed = verdict_on({result_of(0.5, 1.0)}, {Measure::zncc, Transform::census, 1});
    EXPECT_NE(missed.back().find("50.0 % of the frames; 99.0 % are asked for, and missed"),
              std::string::npos)
        << missed.back();
    EXPECT_NE(missed.back().find("Beside it: sad in 100.0 %"), std::string::npos) << missed.back();
}

TEST(CompareScore, CountsFramesByAttenuationLengths) {
    const std::vector<SceneResult> results{result_of(1.0, 0.5)};
    const auto bins = bins_of(results, 1);
    ASSERT_EQ(bins.size(), 6U);
    EXPECT_EQ(bins[2].frames, 1U);
    EXPECT_EQ(bins[2].share(), 1.0);
    EXPECT_EQ(bins[5].share(), 0.0);
    EXPECT_TRUE(std::isnan(bins[0].share()));
    EXPECT_EQ(disturbed_up_to(results, 1, 2.0).frames, 1U);
}

TEST(CompareScene, EveryMethodFollowsTheSimulatedTargetInClearAir) {
    WorkerPool pool;
    const auto scene = simulated_scene("air", "default?seed=2&particles=0&haze=0", 0.27, 31, pool);
    ASSERT_TRUE(scene);
    EXPECT_EQ(scene->pairs.size(), 8U);
    EXPECT_EQ(scene->attenuation_lengths.front(), 0.0);
    const auto methods = all_methods();
    EXPECT_EQ(methods.size(), 20U);
    int good = 0;
    for (const MatchMethod& method : methods) {
        const CompareRun run = run_method(*scene, method);
        EXPECT_FALSE(run.refused);
        const auto score = score_of(*scene, run, scene->truth);
        EXPECT_EQ(score.off_target, 0.0) << label_of(method);
        good += score.on_target == 1.0 && score.range_error_pct < 0.2 ? 1 : 0;
    }
    EXPECT_GE(good, 18);
    EXPECT_FALSE(simulated_scene("c", "chessboard", 1.0, 31, pool));
    EXPECT_FALSE(simulated_scene("s", "storm", 1.0, 31, pool));
}

TEST(CompareScene, ScenesAreNamed) {
    EXPECT_EQ(parse_scenes("all")->size(), named_scenes().size());
    EXPECT_EQ(parse_scenes("water")->size(), named_scenes().size() - 1);
    EXPECT_EQ(parse_scenes("harbour,air")->size(), 2U);
    for (const char* bad : {"", "lava", "air,,", "air,air"}) {
        EXPECT_FALSE(parse_scenes(bad)) << bad;
    }
    for (const NamedScene& scene : named_scenes()) {
        EXPECT_TRUE(simulated_profile(scene.profile)) << scene.profile;
    }
}

}  // namespace
}  // namespace kambara::cli
