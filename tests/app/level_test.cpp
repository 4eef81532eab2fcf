// SPDX-License-Identifier: GPL-3.0-or-later
// Levelling by the simulated target that is moved straight up and down, through the command.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/cli/level_command.h"
#include "app/cli/track_command.h"
#include "core/camera/nominal_rig.h"
#include "core/camera/rig_file.h"
#include "tests/support/process.h"

namespace kambara::cli {
namespace {

namespace fs = std::filesystem;

// Between the least and the largest value of a column.
double spread(const std::vector<std::vector<std::string>>& rows, std::size_t column) {
    double least = 1e9;
    double most = -1e9;
    for (const auto& row : rows) {
        least = std::min(least, std::stod(row.at(column)));
        most = std::max(most, std::stod(row.at(column)));
    }
    return most - least;
}

TEST(Level, TheSimulatedRigLooksFifteenDegreesDown) {
    const auto folder = testing_support::fresh_folder("level");
    ASSERT_TRUE(write_rig_file(folder / "rig.yaml", nominal_rig()));
    TrackOptions track;
    track.sources.left = "sim:plumb?rate=15";
    track.sources.rig = (folder / "rig.yaml").string();
    track.templates = {"auto"};
    track.seconds = 8.0;
    track.csv = folder / "track.csv";
    ASSERT_FALSE(run_track(track).failure);
    LevelOptions options;
    options.rig = folder / "rig.yaml";
    options.track = track.csv->string();
    options.out = folder / "mounted.yaml";
    options.rig_in_vehicle = "400,-225,100";
    const Outcome outcome = run_level(options);
    ASSERT_FALSE(outcome.failure) << outcome.failure->text();
    std::printf("%s", outcome.summary.c_str());
    const auto json = nlohmann::json::parse(outcome.json);
    EXPECT_NEAR(json["pitch_deg"].get<double>(), 15.0, 0.1);
    EXPECT_NEAR(json["roll_deg"].get<double>(), 0.0, 0.1);
    EXPECT_LT(json["pitch_sigma_deg"].get<double>(), 0.05);
    EXPECT_NEAR(json["extent_mm"].get<double>(), 600.0, 10.0);
    // In the level frame it goes up and down only; in the vehicle's, z is down.
    const std::size_t x_column = 8;
    track.sources.rig = options.out->string();
    for (const auto& [frame, down] : {std::pair{"level", 1U}, {"vehicle", 2U}}) {
        track.frame = frame;
        const Outcome again = run_track(track);
        ASSERT_FALSE(again.failure) << again.failure->text();
        const auto rows = testing_support::rows_of_csv(*track.csv);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (axis == down) {
                EXPECT_GT(spread(rows, x_column + axis), 590.0) << frame;
            } else {
                EXPECT_LT(spread(rows, x_column + axis), 8.0) << frame << " " << axis;
            }
        }
    }
    fs::remove_all(folder);
}

TEST(Level, RefusesWhatIsMissing) {
    const auto folder = testing_support::fresh_folder("level_missing");
    ASSERT_TRUE(write_rig_file(folder / "rig.yaml", nominal_rig()));
    LevelOptions options;
    options.rig = folder / "rig.yaml";
    EXPECT_TRUE(run_level(options).wrong_usage);
    options.points = (folder / "none.csv").string();
    EXPECT_TRUE(run_level(options).failure);
    options.rig_in_vehicle = "1,2";
    EXPECT_TRUE(run_level(options).wrong_usage);
    TrackOptions track;
    track.sources.left = "sim:plumb?frames=3";
    track.templates = {"auto"};
    track.frame = "vehicle";
    const Outcome outcome = run_track(track);
    ASSERT_TRUE(outcome.failure);
    EXPECT_NE(outcome.failure->cause.find("mounted"), std::string::npos);
    fs::remove_all(folder);
}

}  // namespace
}  // namespace kambara::cli
