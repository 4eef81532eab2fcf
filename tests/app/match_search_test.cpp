// SPDX-License-Identifier: GPL-3.0-or-later
// `match` with every search, and pictures filtered over time, as a user would call them.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <string>
#include <vector>

#include "app/cli/match_command.h"
#include "core/camera/rig_file.h"
#include "core/matching/temporal_filter.h"
#include "hardware/media/picture_file.h"
#include "hardware/simulated/simulated_world.h"
#include "tests/support/process.h"

namespace kambara {
namespace {

namespace fs = std::filesystem;
using testing_support::Finished;
using testing_support::fresh_folder;
using testing_support::run_program;

// The left and right pictures of the simulated rig, and the template at the target's middle.
class MatchSearchTest : public testing::Test {
  protected:
    void SetUp() override {
        folder_ = fresh_folder(testing::UnitTest::GetInstance()->current_test_info()->name());
        const SimulatedWorld world(*simulated_profile("default?seed=3&particles=0"));
        const Image left = world.picture(FixedCamera::left, 0);
        place_ = world.suggested_template(31);
        Image templ(place_.width, place_.height);
        for (int y = 0; y < place_.height; ++y) {
            std::copy_n(left.row(place_.y + y) + place_.x, place_.width, templ.row(y));
        }
        left_px_ = {place_.centre_x_px(), place_.centre_y_px()};
        const auto on_target = world.target_point_under(left_px_, 0);
        const Eigen::Vector3d point_in_rig_mm =
            world.rig().left.T_camera_from_rig.inverse() * world.point_in_left_mm(*on_target, 0);
        right_px_ = *world.rig().right->project(point_in_rig_mm);
        ASSERT_TRUE(write_picture(folder_ / "left.png", left));
        ASSERT_TRUE(write_picture(folder_ / "right.png", world.picture(FixedCamera::right, 0)));
        ASSERT_TRUE(write_picture(folder_ / "templ.png", templ));
        ASSERT_TRUE(write_rig_file(folder_ / "rig.yaml", world.rig()));
    }
    void TearDown() override { fs::remove_all(folder_); }

    Finished match(const std::string& image, std::vector<std::string> more) const {
        more.insert(more.begin(), {"match", image, "templ.png", "--json", "-"});
        return run_program(KAMBARA_CLI, more, folder_);
    }
    static std::string pixel(const Eigen::Vector2d& p) {
        return std::to_string(p.x()) + "," + std::to_string(p.y());
    }

    // Found, with everything that is told about a match.
    static void expect_found(const cli::Outcome& outcome, const Eigen::Vector2d& at_px,
                             double within_px) {
        ASSERT_FALSE(outcome.failure) << outcome.failure->text();
        const auto json = nlohmann::json::parse(outcome.json);
        EXPECT_LT((Eigen::Vector2d(json["x_px"], json["y_px"]) - at_px).norm(), within_px)
            << outcome.json;
        EXPECT_GT(json["quality"], 0.5);
        EXPECT_GE(json["peak_ratio"], 0.0);
        EXPECT_LE(json["peak_ratio"], 1.0);
        EXPECT_TRUE(json.contains("second_score"));
        const auto& c = json["covariance_px2"];
        EXPECT_GT(c[0][0], 0.0);
        EXPECT_EQ(c[0][1], c[1][0]);
        EXPECT_LT(c[1][1], 0.1);
    }

