// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pointing/servo.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "core/camera/nominal_rig.h"
#include "core/pointing/aim.h"
#include "core/pointing/pan_tilt_view.h"

namespace kambara {
namespace {

constexpr std::int64_t frame_ns = 33'333'333;

double apart_deg(const HeadAngles& a, const HeadAngles& b) {
    return deg_from_rad(std::hypot(a.pan_rad - b.pan_rad, a.tilt_rad - b.tilt_rad));
}

Eigen::Vector3d in_rig(const Rig& rig, const Eigen::Vector3d& point_in_left_mm) {
    return rig.left.T_camera_from_rig.inverse() * point_in_left_mm;
}

HeadModel with_arms(const Rig& rig) {
    HeadModel model;
    model.T_base_from_rig = rig.pan_tilt->T_camera_from_rig;
    model.tilt_axis_ahead_mm = 40.0;
    model.T_camera_from_tilt.t_mm = {0.0, -15.0, -30.0};
    return model;
}

TEST(PanTiltView, WhatIsSeenSomewhereIsCentredByTheAnglesFound) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    for (const bool arms : {false, true}) {
        Rig rig = nominal_rig();
        if (arms) {
            rig.head = with_arms(rig);
        }
        for (int i = 0; i < 200; ++i) {
            const Eigen::Vector3d point(600.0 * unit(random), 200.0 + 200.0 * unit(random),
                                        1500.0 + 400.0 * unit(random));
            const HeadAngles wanted = angles_towards(rig, point);
            const HeadAngles now{wanted.pan_rad + 0.2 * unit(random),
                                 wanted.tilt_rad + 0.15 * unit(random)};
            const Camera camera = pan_tilt_camera_at(rig, now);
            const auto pixel = camera.project(in_rig(rig, point));
            ASSERT_TRUE(pixel);
            const double range_mm = (camera.T_camera_from_rig * in_rig(rig, point)).norm();
            const auto found = angles_to_centre(rig, now, *pixel, range_mm);
            ASSERT_TRUE(found);
            EXPECT_LT(apart_deg(*found, wanted), 1e-4);
        }
    }
}

TEST(PanTiltView, AWrongMountMattersToSecondOrderOnly) {
    const Rig truth = nominal_rig();
    Rig wrong = truth;
    wrong.pan_tilt->T_camera_from_rig =
        RigidTransform{
            Eigen::AngleAxisd(rad_from_deg(1.0), Eigen::Vector3d(1.0, 1.0, 0.0).normalized())
                .toRotationMatrix(),
            Eigen::Vector3d::Zero()} *
        wrong.pan_tilt->T_camera_from_rig;
    const Eigen::Vector3d point(200.0, 150.0, 1600.0);
    const HeadAngles right = angles_towards(truth, point);
    const HeadAngles now{right.pan_rad + rad_from_deg(3.0), right.tilt_rad - rad_from_deg(2.0)};
    const auto pixel = pan_tilt_camera_at(truth, now).project(in_rig(truth, point));
    EXPECT_GT(apart_deg(angles_towards(wrong, point), right), 0.9);
    EXPECT_LT(apart_deg(*angles_to_centre(wrong, now, *pixel, 1600.0), right), 0.03);
}

TEST(PanTiltView, AtAnotherZoomTheSameDirectionIsFound) {
    const Rig rig = nominal_rig();
    const Camera& wide = *rig.pan_tilt;
    // Twice the focal length: what was 20 px off is 40 px off.
    const auto back = pixel_at_calibrated_zoom(wide, {319.5 + 40.0, 239.5 - 80.0}, 2.0);
    EXPECT_NEAR(back.x(), 339.5, 1e-6);
    EXPECT_NEAR(back.y(), 199.5, 1e-6);
}

TEST(ServoAim, FindsTheMountsErrorThroughNoiseAndLeavesAnotherTargetOut) {
    std::mt19937 random(5);
    std::normal_distribution<double> noise(0.0, rad_from_deg(0.1));
    ServoAim servo;
    const HeadAngles off{rad_from_deg(0.7), rad_from_deg(-0.7)};
    double worst_deg = 0.0;
    for (int i = 0; i < 300; ++i) {
        const HeadAngles by_stereo{0.3 * std::sin(0.05 * i), 0.1};
        const HeadAngles seen{by_stereo.pan_rad + off.pan_rad + noise(random),
                              by_stereo.tilt_rad + off.tilt_rad + noise(random)};
        EXPECT_TRUE(servo.compare(by_stereo, seen, i * frame_ns));
        if (i > 30) {
            worst_deg = std::max(worst_deg, apart_deg(*servo.correction(), off));
        }
    }
    EXPECT_LT(worst_deg, 0.12);
    const HeadAngles before = *servo.correction();
    EXPECT_FALSE(servo.compare({0.0, 0.0}, {0.3, 0.0}, 301 * frame_ns));
    EXPECT_EQ(*servo.correction(), before);
}

TEST(ServoAim, AloneItGoesOnAsTheTargetMoves) {
    ServoAim servo;
    EXPECT_FALSE(servo.alone(0));
    const double rate = rad_from_deg(10.0);
    for (int i = 0; i < 60; ++i) {
        servo.see({rate * i / 30.0, 0.2}, i * frame_ns);
    }
    const auto led = servo.alone(59 * frame_ns + 60'000'000);
    EXPECT_NEAR(led->angles.pan_rad, rate * (59.0 / 30.0 + 0.06), rad_from_deg(0.02));
    EXPECT_NEAR(led->rate_rad_s.pan_rad, rate, rad_from_deg(0.2));
    // No farther than a tenth of a second, however late.
    EXPECT_NEAR(servo.alone(90 * frame_ns)->angles.pan_rad, rate * (59.0 / 30.0 + 0.1),
                rad_from_deg(0.05));
}

}  // namespace
}  // namespace kambara
