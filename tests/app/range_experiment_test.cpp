// SPDX-License-Identifier: GPL-3.0-or-later
// The range experiment of 1999 on the simulated rig, through the command.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "app/cli/range_test_command.h"
#include "core/base/text_file.h"
#include "core/calibration/rig_calibrator.h"
#include "core/camera/nominal_rig.h"
#include "core/camera/rig_file.h"
#include "tests/core/calibration/rig_samples.h"
#include "tests/support/detected_views.h"
#include "tests/support/process.h"

namespace kambara::cli {
namespace {

namespace fs = std::filesystem;

RangeTestOptions stations_into(const fs::path& folder, const std::string& profile) {
    RangeTestOptions options;
    options.left = "sim:" + profile;
    options.track = (folder / "track.csv").string();
    options.csv = folder / "stations.csv";
    options.report = folder / "stations.html";
    return options;
}

nlohmann::json result_of(const RangeTestOptions& options) {
    const Outcome outcome = run_range_test(options);
    EXPECT_FALSE(outcome.failure) << outcome.failure->text();
    std::printf("%s", outcome.summary.c_str());
    return nlohmann::json::parse(outcome.json);
}

// A rig calibrated from rendered pictures of the target, whose corners the detector found, no tape;
// then seventy-five places with the tracker in the loop, in rendered pictures.
void measure_with_own_rig(std::uint32_t seed) {
    const auto folder = testing_support::fresh_folder("range_own_rig");
    const Rig truth = nominal_rig();
    const auto views = testing_support::detected_views(
        testing_support::shown_targets(truth, 30, seed), two_plane_24());
    auto calibrator = testing_support::options_for(truth);
    calibrator.held_out = false;
    const auto report = calibrate_rig(views, two_plane_24(), calibrator);
    ASSERT_EQ(report.verdict, Verdict::good);
    ASSERT_TRUE(write_rig_file(folder / "rig.yaml", report.rig));
    auto options = stations_into(folder, "stations?seed=" + std::to_string(seed));
    options.rig = folder / "rig.yaml";
    const auto result = result_of(options);
    EXPECT_EQ(result["stations"], 75);
    for (const char* when : {"before", "after"}) {
        EXPECT_LE(result[when]["mean_range_error_pct"].get<double>(), 0.15);
        EXPECT_LE(result[when]["worst_range_error_pct"].get<double>(), 0.5);
        EXPECT_LE(result[when]["mean_depth_error_pct"].get<double>(), 0.15);
        EXPECT_LE(result[when]["worst_depth_error_pct"].get<double>(), 0.5);
    }
    EXPECT_EQ(testing_support::rows_of_csv(*options.csv).size(), 75U);
    const std::string page = testing_support::text_of(*options.report);
    for (const char* chart : {"against depth", "against height", "against side", "All levels"}) {
        EXPECT_NE(page.find(chart), std::string::npos) << chart;
    }
    fs::remove_all(folder);
}

TEST(RangeTestSlow, SeventyFivePlacesWithARigOfOurOwn) {
    for (std::uint32_t seed = 100; seed < 103; ++seed) {
        measure_with_own_rig(seed);
    }
}

// A rig whose baseline is told 3 % too long measures 3 % too far, and the correction mends it.
TEST(RangeTestSlow, AWrongBaselineIsCorrected) {
    const auto folder = testing_support::fresh_folder("range_wrong_baseline");
    Rig rig = nominal_rig();
    rig.right->T_camera_from_rig.t_mm *= 1.03;
    ASSERT_TRUE(write_rig_file(folder / "rig.yaml", rig));
    auto options = stations_into(folder, "stations?rate=15");
    options.rig = folder / "rig.yaml";
    auto result = result_of(options);
    EXPECT_NEAR(result["before"]["mean_range_error_pct"].get<double>(), 3.0, 0.1);
    EXPECT_NEAR(result["corrected_baseline_mm"].get<double>(), 450.0, 0.5);
    EXPECT_LE(result["after"]["mean_range_error_pct"].get<double>(), 0.15);
    options.true_baseline_mm = 450.0;
    result = result_of(options);
    EXPECT_LE(result["after"]["worst_range_error_pct"].get<double>(), 0.5);
    fs::remove_all(folder);
}

// Places given with their pixels, in the rig's frame.
TEST(RangeTest, PlacesWithPixels) {
    const auto folder = testing_support::fresh_folder("range_pixels");
    const Rig rig = nominal_rig();
    ASSERT_TRUE(write_rig_file(folder / "rig.yaml", rig));
    std::string table = "x_mm,y_mm,z_mm,left_x_px,left_y_px,right_x_px,right_y_px\n";
    for (const double z : {1000.0, 1400.0, 1900.0}) {
        const Eigen::Vector3d place(150.0, -80.0, z);
        const auto left = rig.left.project(place);
        const auto right = rig.right->project(place);
        char line[200];
        std::snprintf(line, sizeof line, "%.9g,%.9g,%.9g,%.9f,%.9f,%.9f,%.9f\n", place.x(),
                      place.y(), place.z(), left->x(), left->y(), right->x(), right->y());
        table += line;
    }
    ASSERT_TRUE(write_text_file_atomically(folder / "known.csv", table));
    RangeTestOptions options;
    options.rig = folder / "rig.yaml";
    options.known = (folder / "known.csv").string();
    options.frame = "rig";
    const auto result = result_of(options);
    EXPECT_EQ(result["stations"], 3);
    EXPECT_LT(result["before"]["worst_position_error_mm"].get<double>(), 1e-3);
    options.frame = "left";  // which it is not: 3 degrees
    EXPECT_GT(result_of(options)["before"]["worst_position_error_mm"].get<double>(), 50.0);
    fs::remove_all(folder);
}

TEST(RangeTest, RefusesWhatIsMissing) {
    RangeTestOptions options;
    EXPECT_TRUE(run_range_test(options).wrong_usage);
    options.left = "sim:default";
    EXPECT_TRUE(run_range_test(options).wrong_usage);
    options.track = "t.csv";
    const Outcome outcome = run_range_test(options);
    ASSERT_TRUE(outcome.failure);
    EXPECT_NE(outcome.failure->cause.find("no known places"), std::string::npos);
    options.known = "there-is-no-such-file.csv";
    EXPECT_TRUE(run_range_test(options).failure);
}

}  // namespace
}  // namespace kambara::cli
