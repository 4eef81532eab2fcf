// SPDX-License-Identifier: GPL-3.0-or-later
// Tsai's calibration from lists of points as a user runs it: on made lists, and on real and
// classic ones where they are at hand.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "app/cli/calibrate_points_command.h"
#include "core/calibration/point_list.h"
#include "core/calibration/target.h"
#include "core/camera/nominal_rig.h"
#include "core/camera/rig_file.h"
#include "core/stereo/position.h"
#include "tests/support/process.h"

namespace kambara {
namespace {

namespace fs = std::filesystem;
using cli::CalibratePointsOptions;
using cli::run_calibrate_points;
using nlohmann::json;
using testing_support::text_of;

class CalibratePointsTest : public testing::Test {
  protected:
    void SetUp() override {
        folder_ = testing_support::fresh_folder(
            testing::UnitTest::GetInstance()->current_test_info()->name());
    }
    void TearDown() override { fs::remove_all(folder_); }

    CalibratePointsOptions options_for(const std::string& points) const {
        std::ofstream(folder_ / "points.txt") << points;
        CalibratePointsOptions options;
        options.points = folder_ / "points.txt";
        options.sensor = "0.00635,0.0074,768,640";
        options.center = "319.5,239.5";
        options.out = folder_ / "rig.yaml";
        return options;
    }

    // The 24-box target a metre before the nominal rig, as each camera sees it.
    static std::vector<std::string> target_lines(bool two_cameras) {
        const Rig rig = nominal_rig();
        const RigidTransform T_rig_from_target{rotation_about_y(-0.8), {0, -150, 1050}};
        std::vector<std::string> lines;
        for (const Eigen::Vector3d& corner : corners_in_target_mm(two_plane_24())) {
            const Eigen::Vector3d in_rig = T_rig_from_target * corner;
            std::ostringstream line;
            line.precision(12);
            const auto left = rig.left.project(in_rig);
            line << corner.x() << ' ' << corner.y() << ' ' << corner.z() << ' ' << left->x() << ' '
                 << left->y();
            if (two_cameras) {
                const auto right = rig.right->project(in_rig);
                line << ' ' << right->x() << ' ' << right->y();
            }
            lines.push_back(line.str());
        }
        return lines;
    }

    static std::string text_from(const std::vector<std::string>& lines) {
        std::string text;
        for (const std::string& line : lines) {
            text += line + "\n";
        }
        return text;
    }

