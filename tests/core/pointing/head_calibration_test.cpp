// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pointing/head_calibration.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>

#include "core/camera/nominal_rig.h"
#include "core/camera/rig_file.h"
#include "core/pointing/aim.h"

namespace kambara {
namespace {

constexpr double pan_backlash = rad_from_deg(0.4);
constexpr double tilt_backlash = rad_from_deg(0.25);

// A head whose camera's centre is 50 mm from the tilt axis, which is 12 mm ahead of the pan axis;
// axes not quite square, the camera not quite straight on its mount.
Rig rig_with_head() {
    const Rig rig = nominal_rig();
    HeadModel head;
    head.T_base_from_rig = rig.pan_tilt->T_camera_from_rig;
    head.T_base_from_rig.t_mm += Eigen::Vector3d(3.0, -8.0, 55.0);
    head.T_base_from_rig.R = rotation_about_x(0.01) * head.T_base_from_rig.R;
    head.tilt_axis_ahead_mm = 12.0;
    head.tilt_axis_skew_rad = rad_from_deg(0.5);
    head.T_camera_from_tilt = {rotation_about_y(0.012) * rotation_about_x(-0.02),
                               {2.0, 20.0, -45.8}};  // 50 mm off the axis
    head.pan_backlash_rad = pan_backlash;
    head.tilt_backlash_rad = tilt_backlash;
    return with_head_model(rig, head);
}

// A board of points, held where the head at the angles looks, 0.6 to 1.2 m away.
std::vector<HeadView> views_of(const Rig& truth, double noise_px, bool both_sides, unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0.0, noise_px);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    std::vector<HeadView> views;
    for (const double pan_deg : {-30.0, -15.0, 0.0, 15.0, 30.0}) {
        for (const double tilt_deg : {-20.0, 0.0, 20.0}) {
            HeadView view;
            const int count = static_cast<int>(views.size());
            view.encoder = {rad_from_deg(pan_deg), rad_from_deg(tilt_deg)};
            view.approach = both_sides
                                ? HeadApproach{count % 2 == 0 ? 1 : -1, count % 4 < 2 ? 1 : -1}
                                : HeadApproach{1, 1};
            const RigidTransform T =
                T_camera_from_rig(*truth.head, axes_at(*truth.head, view.encoder, view.approach));
            const double range = 900.0 + 300.0 * unit(random);
            for (int i = 0; i < 24; ++i) {
                const Eigen::Vector3d in_camera(0.25 * range * unit(random),
                                                0.18 * range * unit(random),
                                                range + 60.0 * unit(random));
                const auto pixel = kambara::project(truth.pan_tilt->lens, in_camera);
                view.sightings.push_back({T.inverse() * in_camera,
                                          *pixel + Eigen::Vector2d(noise(random), noise(random))});
            }
            views.push_back(view);
        }
    }
    return views;
}

struct Aim {
    double mean_deg = 0.0;
    double worst_deg = 0.0;
};

// How far off the true axis is where a rig says to turn to, over what the head reaches at a
// distance from the left camera.
Aim aim_of(const Rig& used, const Rig& truth, double range_mm) {
    Aim aim;
    int count = 0;
    for (double pan_deg = -40.0; pan_deg <= 40.0; pan_deg += 5.0) {
        for (double tilt_deg = -22.0; tilt_deg <= 22.0; tilt_deg += 4.0) {
            const RigidTransform T =
                T_camera_from_rig(*truth.head, {rad_from_deg(pan_deg), rad_from_deg(tilt_deg)});
            const Eigen::Vector3d point =
                truth.left.T_camera_from_rig * (T.inverse() * Eigen::Vector3d(0, 0, range_mm));
            const double off =
                deg_from_rad(aiming_error_rad(truth, angles_towards(used, point), point));
            aim.mean_deg += off;
            aim.worst_deg = std::max(aim.worst_deg, off);
            ++count;
        }
    }
    aim.mean_deg /= count;
    return aim;
}

TEST(HeadCalibration, AViewsResidualIsAnAngle) {
    const Rig truth = rig_with_head();
    auto views = views_of(truth, 0.0, true, 3);
    EXPECT_NEAR(view_rms_rad(truth, *truth.head, views[0]).value(), 0.0, 1e-7);
    // The camera turned to the side by half a degree sees everything that much off its middle.
    HeadModel turned = *truth.head;
    turned.T_camera_from_tilt.R = rotation_about_y(rad_from_deg(0.5)) * turned.T_camera_from_tilt.R;
    const double off = view_rms_rad(truth, turned, views[7]).value();
    EXPECT_GT(off, rad_from_deg(0.4));
    EXPECT_LT(off, rad_from_deg(0.55));
}

TEST(HeadCalibration, PointsWithinATenthOfADegreeAtArmsLength) {
    const Rig truth = rig_with_head();
    Rig without = truth;
    without.head.reset();
    const Aim cost = aim_of(without, truth, 700.0);
    Aim worst;
    for (unsigned seed = 0; seed < 10; ++seed) {
        const auto result = calibrate_head(without, views_of(truth, 0.1, true, seed));
        ASSERT_TRUE(result) << result.error().text();
        const Aim aim = aim_of(with_head_model(without, result->model), truth, 700.0);
        worst = {std::max(worst.mean_deg, aim.mean_deg), std::max(worst.worst_deg, aim.worst_deg)};
        EXPECT_LT(result->rms_px, 0.2);
        EXPECT_GT(result->rms_without_model_px, 5.0);
    }
    std::printf("at 0.7 m: with the model mean %.4f, worst %.4f degrees; without %.3f, %.3f\n",
                worst.mean_deg, worst.worst_deg, cost.mean_deg, cost.worst_deg);
    EXPECT_LT(worst.worst_deg, 0.1);
    EXPECT_GT(cost.worst_deg, 1.0);
}

TEST(HeadCalibration, MeasuresTheBacklashFromBothSides) {
    const Rig truth = rig_with_head();
    Rig without = truth;
    without.head.reset();
    double off = 0.0;
    double told = 0.0;
    for (unsigned seed = 0; seed < 20; ++seed) {
        const auto result = calibrate_head(without, views_of(truth, 0.1, true, seed));
        ASSERT_TRUE(result);
        EXPECT_TRUE(result->pan_backlash_seen && result->tilt_backlash_seen);
        EXPECT_NEAR(deg_from_rad(result->model.pan_backlash_rad), 0.4, 0.02);
        EXPECT_NEAR(deg_from_rad(result->model.tilt_backlash_rad), 0.25, 0.02);
        off += std::pow(result->model.pan_backlash_rad - pan_backlash, 2) / 20;
        told += result->pan_backlash_sigma_rad / 20;
    }
    EXPECT_NEAR(told / std::sqrt(off), 1.0, 0.5);
    const auto one_side = calibrate_head(without, views_of(truth, 0.1, false, 1));
    ASSERT_TRUE(one_side);
    EXPECT_FALSE(one_side->pan_backlash_seen);
    EXPECT_EQ(one_side->model.pan_backlash_rad, 0.0);
}

// What the fixed cameras make of the board's place is off by the same for all points of a view.
TEST(HeadCalibration, ItsDeviationsHoldWherePlacesErrTogether) {
    const Rig truth = rig_with_head();
    Rig without = truth;
    without.head.reset();
    double squared = 0.0;
    constexpr int cases = 60;
    for (unsigned seed = 0; seed < cases; ++seed) {
        auto views = views_of(truth, 0.05, true, seed);
        std::mt19937 random(seed + 1000);
        std::normal_distribution<double> place_mm(0.0, 1.0);
        for (HeadView& view : views) {
            const Eigen::Vector3d off(place_mm(random), place_mm(random), place_mm(random));
            for (HeadSighting& one : view.sightings) {
                one.point_in_rig_mm += off;
            }
        }
        const auto result = calibrate_head(without, views);
        ASSERT_TRUE(result) << result.error().text();
        const double off_mm = result->model.tilt_axis_ahead_mm - truth.head->tilt_axis_ahead_mm;
        squared += std::pow(off_mm / result->tilt_axis_ahead_sigma_mm, 2) / cases;
    }
    std::printf("squared error by variance: %.2f\n", squared);
    EXPECT_GT(squared, 0.5);
    EXPECT_LT(squared, 1.7);
}

TEST(HeadCalibration, TheAimPutsThePointOnTheAxis) {
    const Rig truth = rig_with_head();
    EXPECT_LT(aim_of(truth, truth, 300.0).worst_deg, 1e-8);
    const HeadAngles angles{0.3, -0.2};
    const Eigen::Vector3d axis = axis_in_left_frame(truth, angles);
    EXPECT_NEAR(axis.norm(), 1.0, 1e-12);
    const Eigen::Vector3d centre_in_left =
        truth.left.T_camera_from_rig * T_camera_from_rig(*truth.head, angles).centre_mm();
    EXPECT_LT(aiming_error_rad(truth, angles, centre_in_left + 900.0 * axis), 1e-7);
}

// A model without arms is the head that turns about the camera's centre.
TEST(HeadCalibration, AModelWithoutArmsIsTheSimpleHead) {
    const Rig simple = nominal_rig();
    HeadModel model;
    model.T_base_from_rig = simple.pan_tilt->T_camera_from_rig;
    const Rig same = with_head_model(simple, model);
    for (const Eigen::Vector3d& point : {Eigen::Vector3d(300, 100, 900), {-200, -50, 1500}}) {
        const HeadAngles a = angles_towards(simple, point);
        const HeadAngles b = angles_towards(same, point);
        EXPECT_NEAR(a.pan_rad, b.pan_rad, 1e-9);
        EXPECT_NEAR(a.tilt_rad, b.tilt_rad, 1e-9);
        EXPECT_NEAR(aiming_error_rad(simple, {0.1, 0.1}, point),
                    aiming_error_rad(same, {0.1, 0.1}, point), 1e-9);
        EXPECT_LT((axis_in_left_frame(simple, a) - axis_in_left_frame(same, a)).norm(), 1e-9);
    }
}

TEST(HeadCalibration, TheRigFileKeepsTheModel) {
    const Rig rig = rig_with_head();
    const auto read = rig_from_text(rig_to_text(rig));
    ASSERT_TRUE(read) << read.error().text();
    ASSERT_TRUE(read->head);
    const HeadAngles angles{0.3, -0.2};
    const RigidTransform a = T_camera_from_rig(*rig.head, angles);
    const RigidTransform b = T_camera_from_rig(*read->head, angles);
    EXPECT_LT((a.R - b.R).norm() + (a.t_mm - b.t_mm).norm(), 1e-9);
    EXPECT_NEAR(read->head->pan_backlash_rad, pan_backlash, 1e-15);
}

TEST(HeadCalibration, RefusesWhatTellsNoAxes) {
    const Rig truth = rig_with_head();
    const auto views = views_of(truth, 0.1, true, 1);
    EXPECT_FALSE(calibrate_head(truth, {views.begin(), views.begin() + 5}));
    auto narrow = views;
    for (HeadView& view : narrow) {
        view.encoder.tilt_rad *= 0.1;
    }
    EXPECT_FALSE(calibrate_head(truth, narrow));
    auto swapped = views;  // pan positive to the left
    for (HeadView& view : swapped) {
        view.encoder.pan_rad = -view.encoder.pan_rad;
    }
    EXPECT_FALSE(calibrate_head(truth, swapped));
    Rig two = truth;
    two.pan_tilt.reset();
    EXPECT_FALSE(calibrate_head(two, views));
}

}  // namespace
}  // namespace kambara
