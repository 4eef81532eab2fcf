// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/camera/rig.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "core/base/angles.h"
#include "core/camera/nominal_rig.h"

namespace kambara {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

Vector3d axis_in_rig(const Camera& camera) {
    return camera.T_camera_from_rig.R.transpose() * Vector3d::UnitZ();
}

TEST(NominalRig, StandsAsTheGeometrySays) {
    const Rig rig = nominal_rig();
    const double c = std::cos(rad_from_deg(3.0));
    const double s = std::sin(rad_from_deg(3.0));
    EXPECT_NEAR(baseline_mm(rig), 450.0, 1e-12);
    EXPECT_LT((axis_in_rig(rig.left) - Vector3d(s, 0, c)).norm(), 1e-15);
    EXPECT_LT((axis_in_rig(*rig.right) - Vector3d(-s, 0, c)).norm(), 1e-15);
    EXPECT_LT((rig.left.T_camera_from_rig.centre_mm()).norm(), 1e-15);
    EXPECT_LT((rig.right->T_camera_from_rig.centre_mm() - Vector3d(450, 0, 0)).norm(), 1e-12);
    const double tilt = rad_from_deg(21.0);
    EXPECT_LT((axis_in_rig(*rig.pan_tilt) - Vector3d(0, std::sin(tilt), std::cos(tilt))).norm(),
              1e-15);
    EXPECT_LT((rig.pan_tilt->T_camera_from_rig.centre_mm() - Vector3d(225, -120, 30)).norm(),
              1e-12);
    const auto p = pinhole_parameters(rig.left.lens);
    EXPECT_NEAR(p.fx_px, 2.846366 * 1.030092 / 0.00762, 1e-9);
    EXPECT_NEAR(p.fy_px, 2.846366 / 0.0074, 1e-9);
}

TEST(NominalRig, HasLongerLensesInWater) {
    const Rig wet = nominal_rig(Medium::water);
    EXPECT_EQ(wet.medium, Medium::water);
    EXPECT_EQ(std::get<TsaiLens>(wet.left.lens).f_mm, 3.808516);
    EXPECT_EQ(std::get<TsaiLens>(wet.right->lens).kappa1_per_mm2, 0.007799);
}

TEST(Rig, FromAPairKeepsThePoseAndDefinesTheFrame) {
    const Rig nominal = nominal_rig();
    const RigidTransform pose{rotation_about_x(0.05) * rotation_about_y(0.11), {-390, 12, 25}};
    const Rig rig = rig_from_pair(nominal.left, *nominal.right, pose);
    EXPECT_LT((T_right_from_left(rig).R - pose.R).norm(), 1e-14);
    EXPECT_LT((T_right_from_left(rig).t_mm - pose.t_mm).norm(), 1e-11);
    EXPECT_TRUE(is_rotation(rig.left.T_camera_from_rig.R, 1e-14));
    EXPECT_LT(rig.left.T_camera_from_rig.centre_mm().norm(), 1e-12);
    EXPECT_LT((rig.right->T_camera_from_rig.centre_mm() - Vector3d(pose.t_mm.norm(), 0, 0)).norm(),
              1e-10);
    const Vector3d mean_axis = axis_in_rig(rig.left) + axis_in_rig(*rig.right);
    EXPECT_NEAR(mean_axis.y(), 0.0, 1e-14);
    EXPECT_GT(mean_axis.z(), 1.9);
}

TEST(Rig, FromThePairOfTheNominalRigIsTheNominalRig) {
    const Rig nominal = nominal_rig();
    const Rig rig = rig_from_pair(nominal.left, *nominal.right, T_right_from_left(nominal));
    EXPECT_LT((rig.left.T_camera_from_rig.R - nominal.left.T_camera_from_rig.R).norm(), 1e-14);
    EXPECT_LT((rig.right->T_camera_from_rig.t_mm - nominal.right->T_camera_from_rig.t_mm).norm(),
              1e-10);
}

TEST(Rig, ACameraProjectsFromTheRigsFrame) {
    const Rig rig = nominal_rig();
    const Vector3d point(150, -80, 1100);
    Eigen::Matrix<double, 2, 3> J;
    const auto pixel = rig.right->project(point, J);
    ASSERT_TRUE(pixel);
    const auto ray = rig.right->unproject(*pixel);
    ASSERT_TRUE(ray);
    EXPECT_LT((ray->origin_mm - Vector3d(450, 0, 0)).norm(), 1e-10);
    EXPECT_LT((ray->at((point - ray->origin_mm).norm()) - point).norm(), 1e-9);
    for (int k = 0; k < 3; ++k) {
        const Vector3d aside = 1e-3 * Vector3d::Unit(k);
        const Vector2d slope =
            (*rig.right->project(point + aside) - *rig.right->project(point - aside)) / 2e-3;
        EXPECT_LT((slope - J.col(k)).norm(), 1e-7 * J.norm());
    }
}

TEST(Rig, ScaledToOtherPicturesOnceOrTwice) {
    const Rig rig = nominal_rig();
    const Rig large = scaled_to(rig, 1280, 720);
    const Rig back = scaled_to(large, 640, 480);
    const Vector3d point(150, -80, 1100);
    const Vector2d before = *rig.left.project(point);
    const Vector2d expected(2.0 * (before.x() + 0.5) - 0.5, 1.5 * (before.y() + 0.5) - 0.5);
    EXPECT_LT((*large.left.project(point) - expected).norm(), 1e-10);
    EXPECT_LT((*back.left.project(point) - before).norm(), 1e-10);
    EXPECT_EQ(large.right->width_px, 1280);
    EXPECT_EQ(large.pan_tilt->width_px, 640);
    EXPECT_EQ(large.pan_tilt->lens, rig.pan_tilt->lens);
    EXPECT_TRUE(large.left.sees({1279, 719}));
    EXPECT_FALSE(rig.left.sees({639.5, 100}));
}

}  // namespace
}  // namespace kambara
