// SPDX-License-Identifier: GPL-3.0-or-later
// The main job on the simulated rig, end to end, against its truth.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "app/cli/track_command.h"
#include "app/sources/sources.h"
#include "core/camera/rig_file.h"
#include "core/vsystem/vision_system.h"
#include "hardware/simulated/simulated_grabber.h"
#include "hardware/simulated/simulated_world.h"
#include "tests/support/process.h"

namespace kambara::cli {
namespace {

class SimulatedJobTest : public testing::TestWithParam<int> {};

// A minute of the default scene.
TEST_P(SimulatedJobTest, IsTrackedMeasuredAndPointedAt) {
    TrackOptions options;
    options.sources.left = "sim:default?seed=" + std::to_string(GetParam());
    options.templates = {"auto"};
    options.seconds = 60.0;
    const Outcome outcome = run_track(options);
    ASSERT_FALSE(outcome.failure) << outcome.failure->text();
    const auto report = nlohmann::json::parse(outcome.json);
    const auto& truth = report["truth"];
    RecordProperty("range_error_mean_pct", truth["range_error_mean_pct"].dump());
    std::printf("seed %d: %s\n", GetParam(), truth.dump().c_str());
    EXPECT_EQ(report["frames"], 1800);
    EXPECT_GE(truth["tracked_fraction"].get<double>(), 0.99);
    EXPECT_LE(truth["range_error_mean_pct"].get<double>(), 0.3);
    EXPECT_LE(truth["range_error_worst_pct"].get<double>(), 1.5);
    EXPECT_GE(truth["head_within_1_deg_fraction"].get<double>(), 0.95);
}

INSTANTIATE_TEST_SUITE_P(Seeds, SimulatedJobTest, testing::Values(1, 2, 3, 4, 5));

TEST(SimulatedJob, GivesTheSameTableEveryTime) {
    const auto folder = testing_support::fresh_folder("same_table");
    for (const char* name : {"a.csv", "b.csv"}) {
        TrackOptions options;
        options.sources.left = "sim:default?seed=7&frames=45";
        options.templates = {"auto"};
        options.csv = folder / name;
        ASSERT_FALSE(run_track(options).failure);
    }
    const std::string table = testing_support::text_of(folder / "a.csv");
    EXPECT_EQ(table, testing_support::text_of(folder / "b.csv"));
    EXPECT_EQ(testing_support::rows_of_csv(folder / "a.csv").size(), 45U);
    std::filesystem::remove_all(folder);
}

// The moving target and a piece of the seabed: the one's rows are those of a run without the other,
// and the head looks at the one asked for.
TEST(SimulatedJob, FollowsTwoTargetsAndSteersToTheSecond) {
    const auto folder = testing_support::fresh_folder("two_targets");
    TrackOptions options;
    options.sources.left = "sim:default?seed=7&frames=45";
    options.templates = {"auto"};
    options.csv = folder / "one.csv";
    ASSERT_FALSE(run_track(options).failure);
    options.templates = {"auto", "100,350,31,31"};
    options.steer = 2;
    options.csv = folder / "two.csv";
    const Outcome outcome = run_track(options);
    ASSERT_FALSE(outcome.failure) << outcome.failure->text();
    const auto report = nlohmann::json::parse(outcome.json);
    EXPECT_EQ(report["steered_target"], 2);
    ASSERT_EQ(report["targets"].size(), 2U);
    EXPECT_EQ(report["targets"][0]["tracked_frames"], 45);
    EXPECT_GE(report["targets"][1]["tracked_frames"], 43);
    EXPECT_EQ(report["tracked_frames"], report["targets"][1]["tracked_frames"]);
    const auto alone = testing_support::rows_of_csv(folder / "one.csv");
    const auto both = testing_support::rows_of_csv(folder / "two.csv");
    ASSERT_EQ(both.size(), 2 * alone.size());
    const std::size_t pan_column = 14;
    for (std::size_t i = 0; i < alone.size(); ++i) {
        const auto& first = both[2 * i];
        EXPECT_EQ(first.back(), "1");
        EXPECT_EQ(both[2 * i + 1].back(), "2");
        EXPECT_TRUE(std::equal(first.begin(), first.begin() + pan_column, alone[i].begin()));
    }
    EXPECT_GT(std::stod(alone.back()[pan_column]), 0.0);  // the one is to the right,
    EXPECT_LT(std::stod(both.back()[pan_column]), 0.0);   // the other to the left
    std::filesystem::remove_all(folder);
}

// A knock turns the right camera by 0.05 degrees, 10 s on.
TEST(SimulatedJob, TellsOfAKnockWithinSecondsAndOfNoneWithoutOne) {
    for (const char* knock : {"", "&knock=10&knock_deg=0.05", "&knock=10&knock_deg=-0.05"}) {
        TrackOptions options;
        options.sources.left = "sim:default?seed=3" + std::string(knock);
        options.templates = {"auto"};
        options.seconds = 20.0;
        const Outcome outcome = run_track(options);
        ASSERT_FALSE(outcome.failure) << outcome.failure->text();
        const auto watch = nlohmann::json::parse(outcome.json)["rig_watch"];
        std::printf("%s: %s\n", knock, watch.dump().c_str());
        const bool knocked = knock[0] != '\0';
        ASSERT_EQ(watch["moved"].get<bool>(), knocked);
        if (knocked) {
            EXPECT_GT(watch["moved_frame"].get<int>(), 300);
            EXPECT_LT(watch["moved_frame"].get<int>(), 300 + 4 * 30);
            const double down_deg =
                std::string(knock).find('-') == std::string::npos ? -0.05 : 0.05;
            EXPECT_NEAR(watch["turn_deg"].get<double>(), down_deg, 0.015);
            EXPECT_NE(outcome.summary.find("Check the cameras' mounts"), std::string::npos);
        }
    }
}

TEST(SimulatedJob, MeasuresByTheMethodsOf1999OrSaysWhyNot) {
    for (const char* method : {"reprojection", "sine", "midpoint"}) {
        TrackOptions options;
        options.sources.left = "sim:default?seed=3";
        options.templates = {"auto"};
        options.seconds = 4.0;
        options.position_method = method;
        const Outcome outcome = run_track(options);
        ASSERT_FALSE(outcome.failure) << outcome.failure->text();
        const auto report = nlohmann::json::parse(outcome.json);
        EXPECT_EQ(report["position_method"], method);
        EXPECT_GE(report["tracked_fraction"].get<double>(), 0.99);
        EXPECT_LE(report["truth"]["range_error_mean_pct"].get<double>(), 0.3) << method;
    }
    TrackOptions options;
    options.sources.left = "sim:default?seed=3";
    options.templates = {"auto"};
    options.position_method = "parallel";
    const Outcome outcome = run_track(options);
    ASSERT_TRUE(outcome.failure);
    EXPECT_NE(outcome.failure->cause.find("parallel cameras"), std::string::npos);
}

TEST(SimulatedJob, RefusesToSteerToATargetThatThereIsNot) {
    TrackOptions options;
    options.sources.left = "sim:default?frames=3";
    options.templates = {"auto", "auto"};
    for (const int steer : {0, 3}) {
        options.steer = steer;
        const Outcome outcome = run_track(options);
        ASSERT_TRUE(outcome.failure);
        EXPECT_NE(outcome.failure->cause.find("to steer to"), std::string::npos);
    }
    options.steer = 1;
    options.templates.assign(17, "auto");
    ASSERT_TRUE(run_track(options).failure);
}

TEST(SimulatedJob, BeginsAtALaterFrameAndKeepsItsNumber) {
    const auto folder = testing_support::fresh_folder("later_frame");
    const SimulatedWorld world(*simulated_profile("default"));
    TrackOptions options;
    options.sources.left = "sim:default?frames=30";
    options.sources.start = 20;
    options.templates = {to_string(world.suggested_template(31, 20))};
    options.csv = folder / "t.csv";
    ASSERT_FALSE(run_track(options).failure);
    const auto rows = testing_support::rows_of_csv(folder / "t.csv");
    ASSERT_EQ(rows.size(), 10U);
    EXPECT_EQ(rows.front().front(), "20");
    EXPECT_EQ(rows.back().front(), "29");
    std::filesystem::remove_all(folder);
}

// The cameras that the pictures were drawn with are found again from pictures of a chessboard,
// through the same door as everything else.
TEST(SimulatedJob, CalibratesItselfFromCapturedViews) {
    SteadyClock clock;
    SourceOptions source;
    source.left = "sim:chessboard?rate=1&particles=0";
    auto sources = open_sources(source, clock);
    ASSERT_TRUE(sources);
    const Rig truth = sources->parts.rig;
    VisionSystemOptions options;
    options.every_frame = true;
    options.start_paused = true;
    auto opened = open_vision_system(std::move(sources->parts), options, clock);
    ASSERT_TRUE(opened);
    VsystemInterface& system = **opened;
    for (int view = 0; view < 12; ++view) {
        ASSERT_TRUE(system.execute(CaptureView{}));
        ASSERT_TRUE(system.execute(Flow{Flow::Kind::step}));
        while (system.latest()->frame <= view) {
            std::this_thread::yield();
        }
    }
    const auto reply = system.execute(Calibrate{"chessboard:9x6:30"});
    ASSERT_TRUE(reply) << reply.error().text();
    const auto& outcome = std::get<CalibrationOutcome>(*reply);
    EXPECT_NE(outcome.verdict, "refused");
    EXPECT_GE(outcome.views_used, 8);
    EXPECT_NEAR(outcome.baseline_mm, 450.0, 1.0);
    EXPECT_TRUE(rig_from_text(outcome.rig_text));
    EXPECT_NEAR(baseline_mm(system.rig()), outcome.baseline_mm, 1e-6);  // it is in use
    const auto found = pinhole_parameters(system.rig().left.lens);
    const auto drawn = pinhole_parameters(truth.left.lens);
    EXPECT_NEAR(found.fx_px, drawn.fx_px, 0.01 * drawn.fx_px);
    EXPECT_NEAR(found.cx_px, drawn.cx_px, 3.0);
}

}  // namespace
}  // namespace kambara::cli