    fs::path folder_;
};

TEST_F(CalibratePointsTest, OneCamerasListGivesItsCameraAndARigFile) {
    const auto outcome = run_calibrate_points(options_for(text_from(target_lines(false))));
    ASSERT_FALSE(outcome.failure) << outcome.failure->text();
    const json result = json::parse(outcome.json);
    const json& camera = result["camera"];
    EXPECT_NEAR(camera["f_mm"].get<double>(), 2.846366, 1e-8);
    EXPECT_NEAR(camera["kappa1_per_mm2"].get<double>(), 0.037709, 1e-9);
    EXPECT_NEAR(camera["cx_px"].get<double>(), 337.80, 1e-6);
    EXPECT_NEAR(camera["sx"].get<double>(), 1.030092, 1e-9);
    EXPECT_LE(camera["sse_px2"].get<double>(), 1e-12);
    EXPECT_LE(camera["mean_error_px"].get<double>(), 1e-7);
    EXPECT_EQ(camera["R"].size(), 3U);
    EXPECT_EQ(camera["T_mm"].size(), 3U);
    EXPECT_TRUE(camera.contains("sigma"));
    EXPECT_TRUE(result["outliers"].empty());
    EXPECT_TRUE(result["accepted"]);
    const auto rig = read_rig_file(folder_ / "rig.yaml");
    ASSERT_TRUE(rig) << rig.error().text();
    EXPECT_FALSE(rig->right);
    EXPECT_EQ(rig->left.width_px, 640);
    EXPECT_EQ(rig->left.height_px, 480);
}

TEST_F(CalibratePointsTest, TwoCamerasListGivesTheRig) {
    auto lines = target_lines(true);
    lines.insert(lines.begin(), "# x y z XL YL XR YR");
    lines[40] += "5";                                   // a right row, wrong by a digit more
    lines[60].replace(0, lines[60].find(' '), "-999");  // a wrong place: both cameras'
    const auto outcome = run_calibrate_points(options_for(text_from(lines)));
    ASSERT_FALSE(outcome.failure) << outcome.failure->text();
    const json result = json::parse(outcome.json);
    EXPECT_NEAR(result["pairs"]["left_right"]["baseline_mm"].get<double>(), 450.0, 1e-5);
    EXPECT_TRUE(result["cameras"]["right"]["outliers"].is_array());
    const auto outliers = result["outliers"].get<std::vector<int>>();
    EXPECT_EQ(std::set<int>(outliers.begin(), outliers.end()).count(61), 1U);
    const auto rig = read_rig_file(folder_ / "rig.yaml");
    ASSERT_TRUE(rig) << rig.error().text();
    EXPECT_NEAR(baseline_mm(*rig), 450.0, 1e-5);
}

TEST_F(CalibratePointsTest, WhatIsRefusedSaysWhyAndWritesNoRigFile) {
    const auto lines = target_lines(false);
    const auto cause = [&](CalibratePointsOptions options) {
        const auto outcome = run_calibrate_points(options);
        EXPECT_FALSE(fs::exists(folder_ / "rig.yaml"));
        if (!outcome.failure) {
            return std::string("accepted");
        }
        const json result = json::parse(outcome.json);
        EXPECT_FALSE(result["accepted"]);
        EXPECT_FALSE(result["reasons"].empty());
        EXPECT_FALSE(outcome.failure->remedy.empty());
        return outcome.failure->cause;
    };
    const auto has = [](const std::string& text, const std::string& part) {
        return text.find(part) != std::string::npos;
    };
    EXPECT_TRUE(has(cause(options_for(text_from({lines.begin(), lines.begin() + 6}))), "6 points"));
    EXPECT_TRUE(has(cause(options_for(text_from({lines.begin(), lines.begin() + 8}))), "coplanar"));
    auto twice = lines;
    twice.push_back(lines[3]);
    EXPECT_TRUE(has(cause(options_for(text_from(twice))), "line 4 and line 97"));
    EXPECT_TRUE(has(cause(options_for("1 2 3 nan 5\n")), "Line 1"));
    EXPECT_TRUE(has(cause(options_for("")), "no points"));
    auto options = options_for(text_from(lines));
    options.sensor = "0.00635,0.0074,768";
    EXPECT_TRUE(has(cause(options), "--sensor"));
    options.sensor = "0.00635,-0.0074,768,640";
    EXPECT_TRUE(has(cause(options), "not positive"));
    options = options_for(text_from(lines));
    options.center = "319.5;239.5";
    EXPECT_TRUE(has(cause(options), "--center"));
    options = options_for(text_from(lines));
    options.method = "best";
    EXPECT_TRUE(has(cause(options), "best"));
}

TEST_F(CalibratePointsTest, OnePlaneIsCalibratedWhenThatIsSaid) {
    auto lines = target_lines(false);
    std::erase_if(lines, [](const std::string& line) {
        std::istringstream words(line);
        double x = 0.0;
        double y = 0.0;
        double z = 0.0;
        words >> x >> y >> z;
        return z != 0.0;
    });
    auto options = options_for(text_from(lines));
    options.coplanar = true;
    const auto outcome = run_calibrate_points(options);
    ASSERT_FALSE(outcome.failure) << outcome.failure->text();
    // The nominal s_x is 1.03, so that taking it as 1 leaves an error: told, not hidden.
    EXPECT_EQ(json::parse(outcome.json)["camera"]["sx"], 1.0);
}

class RealPointsTest : public CalibratePointsTest {
  protected:
    void SetUp() override {
        CalibratePointsTest::SetUp();
        if (!fs::is_directory(data_)) {
            GTEST_SKIP() << "skipped: there is no folder of real recordings at " << data_;
        }
    }

    json classic(const std::string& method) const {
        CalibratePointsOptions options;
        options.points = data_ / "tsai_willson" / "ncc_cd.dat";
        options.sensor = "0.023,0.023,576,576";
        options.center = "258,204";
        options.method = method;
        const auto outcome = run_calibrate_points(options);
        EXPECT_FALSE(outcome.failure) << outcome.failure->text();
        return json::parse(outcome.json);
    }

    // The two-plane corner's points, x negated where asked.
    std::vector<std::vector<double>> corner_points(bool negated) const {
        std::vector<std::vector<double>> rows;
        std::ifstream file(data_ / "two_plane_corner" / "points.csv");
        std::string line;
        while (std::getline(file, line)) {
            std::istringstream words(line);
            std::string word;
            std::vector<double> row;
            while (std::getline(words, word, ',')) {
                row.push_back(std::stod(word));
            }
            if (row.size() == 7) {
                row[0] *= negated ? -1.0 : 1.0;
                rows.push_back(row);
            }
        }
        return rows;
    }

