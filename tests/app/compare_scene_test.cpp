// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/compare_scene.h"

#include <gtest/gtest.h>

#include <cmath>

namespace kambara::cli {
namespace {

using Place = std::optional<Eigen::Vector3d>;

CompareRun run_of(std::vector<Place> places) {
    CompareRun run;
    run.tracked_in_left_mm = std::move(places);
    return run;
}

TEST(CompareScene, TellsRightFromWrongAndLost) {
    const std::vector<Place> truth{Eigen::Vector3d(0, 0, 1000), Eigen::Vector3d(0, 0, 1000),
                                   Eigen::Vector3d(0, 0, 1000), Eigen::Vector3d(0, 0, 1000),
                                   std::nullopt};
    const auto score =
        score_of(run_of({Eigen::Vector3d(0, 0, 1002), Eigen::Vector3d(0, 4, 1000),
                         Eigen::Vector3d(0, 0, 1050), std::nullopt, Eigen::Vector3d(1, 1, 1)}),
                 truth);
    EXPECT_DOUBLE_EQ(score.right, 0.5);
    EXPECT_DOUBLE_EQ(score.wrong, 0.25);
    EXPECT_NEAR(score.error_mean_pct, 0.3, 1e-12);
    EXPECT_TRUE(std::isnan(score_of(run_of(std::vector<Place>(5)), truth).error_mean_pct));
}

TEST(CompareScene, WithoutATruthTheMethodsMedianStandsForIt) {
    CompareScene scene;
    scene.truth_in_left_mm.resize(2);
    const auto reference =
        reference_of(scene, {run_of({Eigen::Vector3d(1, 2, 1000), Eigen::Vector3d(0, 0, 1)}),
                             run_of({Eigen::Vector3d(2, 3, 1001), std::nullopt}),
                             run_of({Eigen::Vector3d(900, 0, 9000), Eigen::Vector3d(0, 0, 2)})});
    ASSERT_TRUE(reference[0]);
    EXPECT_EQ(*reference[0], Eigen::Vector3d(2, 2, 1001));
    EXPECT_FALSE(reference[1]);  // two voices are no majority
}

TEST(CompareScene, EveryMethodFollowsTheSimulatedTargetInClearAir) {
    const auto scene = simulated_scene("default?seed=2&particles=0&haze=0", 8, 31);
    ASSERT_TRUE(scene);
    EXPECT_EQ(scene->pairs.size(), 8U);
    const auto methods = all_methods();
    EXPECT_EQ(methods.size(), 20U);
    int good = 0;
    for (const MatchMethod& method : methods) {
        const CompareRun run = run_method(*scene, method);
        EXPECT_FALSE(run.refused);
        const auto score = score_of(run, scene->truth_in_left_mm);
        EXPECT_EQ(score.wrong, 0.0) << to_string(method.measure) << to_string(method.transform);
        good += score.right == 1.0 && score.error_mean_pct < 0.2 ? 1 : 0;
    }
    EXPECT_GE(good, 18);
    EXPECT_FALSE(simulated_scene("chessboard", 4, 31));
    EXPECT_FALSE(simulated_scene("storm", 4, 31));
}

}  // namespace
}  // namespace kambara::cli
