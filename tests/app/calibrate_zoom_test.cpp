// SPDX-License-Identifier: GPL-3.0-or-later
// A zoom's curve from rendered pictures, through the command.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/cli/calibrate_zoom_command.h"
#include "core/base/text_file.h"
#include "core/camera/nominal_rig.h"
#include "core/camera/rig_file.h"
#include "core/camera/zoom.h"
#include "hardware/media/picture_file.h"
#include "hardware/visca/head_kind.h"
#include "tests/support/process.h"
#include "tests/support/textured_plane.h"

namespace kambara::cli {
namespace {

namespace fs = std::filesystem;

constexpr double tele_truth = 3.2;

double truth_at(double share) {
    return std::pow(tele_truth, std::pow(share, 1.4));
}

CalibrateZoomOptions options_in(const fs::path& folder) {
    CalibrateZoomOptions options;
    options.rig = folder / "rig.yaml";
    options.views = folder / "zoom.csv";
    options.out = folder / "heads.yaml";
    return options;
}

std::string cause_of(const CalibrateZoomOptions& options) {
    const Outcome outcome = run_calibrate_zoom(options);
    return outcome.failure ? outcome.failure->cause : std::string();
}

TEST(CalibrateZoom, PicturesTellTheCurveAndTheTableKeepsIt) {
    const auto folder = testing_support::fresh_folder("calibrate_zoom");
    const Rig rig = nominal_rig();
    ASSERT_TRUE(write_rig_file(folder / "rig.yaml", rig));
    testing_support::TexturedPlane plane{{0.0, 0.0, 2500.0}};
    plane.size = 0.7;
    std::string table = "pan_tilt,zoom_share\n";
    for (const double share : {0.0, 0.4, 0.7, 1.0}) {
        Camera camera = *rig.pan_tilt;
        camera.lens = zoomed(camera.lens, truth_at(share));
        const std::string name = std::to_string(share) + ".png";
        ASSERT_TRUE(write_picture(folder / name, testing_support::drawn(plane, camera)));
        table += name + "," + std::to_string(share) + "\n";
    }
    ASSERT_TRUE(write_text_file_atomically(folder / "zoom.csv", table));
    const auto options = options_in(folder);
    const Outcome outcome = run_calibrate_zoom(options);
    ASSERT_FALSE(outcome.failure) << outcome.failure->text();
    const auto json = nlohmann::json::parse(outcome.json);
    ASSERT_EQ(json["places"].size(), 4U);
    for (const auto& place : json["places"]) {
        const double truth = truth_at(place["zoom_share"]);
        EXPECT_NEAR(place["magnification"].get<double>() / truth, 1.0, 3e-4);
    }
    // The table's own: 12 times at the end.
    EXPECT_NEAR(json["worst_table_error_pct"].get<double>(), 100.0 * (12.0 / tele_truth - 1.0),
                0.5);
    EXPECT_NE(outcome.summary.find("heads=" + options.out.string()), std::string::npos);

    const auto heads = visca::read_heads_file(options.out);
    ASSERT_TRUE(heads) << heads.error().text();
    EXPECT_EQ(heads->size(), visca::built_in_heads().size());
    const auto kind = visca::find_head(*heads, std::string_view("evi-d30"));
    ASSERT_TRUE(kind);
    const double magnification = std::tan(0.5 * kind->zoom.horizontal_view_rad(0.0)) /
                                 std::tan(0.5 * kind->zoom.horizontal_view_rad(0.7 * 1023.0));
    EXPECT_NEAR(magnification / truth_at(0.7), 1.0, 2e-3);
}

TEST(CalibrateZoom, RefusesWhatItCannotUse) {
    const auto folder = testing_support::fresh_folder("calibrate_zoom_refused");
    Rig rig = nominal_rig();
    ASSERT_TRUE(write_rig_file(folder / "rig.yaml", rig));
    ASSERT_TRUE(
        write_picture(folder / "a.png", Image(rig.pan_tilt->width_px, rig.pan_tilt->height_px, 1)));
    const auto write = [&](const std::string& text) {
        ASSERT_TRUE(write_text_file_atomically(folder / "zoom.csv", text));
    };
    auto options = options_in(folder);
    write("pan_tilt,zoom_share\na.png,0\na.png,1.5\n");
    EXPECT_NE(cause_of(options).find("Line 3"), std::string::npos);
    write("pan_tilt,zoom_share\na.png,0\nb.png,0.5\n");
    EXPECT_NE(cause_of(options).find("b.png"), std::string::npos);
    write("pan_tilt,zoom_share\na.png,0\na.png,0.5\n");
    EXPECT_NE(cause_of(options).find("only 0 points"), std::string::npos);
    options.head = "evi-d31";
    EXPECT_NE(cause_of(options).find("no head \"evi-d31\""), std::string::npos);
    options = options_in(folder);
    options.widest = "5.4";
    EXPECT_TRUE(run_calibrate_zoom(options).wrong_usage);
    options = options_in(folder);
    rig.pan_tilt.reset();
    ASSERT_TRUE(write_rig_file(folder / "rig.yaml", rig));
    EXPECT_NE(cause_of(options).find("no pan-tilt camera"), std::string::npos);
    EXPECT_FALSE(fs::exists(options.out));
}

}  // namespace
}  // namespace kambara::cli