    CalibratePointsOptions corner_options(const std::vector<std::vector<double>>& rows) const {
        std::ostringstream text;
        for (const auto& row : rows) {
            for (const double value : row) {
                text << value << ' ';
            }
            text << '\n';
        }
        auto options = options_for(text.str());
        options.sensor = "0.001096,0.001096,3000,3000";
        options.center = "1500,1500";
        return options;
    }

    const fs::path data_ = KAMBARA_DATA;
};

TEST_F(RealPointsTest, TheClassicDataReachItsAuthorsResults) {
    const json basic = classic("basic")["camera"];
    const json full = classic("full")["camera"];
    const double ratio = full["T_mm"][2].get<double>() / full["f_mm"].get<double>();
    std::printf("basic %.5f px^2, full %.6f px^2, Tz/f %.5f, angles %.4f %.4f %.4f deg\n",
                basic["sse_px2"].get<double>(), full["sse_px2"].get<double>(), ratio,
                full["angles_deg"][0].get<double>(), full["angles_deg"][1].get<double>(),
                full["angles_deg"][2].get<double>());
    EXPECT_LE(basic["sse_px2"].get<double>(), 3.60);
    EXPECT_LE(full["sse_px2"].get<double>(), 2.4037);
    EXPECT_NEAR(ratio, 28.578, 1e-4 * 28.578);
    const double his_deg[3] = {29.99368, 1.00195, 2.00537};
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(full["angles_deg"][static_cast<std::size_t>(i)].get<double>(), his_deg[i],
                    0.01);
    }
    EXPECT_EQ(full["points_used"], 300);
}

TEST_F(RealPointsTest, ALeftHandedFileIsRecognised) {
    const auto outcome = run_calibrate_points(corner_options(corner_points(false)));
    ASSERT_TRUE(outcome.failure);
    EXPECT_NE(outcome.failure->cause.find("left-handed"), std::string::npos);
    EXPECT_FALSE(fs::exists(folder_ / "rig.yaml"));
}

// Every second point calibrates, the others are measured, and the other way about.
TEST_F(RealPointsTest, HalfTheCornersPointsMeasureTheOtherHalf) {
    const auto rows = corner_points(true);
    ASSERT_EQ(rows.size(), 26U);
    for (const std::size_t first : {0U, 1U}) {
        std::vector<std::vector<double>> half;
        for (std::size_t i = first; i < rows.size(); i += 2) {
            half.push_back(rows[i]);
        }
        const auto outcome = run_calibrate_points(corner_options(half));
        ASSERT_FALSE(outcome.failure) << outcome.failure->text();
        const json left = json::parse(outcome.json)["cameras"]["left"];
        RigidTransform T_left_from_world;
        for (int i = 0; i < 3; ++i) {
            const auto at = static_cast<std::size_t>(i);
            T_left_from_world.t_mm[i] = left["T_mm"][at].get<double>();
            for (int k = 0; k < 3; ++k) {
                T_left_from_world.R(i, k) =
                    left["R"][at][static_cast<std::size_t>(k)].get<double>();
            }
        }
        const auto rig = read_rig_file(folder_ / "rig.yaml");
        ASSERT_TRUE(rig) << rig.error().text();
        double sum = 0.0;
        double worst = 0.0;
        for (std::size_t i = 1 - first; i < rows.size(); i += 2) {
            const auto& row = rows[i];
            const auto position =
                position_from_pair(*rig, PixelMeasurement{{row[3], row[4]}},
                                   PixelMeasurement{{row[5], row[6]}}, {3.5e-4, 50.0});
            ASSERT_TRUE(position) << position.error().text();
            const double range =
                (T_left_from_world * Eigen::Vector3d(row[0], row[1], row[2])).norm();
            const double error =
                100.0 * std::abs(position->point_in_left_mm.norm() - range) / range;
            sum += error;
            worst = std::max(worst, error);
        }
        std::printf("half %zu: range error mean %.3f %%, worst %.3f %%\n", first + 1, sum / 13.0,
                    worst);
        EXPECT_LE(sum / 13.0, 0.66);
        EXPECT_LE(worst, 1.98);
    }
}

}  // namespace
}  // namespace kambara
