// SPDX-License-Identifier: GPL-3.0-or-later
// The examples of resources/README.md are read by the code that they are written for.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "app/cli/simulate_command.h"
#include "app/cli/track_table.h"
#include "app/cli/triangulate_command.h"
#include "core/calibration/point_list.h"
#include "core/calibration/record_table.h"
#include "core/calibration/sample_statistics.h"
#include "core/calibration/session/calibration_session.h"
#include "core/calibration/target.h"
#include "core/calibration/target_file.h"
#include "core/camera/nominal_rig.h"
#include "core/camera/rig_file.h"
#include "core/vsystem/serialise.h"
#include "hardware/simulated/simulated_profile.h"
#include "tests/support/process.h"

namespace kambara {
namespace {

namespace fs = std::filesystem;

const fs::path resources = fs::path(KAMBARA_SOURCE) / "resources";

// The fenced block after the comment that names it.
std::string example(const std::string& name) {
    const std::string page = testing_support::text_of(resources / "README.md");
    const auto mark = page.find("<!-- example: " + name + " -->");
    EXPECT_NE(mark, std::string::npos) << name;
    const auto fence = page.find("```", mark);
    const auto begin = page.find('\n', fence) + 1;
    return page.substr(begin, page.find("```", begin) - begin);
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    std::string line;
    while (std::getline(stream, line)) {
        lines.push_back(line);
    }
    EXPECT_FALSE(lines.empty());
    return lines;
}

TEST(DocumentedExamples, TheRigFileIsTheNominalRig) {
    const auto rig = rig_from_text(example("rig"));
    ASSERT_TRUE(rig) << rig.error().text();
    EXPECT_EQ(rig->left.lens, nominal_rig().left.lens);
    EXPECT_NEAR(baseline_mm(*rig), 450.0, 1e-9);
}

TEST(DocumentedExamples, TheRigFilesBesideThePageAreTheNominalRigs) {
    for (const auto& [name, medium] :
         {std::pair{"nominal-air.yaml", Medium::air}, {"nominal-water.yaml", Medium::water}}) {
        const auto rig = read_rig_file(resources / "rigs" / name);
        ASSERT_TRUE(rig) << rig.error().text();
        EXPECT_EQ(rig_to_text(*rig), rig_to_text(nominal_rig(medium)));
    }
}

TEST(DocumentedExamples, TargetsAndProfilesAreUnderstood) {
    for (const std::string& line : lines_of(example("target"))) {
        const auto target = parse_target(line);
        ASSERT_TRUE(target) << line;
        EXPECT_EQ(to_string(*target), line);
    }
    for (const std::string& line : lines_of(example("profile"))) {
        EXPECT_TRUE(simulated_profile(line)) << line;
    }
}

TEST(DocumentedExamples, TargetFilesAreRead) {
    const auto target = target_from_text(example("target file"));
    ASSERT_TRUE(target) << target.error().text();
    EXPECT_EQ(std::get<BoxTarget>(*target).marks.size(), 1U);
    for (const char* name :
         {"target file chessboard", "target file charuco", "target file points"}) {
        EXPECT_TRUE(target_from_text(example(name))) << name;
    }
    int files = 0;
    for (const auto& entry : fs::directory_iterator(resources / "targets")) {
        const auto read = parse_target(entry.path().string());
        EXPECT_TRUE(read) << read.error().text();
        ++files;
    }
    EXPECT_GE(files, 3);
    EXPECT_EQ(*parse_target((resources / "targets/two-plane-24.yaml").string()),
              Target(two_plane_24()));
}

TEST(DocumentedExamples, ACalibrationSessionIsResumed) {
    const fs::path folder = fs::path(testing::TempDir()) / "documented_session";
    fs::remove_all(folder);
    fs::create_directories(folder / "shots");
    std::ofstream(folder / "session.yaml") << example("calibration session");
    std::ofstream(folder / "state.yaml") << example("calibration session state");
    std::ofstream(folder / "shots/0001.yaml") << example("calibration session shot");
    std::ofstream(folder / "target.yaml") << example("target file");
    const auto session = CalibrationSession::resume(folder, {});
    fs::remove_all(folder);
    ASSERT_TRUE(session) << session.error().text();
    EXPECT_EQ(session->setup().baseline->baseline_mm, 450.0);
    EXPECT_EQ(session->setup().cameras[1], (PictureSize{640, 480}));
    ASSERT_EQ(session->shots().size(), 1U);
    EXPECT_FALSE(session->shots()[0].kept);
    EXPECT_EQ(session->shots()[0].seen.sights[0].corners.size(), 2U);
}

TEST(DocumentedExamples, TheTrackTableHasTheHeaderThatIsWritten) {
    const auto lines = lines_of(example("track"));
    EXPECT_EQ(lines.front() + "\n", cli::track_table_header());
    EXPECT_EQ(lines_of(example("targets")).front() + "\n", cli::targets_table_header());
    const std::string row = cli::track_table_row(Snapshot{});
    for (const std::string& line : {lines[1], row}) {
        EXPECT_EQ(std::count(line.begin(), line.end(), ','), 19) << line;
    }
}

TEST(DocumentedExamples, ALensOfBrownIsRead) {
    // In the place of the left lens of the whole example.
    std::string text = example("rig");
    const auto from = text.find("    lens:");
    const auto to = text.find("    T_camera_from_rig:");
    std::string lens;
    for (const std::string& line : lines_of(example("brown"))) {
        lens += "    " + line + "\n";
    }
    text.replace(from, to - from, lens);
    const auto rig = rig_from_text(text);
    ASSERT_TRUE(rig) << rig.error().text();
    EXPECT_EQ(std::get<BrownLens>(rig->left.lens).fx_px(), 533.6);
}

TEST(DocumentedExamples, TheTruthTableIsWhatARecordingHolds) {
    const fs::path folder = testing_support::fresh_folder("documented_truth");
    const auto outcome = cli::run_simulate({"default", 0.1, folder});
    ASSERT_FALSE(outcome.failure) << outcome.failure->text();
    const auto written = lines_of(testing_support::text_of(folder / "truth.csv"));
    const auto documented = lines_of(example("truth"));
    for (std::size_t i = 0; i < documented.size(); ++i) {
        EXPECT_EQ(written.at(i), documented[i]);
    }
    fs::remove_all(folder);
}

TEST(DocumentedExamples, PointsAreRead) {
    const fs::path folder = testing_support::fresh_folder("documented_points");
    std::ofstream(folder / "points.txt") << example("points");
    const auto outcome =
        cli::run_triangulate({resources / "rigs/nominal-air.yaml", folder / "points.txt"});
    EXPECT_FALSE(outcome.failure) << outcome.failure->text();
    EXPECT_EQ(outcome.summary.find("no position"), std::string::npos) << outcome.summary;
    fs::remove_all(folder);
}

TEST(DocumentedExamples, LinkMessagesAreRead) {
    const auto commands = lines_of(example("commands"));
    EXPECT_EQ(commands.size(), std::variant_size_v<Command>);
    for (const std::string& line : commands) {
        const auto command = command_from_json(line);
        EXPECT_TRUE(command) << line;
    }
    const auto snapshot = snapshot_from_json(example("snapshot"));
    ASSERT_TRUE(snapshot) << snapshot.error().text();
    ASSERT_TRUE(steered_track(*snapshot));
    EXPECT_EQ(snapshot->tracks.at(0).estimate.state, TrackState::tracking);
    EXPECT_TRUE(event_from_json(example("events")));
}

TEST(DocumentedExamples, PointsOfKnownPlaceAreRead) {
    const auto list = point_list_from_text(example("seen-points"));
    ASSERT_TRUE(list) << list.error().text();
    EXPECT_EQ(list->left.size(), 2U);
    EXPECT_EQ(list->right.at(1).seen_px, Eigen::Vector2d(102.25, 119.0));
}

TEST(DocumentedExamples, CalibrationRecordsAreReadAndCompared) {
    const auto table = record_table_from_text(example("records"));
    ASSERT_TRUE(table) << table.error().text();
    ASSERT_EQ(table->groups.size(), 2U);
    EXPECT_EQ(table->groups[0].rows.size(), 3U);
    EXPECT_EQ(water_comparisons(*table, 1.333).size(), 1U);

    const auto extrinsic = record_table_from_text(example("extrinsic-records"));
    ASSERT_TRUE(extrinsic) << extrinsic.error().text();
    const auto baselines = baselines_of(*extrinsic, extrinsic->groups.at(0));
    ASSERT_EQ(baselines.size(), 2U);
    for (const BaselineRecord& record : baselines) {
        EXPECT_NEAR(record.baseline_mm.value_or(0.0), 450.0, 1e-9);
    }
    // Where the rotations differ, the printed form is no baseline.
    EXPECT_NEAR(baselines[0].norm_t0_minus_t2_mm, 450.0, 1e-9);
    EXPECT_GT(baselines[1].norm_t0_minus_t2_mm, 550.0);
    EXPECT_NEAR(baselines[1].turn_between_deg.value_or(0.0), 90.0, 1e-9);
}

}  // namespace
}  // namespace kambara