    fs::path folder_;
    Rectangle place_;
    Eigen::Vector2d left_px_;
    Eigen::Vector2d right_px_;
};

TEST_F(MatchSearchTest, EverySearchWithEveryMeasureAndTransformFindsTheTarget) {
    const std::vector<std::pair<std::string, std::string>> methods{
        {"zncc", "none"},     {"sad", "gauss"}, {"ncc", "rank3"},
        {"sad", "rank5"},     {"zncc", "sdog"}, {"hamming", "census"},
        {"zncc", "gradient"}, {"ncc", "none"},  {"hamming", "sdog"}};
    const Eigen::Vector2d expected = left_px_ + Eigen::Vector2d(6, -5);
    for (const auto& [measure, transform] : methods) {
        for (const std::string search :
             {"full", "sparse", "window", "window-sparse", "epipolar", "epipolar-sparse"}) {
            SCOPED_TRACE(search + " " + measure + " " + transform);
            const bool epipolar = search.starts_with("epipolar");
            cli::MatchOptions options;
            options.image = folder_ / (epipolar ? "right.png" : "left.png");
            options.templ = folder_ / "templ.png";
            options.measure = measure;
            options.transform = transform;
            options.search.strategy = search;
            if (search.starts_with("window")) {
                options.search.near_px = pixel(expected);
                options.search.radius_px = 9;
            }
            if (epipolar) {
                options.search.rig = (folder_ / "rig.yaml").string();
                options.search.left_point_px = pixel(left_px_);
                options.search.band_px = 3;
                options.search.nearest_mm = 700.0;
            }
            expect_found(cli::run_match(options), epipolar ? right_px_ : left_px_,
                         epipolar ? 1.5 : 0.05);
        }
    }
}

TEST_F(MatchSearchTest, TheProgramFindsItAlongTheEpipolarCurve) {
    const Finished finished =
        match("right.png", {"--search", "epipolar-sparse", "--step", "3", "--rig", "rig.yaml",
                            "--left-point", pixel(left_px_), "--nearest-mm", "700"});
    ASSERT_EQ(finished.exit_code, 0) << finished.errors;
    const auto json = nlohmann::json::parse(finished.output);
    EXPECT_NEAR(json["x_px"], right_px_.x(), 1.5);
    EXPECT_NEAR(json["y_px"], right_px_.y(), 1.0);
}

TEST_F(MatchSearchTest, TheMapHasAllPositionsAndNotANumberWhereNothingWasSearched) {
    const std::string near = pixel(left_px_);
    ASSERT_EQ(match("left.png", {"--search", "window", "--near", near, "--radius", "4",
                                 "--transform", "rank5", "--map", "window.tiff"})
                  .exit_code,
              0);
    ASSERT_EQ(match("left.png", {"--transform", "rank5", "--map", "full.tiff"}).exit_code, 0);
    const cv::Mat window = cv::imread((folder_ / "window.tiff").string(), cv::IMREAD_UNCHANGED);
    const cv::Mat full = cv::imread((folder_ / "full.tiff").string(), cv::IMREAD_UNCHANGED);
    ASSERT_EQ(window.size(), full.size());
    ASSERT_EQ(full.size(), cv::Size(640 - 30, 480 - 30));
    for (int y = 0; y < full.rows; ++y) {
        for (int x = 0; x < full.cols; ++x) {
            const bool inside = std::abs(x - place_.x) <= 4 && std::abs(y - place_.y) <= 4;
            ASSERT_TRUE(inside ? window.at<float>(y, x) == full.at<float>(y, x)
                               : std::isnan(window.at<float>(y, x)))
                << x << ", " << y;
        }
    }
}

TEST_F(MatchSearchTest, WhatDoesNotGoTogetherIsWrongUsage) {
    const std::vector<std::vector<std::string>> wrong{
        {"--search", "spiral"},
        {"--search", "window"},
        {"--search", "window", "--near", "12"},
        {"--search", "epipolar"},
        {"--search", "epipolar", "--rig", "rig.yaml"},
        {"--search", "epipolar", "--rig", "rig.yaml", "--left-point", "a,b"},
        {"--search", "epipolar", "--rig", "rig.yaml", "--left-point", "320,240", "--nearest-mm",
         "900", "--farthest-mm", "800"},
        {"--radius", "7"},
        {"--step", "3"},
        {"--rig", "rig.yaml"},
        {"--search", "window", "--near", "9,9", "--band", "2"},
        {"--search", "sparse", "--left-point", "9,9"},
        {"--search", "sparse", "--step", "0"},
    };
    for (const auto& options : wrong) {
        const Finished finished = match("left.png", options);
        EXPECT_EQ(finished.exit_code, 2) << finished.errors;
        EXPECT_FALSE(finished.errors.empty());
    }
    // These fail for what the files hold.
    for (const auto& [options, cause] :
         std::vector<std::pair<std::vector<std::string>, std::string>>{
             {{"--search", "window", "--near", "-500,-500"}, "does not fit"},
             {{"--search", "epipolar", "--rig", "no.yaml", "--left-point", "9,9"}, "no.yaml"},
             {{"--search", "epipolar", "--rig", "rig.yaml", "--left-point", "900,9"}, "900,9"},
             {{"--search", "sparse", "--step", "30"}, "smaller --step"}}) {
        const Finished finished = match("left.png", options);
        EXPECT_EQ(finished.exit_code, 1) << finished.errors;
        EXPECT_NE(finished.errors.find(cause), std::string::npos) << finished.errors;
        EXPECT_TRUE(nlohmann::json::parse(finished.output).contains("error"));
    }
}

// A still scene behind dense particles that drift by.
TEST(Temporal, ManyParticlesVanishFromAStillScene) {
    const std::string still = "chessboard?noise=0&seed=4&particles=";
    const SimulatedWorld clear(*simulated_profile(still + "0"));
    const SimulatedWorld dense(*simulated_profile(still + "800"));
    const Image truth = clear.picture(FixedCamera::left, 6);
    const auto differing = [&](const Image& picture) {
        int pixels = 0;
        for (int y = 0; y < truth.height(); ++y) {
            for (int x = 0; x < truth.width(); ++x) {
                pixels += std::abs(picture.at(x, y) - truth.at(x, y)) > 3 ? 1 : 0;
            }
        }
        return pixels;
    };
    for (const char* name : {"median:5", "median:9", "mean:9"}) {
        TemporalFilter filter(*parse_temporal(name));
        Image filtered;
        int raw = 0;
        for (int i = 0; i <= 12; ++i) {
            const Image seen = dense.picture(FixedCamera::left, i);
            filtered = filter.filter(seen);
            raw = differing(seen);
        }
        std::printf("%s: %d pixels disturbed of %d before\n", name, differing(filtered), raw);
        EXPECT_GT(raw, 500);
        EXPECT_LT(differing(filtered), raw) << name;
    }
}

TEST(Temporal, TrackAndCompareTakeItAndRefuseOthers) {
    const auto folder = fresh_folder("temporal_options");
    const auto run = [&](const std::string& temporal) {
        return run_program(KAMBARA_CLI,
                           {"track", "--left", "sim:default?frames=12", "--template", "auto",
                            "--temporal", temporal, "--csv", "t.csv"},
                           folder);
    };
    EXPECT_EQ(run("median:3").exit_code, 0);
    EXPECT_EQ(testing_support::rows_of_csv(folder / "t.csv").size(), 12U);
    const Finished refused = run("median:99");
    EXPECT_EQ(refused.exit_code, 1);
    EXPECT_NE(refused.errors.find("median:99"), std::string::npos);
    const Finished compared =
        run_program(KAMBARA_CLI,
                    {"compare-methods", "--profile", "default?particles=0", "--seconds", "0.1",
                     "--temporal", "mean:2", "--json", "-"},
                    folder);
    ASSERT_EQ(compared.exit_code, 0) << compared.errors;
    EXPECT_EQ(nlohmann::json::parse(compared.output)["temporal"], "mean:2");
    fs::remove_all(folder);
}

}  // namespace
}  // namespace kambara
