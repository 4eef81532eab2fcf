// SPDX-License-Identifier: GPL-3.0-or-later
// Real recordings with known truth. The folder lies beside the project; without it these tests say
// that they were skipped.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/process.h"

namespace kambara {
namespace {

namespace fs = std::filesystem;
using testing_support::rows_of_csv;
using testing_support::run_program;

class RealDataTest : public testing::Test {
  protected:
    void SetUp() override {
        if (!fs::is_directory(data_)) {
            GTEST_SKIP() << "skipped: there is no folder of real recordings at " << data_;
        }
        folder_ = testing_support::fresh_folder(
            testing::UnitTest::GetInstance()->current_test_info()->name());
    }
    void TearDown() override {
        if (!folder_.empty()) {
            fs::remove_all(folder_);
        }
    }

    void run(const std::vector<std::string>& arguments) {
        const auto finished = run_program(KAMBARA_CLI, arguments, folder_);
        ASSERT_EQ(finished.exit_code, 0) << finished.errors;
    }
    std::string data(const std::string& name) const { return (data_ / name).string(); }

    const fs::path data_ = KAMBARA_DATA;
    fs::path folder_;
};

TEST_F(RealDataTest, TheChessboardPairsCalibrateToThePublishedPose) {
    run({"calibrate", "--left", data("stereo_chessboard/left*.jpg"), "--right",
         data("stereo_chessboard/right*.jpg"), "--target", "chessboard:9x6:30", "--out", "rig.yaml",
         "--json", "report.json"});
    const auto report = nlohmann::json::parse(testing_support::text_of(folder_ / "report.json"));
    const auto T = report["pairs"]["left_right"]["T_mm"];
    std::printf("stereo RMS %.4f px over %d of %d corners, T (%.3f, %.3f, %.3f) mm\n",
                report["stereo_rms_px"].get<double>(), report["corners_used"].get<int>(),
                report["corners_total"].get<int>(), T[0].get<double>(), T[1].get<double>(),
                T[2].get<double>());
    EXPECT_LE(report["stereo_rms_px"].get<double>(), 0.20);
    // Squares' sides triangulated in views that took no part in their calibration.
    EXPECT_LE(report["held_out"]["mean_error_mm"].get<double>(), 0.15);
    EXPECT_EQ(report["corners_total"], 14 * 54 * 2);
    EXPECT_GE(report["corners_used"].get<double>(), 0.98 * 14 * 54 * 2);
    EXPECT_NEAR(T[0].get<double>(), -99.80, 0.14);
    EXPECT_NEAR(T[1].get<double>(), 1.12, 0.11);
    EXPECT_NEAR(T[2].get<double>(), -0.05, 0.50);
    EXPECT_EQ(report["verdict"], "good");
}

TEST_F(RealDataTest, TheCharucoPicturesFitAsWellAsPublished) {
    run({"calibrate", "--left", data("charuco/img_*.jpg"), "--target",
         "charuco:5x7:40:20:DICT_6X6_250", "--out", "rig.yaml", "--json", "report.json"});
    const auto report = nlohmann::json::parse(testing_support::text_of(folder_ / "report.json"));
    std::printf("ChArUco RMS %.4f px over %d of %d corners\n", report["rms_px"].get<double>(),
                report["corners_used"].get<int>(), report["corners_total"].get<int>());
    EXPECT_LE(report["rms_px"].get<double>(), 0.182);
    EXPECT_EQ(report["corners_used"], 96);
    // Four views of a small board leave the focal length open, and it says so.
    EXPECT_EQ(report["verdict"], "usable");
}

TEST_F(RealDataTest, TheRenderedTwoPlaneRigIsFound) {
    run({"calibrate", "--left", data("two_plane_rendered/left*.png"), "--right",
         data("two_plane_rendered/right*.png"), "--target", "two-plane-24", "--model", "tsai",
         "--sensor", "0.00635,0.0074,768,640", "--out", "rig.yaml", "--json", "report.json",
         "--report", "report.html"});
    const auto report = nlohmann::json::parse(testing_support::text_of(folder_ / "report.json"));
    const double baseline = report["pairs"]["left_right"]["baseline_mm"].get<double>();
    const double left = report["cameras"]["left"]["f_mm"].get<double>();
    const double right = report["cameras"]["right"]["f_mm"].get<double>();
    std::printf("baseline %.3f mm, f %.5f and %.5f mm, RMS %.3f px\n", baseline, left, right,
                report["rms_px"].get<double>());
    EXPECT_NEAR(baseline, 450.0, 0.45);
    EXPECT_NEAR(left, 2.846366, 0.002 * 2.85);
    EXPECT_NEAR(right, 2.882766, 0.002 * 2.88);
    // Four pictures show one of the planes too much from its side, and say so.
    const std::string rejected = report["views_rejected"].dump();
    for (const char* file : {"right00", "left06", "right07", "right09"}) {
        EXPECT_NE(rejected.find(file), std::string::npos) << file << " in " << rejected;
    }
    EXPECT_NE(rejected.find("too small"), std::string::npos) << rejected;
    EXPECT_NE(testing_support::text_of(folder_ / "report.html").find("Verdict"), std::string::npos);
}

TEST_F(RealDataTest, TheFlatSheetOfSquaresGivesThePublishedFocalLength) {
    run({"calibrate", "--left", data("zhang_squares/CalibIm*.jpg"), "--target",
         std::string(KAMBARA_SOURCE) + "/resources/targets/squares-8x8.yaml", "--out", "rig.yaml",
         "--json", "report.json"});
    const auto report = nlohmann::json::parse(testing_support::text_of(folder_ / "report.json"));
    const double fx = report["cameras"]["left"]["fx_px"].get<double>();
    std::printf("fx %.2f px, RMS %.3f px\n", fx, report["rms_px"].get<double>());
    EXPECT_NEAR(fx, 832.5, 0.003 * 832.5);
}

// Rows of twelve numbers, a 3 x 4 matrix each.
std::vector<Eigen::Matrix<double, 3, 4>> read_poses(const fs::path& file) {
    std::ifstream stream(file);
    std::vector<Eigen::Matrix<double, 3, 4>> poses;
    Eigen::Matrix<double, 4, 3> by_columns;  // read in the order of the file
    for (;;) {
        for (int i = 0; i < 12; ++i) {
            stream >> by_columns.data()[i];
        }
        if (!stream) {
            return poses;
        }
        poses.emplace_back(by_columns.transpose());
    }
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t n = values.size();
    return n % 2 == 1 ? values[n / 2] : 0.5 * (values[n / 2 - 1] + values[n / 2]);
}

TEST_F(RealDataTest, StaticPointsSeenFromAMovingCarKeepTheirPlace) {
    run({"convert", "--from", "kitti", data("drive/calib.txt"), "--out", "rig.yaml"});
    const auto poses = read_poses(data("drive/poses.txt"));
    ASSERT_GE(poses.size(), 12U);
    struct Case {
        int x, y;
        double most_pct;
    };
    for (const Case& point : {Case{791, 99, 3.5}, Case{794, 124, 2.0}, Case{800, 158, 3.0}}) {
        run({"track", "--rig", "rig.yaml", "--left", data("drive/left/%06d.png"), "--right",
             data("drive/right/%06d.png"), "--template",
             std::to_string(point.x - 10) + "," + std::to_string(point.y - 10) + ",21,21", "--csv",
             "track.csv"});
        const auto rows = rows_of_csv(folder_ / "track.csv");
        std::vector<Eigen::Vector3d> in_world;
        std::vector<double> ranges;
        for (std::size_t i = 0; i < rows.size() && !rows[i][8].empty(); ++i) {
            EXPECT_EQ(rows[i][0], std::to_string(i));
            const Eigen::Vector3d in_left_m =
                1e-3 * Eigen::Vector3d(std::stod(rows[i][8]), std::stod(rows[i][9]),
                                       std::stod(rows[i][10]));
            in_world.emplace_back(poses[i].leftCols<3>() * in_left_m + poses[i].col(3));
            ranges.push_back(in_left_m.norm());
        }
        ASSERT_GE(in_world.size(), 12U) << "a gap at " << point.x << "," << point.y;
        Eigen::Vector3d middle;
        for (int k = 0; k < 3; ++k) {
            std::vector<double> values;
            for (std::size_t i = 0; i < 12; ++i) {
                values.push_back(in_world[i][k]);
            }
            middle[k] = median(values);
        }
        double mean_pct = 0.0;
        for (std::size_t i = 0; i < 12; ++i) {
            mean_pct += 100.0 * (in_world[i] - middle).norm() / ranges[i] / 12.0;
        }
        std::printf("(%d, %d): %zu frames without a gap, %.2f %% of range\n", point.x, point.y,
                    in_world.size(), mean_pct);
        EXPECT_LE(mean_pct, point.most_pct);
    }
}

TEST_F(RealDataTest, AMovingTargetIsMeasuredAtAllItsPlaces) {
    // rig.json holds the nominal rig, which the project has as a rig file.
    std::ifstream template_file(data("moving_target/template.txt"));
    std::string rectangle;
    template_file >> rectangle;
    run({"track", "--rig", std::string(KAMBARA_SOURCE) + "/resources/rigs/nominal-air.yaml",
         "--left", data("moving_target/left/%06d.png"), "--right",
         data("moving_target/right/%06d.png"), "--template", rectangle, "--csv", "track.csv"});
    const auto rows = rows_of_csv(folder_ / "track.csv");
    const auto truth = rows_of_csv(data("moving_target/truth.csv"));
    ASSERT_EQ(rows.size(), truth.size());
    double sum_pct = 0.0;
    double worst_pct = 0.0;
    int places = 0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
        if (std::stoi(truth[i][1]) < 0) {
            continue;
        }
        ASSERT_FALSE(rows[i][8].empty()) << "no position in frame " << i << ": " << rows[i].back();
        const auto range = [](const std::vector<std::string>& row, std::size_t first) {
            return Eigen::Vector3d(std::stod(row[first]), std::stod(row[first + 1]),
                                   std::stod(row[first + 2]))
                .norm();
        };
        const double error_pct = 100.0 * std::abs(range(rows[i], 8) / range(truth[i], 2) - 1.0);
        sum_pct += error_pct;
        worst_pct = std::max(worst_pct, error_pct);
        ++places;
    }
    std::printf("%d places: range error mean %.3f %%, worst %.3f %%\n", places, sum_pct / places,
                worst_pct);
    EXPECT_EQ(places, 15);
    EXPECT_LE(sum_pct / places, 0.2);
    EXPECT_LE(worst_pct, 0.6);
}

TEST_F(RealDataTest, AnOpenCvExportOfTheChessboardRigMeasuresTheSame) {
    run({"calibrate", "--left", data("stereo_chessboard/left*.jpg"), "--right",
         data("stereo_chessboard/right*.jpg"), "--target", "chessboard:9x6:30", "--out",
         "rig.yaml"});
    run({"convert", "rig.yaml", "--to", "opencv", "out"});
    run({"convert", "--from", "opencv", "out/intrinsics.yml", "out/extrinsics.yml", "--out",
         "back.yaml"});
    std::ofstream(folder_ / "points.txt") << "320 240 250 250\n";
    run({"triangulate", "--rig", "rig.yaml", "--points", "points.txt", "--json", "a.json"});
    run({"triangulate", "--rig", "back.yaml", "--points", "points.txt", "--json", "b.json"});
    const auto a = nlohmann::json::parse(testing_support::text_of(folder_ / "a.json"));
    const auto b = nlohmann::json::parse(testing_support::text_of(folder_ / "b.json"));
    EXPECT_NEAR(a["points"][0]["z_mm"].get<double>(), b["points"][0]["z_mm"].get<double>(), 1e-6);
}

}  // namespace
}  // namespace kambara
