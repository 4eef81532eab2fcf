// SPDX-License-Identifier: GPL-3.0-or-later
// A head's model from rendered pictures of the target by three cameras, through the command.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "app/cli/calibrate_head_command.h"
#include "core/base/text_file.h"
#include "core/camera/nominal_rig.h"
#include "core/camera/rig_file.h"
#include "core/pointing/aim.h"
#include "core/pointing/head_calibration.h"
#include "hardware/media/picture_file.h"
#include "tests/support/box_scene.h"
#include "tests/support/process.h"
#include "tests/support/rig_covariance.h"

namespace kambara::cli {
namespace {

namespace fs = std::filesystem;
using testing_support::BoxScene;

// The camera's centre 50 mm off the tilt axis, that 10 mm ahead of the pan axis.
Rig rig_with_head() {
    HeadModel head;
    head.T_base_from_rig = nominal_rig().pan_tilt->T_camera_from_rig;
    head.T_base_from_rig.t_mm += Eigen::Vector3d(0.0, -5.0, 55.0);
    head.tilt_axis_ahead_mm = 10.0;
    head.T_camera_from_tilt = {rotation_about_x(-0.015), {1.0, 15.0, -47.7}};
    head.pan_backlash_rad = rad_from_deg(0.3);
    head.tilt_backlash_rad = rad_from_deg(0.2);
    return with_head_model(nominal_rig(), head);
}

void draw(const fs::path& file, const Camera& camera, const RigidTransform& T_camera_from_rig,
          const RigidTransform& T_rig_from_target, std::uint32_t seed) {
    BoxScene scene;
    scene.camera_from_target = T_camera_from_rig * T_rig_from_target;
    scene.lens = camera.lens;
    scene.width_px = camera.width_px;
    scene.height_px = camera.height_px;
    scene.seed = seed;
    ASSERT_TRUE(write_picture(file, testing_support::rendered(scene)));
}

TEST(CalibrateHeadSlow, PicturesTellTheAxes) {
    const auto folder = testing_support::fresh_folder("calibrate_head");
    const Rig truth = rig_with_head();
    Rig without = truth;
    without.head.reset();
    without.parameter_covariance = testing_support::some_covariance(without);
    ASSERT_TRUE(write_rig_file(folder / "rig.yaml", without));
    std::string table = "left,right,pan_tilt,pan_deg,tilt_deg,pan_from,tilt_from\n";
    int number = 0;
    for (const double pan_deg : {-24.0, -12.0, 0.0, 12.0, 24.0}) {
        for (const double tilt_deg : {-6.0, 4.0, 14.0}) {
            const HeadApproach from{number % 2 == 0 ? 1 : -1, number % 4 < 2 ? 1 : -1};
            const HeadAngles encoder{rad_from_deg(pan_deg), rad_from_deg(tilt_deg)};
            const RigidTransform T_head =
                T_camera_from_rig(*truth.head, axes_at(*truth.head, encoder, from));
            // Held where the head looks, facing the rig.
            const Eigen::Vector3d at = T_head.inverse() * Eigen::Vector3d(0, 0, 950);
            const RigidTransform T_rig_from_target =
                testing_support::target_pose(two_plane_24(), at, 0.1 * (number % 3 - 1), 0.0, 0.0);
            const std::string name = std::to_string(number);
            const auto seed = static_cast<std::uint32_t>(3 * number);
            draw(folder / ("l" + name + ".png"), truth.left, truth.left.T_camera_from_rig,
                 T_rig_from_target, seed);
            draw(folder / ("r" + name + ".png"), *truth.right, truth.right->T_camera_from_rig,
                 T_rig_from_target, seed + 1);
            draw(folder / ("h" + name + ".png"), *truth.pan_tilt, T_head, T_rig_from_target,
                 seed + 2);
            table += "l" + name + ".png,r" + name + ".png,h" + name + ".png," +
                     std::to_string(pan_deg) + "," + std::to_string(tilt_deg) + "," +
                     (from.pan > 0 ? "below," : "above,") + (from.tilt > 0 ? "below" : "above") +
                     "\n";
            ++number;
        }
    }
    ASSERT_TRUE(write_text_file_atomically(folder / "views.csv", table));
    CalibrateHeadOptions options;
    options.rig = folder / "rig.yaml";
    options.views = (folder / "views.csv").string();
    options.out = folder / "with_head.yaml";
    const Outcome outcome = run_calibrate_head(options);
    ASSERT_FALSE(outcome.failure) << outcome.failure->text();
    std::printf("%s", outcome.summary.c_str());
    const auto json = nlohmann::json::parse(outcome.json);
    EXPECT_EQ(json["rig"], "prior");
    EXPECT_LT(json["pair_rms_px"].get<double>(), 0.5);
    EXPECT_LT(json["rig_most_moved_sigmas"].get<double>(), 3.5);
    EXPECT_GE(json["views_used"].get<int>(), 10);
    EXPECT_NEAR(json["pan_backlash_deg"].get<double>(), 0.3, 0.03);
    EXPECT_NEAR(json["tilt_backlash_deg"].get<double>(), 0.2, 0.03);
    const auto found = read_rig_file(options.out);
    ASSERT_TRUE(found) << found.error().text();
    double with_deg = 0.0;
    double without_deg = 0.0;
    for (double pan_deg = -30.0; pan_deg <= 30.0; pan_deg += 5.0) {
        for (double tilt_deg = -20.0; tilt_deg <= 20.0; tilt_deg += 5.0) {
            const RigidTransform T =
                T_camera_from_rig(*truth.head, {rad_from_deg(pan_deg), rad_from_deg(tilt_deg)});
            const Eigen::Vector3d point =
                truth.left.T_camera_from_rig * (T.inverse() * Eigen::Vector3d(0, 0, 700));
            const auto off = [&](const Rig& used) {
                return deg_from_rad(aiming_error_rad(truth, angles_towards(used, point), point));
            };
            with_deg = std::max(with_deg, off(*found));
            without_deg = std::max(without_deg, off(without));
        }
    }
    std::printf("at 0.7 m, worst: %.4f degrees with the model, %.3f without\n", with_deg,
                without_deg);
    EXPECT_LT(with_deg, 0.1);
    EXPECT_GT(without_deg, 0.5);
    // The rig as given stays as it was, unless it is asked for.
    EXPECT_EQ(found->left.lens, without.left.lens);
    options.refine_rig = true;
    const Outcome refined = run_calibrate_head(options);
    ASSERT_FALSE(refined.failure) << refined.failure->text();
    EXPECT_EQ(nlohmann::json::parse(refined.json)["rig"], "refined");
    const auto rig = read_rig_file(options.out);
    ASSERT_TRUE(rig) << rig.error().text();
    EXPECT_NE(rig->left.lens, without.left.lens);
    EXPECT_LT(rig->parameter_covariance.value()(0, 0), (*without.parameter_covariance)(0, 0));
    ASSERT_TRUE(write_rig_file(options.rig, nominal_rig()));  // which tells no covariance
    EXPECT_TRUE(run_calibrate_head(options).failure);
    fs::remove_all(folder);
}

TEST(CalibrateHead, RefusesWhatIsMissing) {
    const auto folder = testing_support::fresh_folder("calibrate_head_missing");
    Rig rig = nominal_rig();
    ASSERT_TRUE(write_rig_file(folder / "rig.yaml", rig));
    CalibrateHeadOptions options;
    options.rig = folder / "rig.yaml";
    options.views = (folder / "views.csv").string();
    options.out = folder / "out.yaml";
    EXPECT_TRUE(run_calibrate_head(options).failure);
    ASSERT_TRUE(write_text_file_atomically(
        options.views, "left,right,pan_tilt,pan_deg,tilt_deg\na.png,b.png,c.png,0,0\n"));
    const Outcome outcome = run_calibrate_head(options);
    ASSERT_TRUE(outcome.failure);
    EXPECT_NE(outcome.failure->cause.find("line 2"), std::string::npos);
    EXPECT_EQ(nlohmann::json::parse(outcome.json)["views_rejected"].size(), 1U);
    rig.pan_tilt.reset();
    ASSERT_TRUE(write_rig_file(folder / "rig.yaml", rig));
    EXPECT_TRUE(run_calibrate_head(options).failure);
    EXPECT_FALSE(fs::exists(options.out));
    fs::remove_all(folder);
}

}  // namespace
}  // namespace kambara::cli
