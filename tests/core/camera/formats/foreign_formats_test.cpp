// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/camera/foreign_formats.h"

#include <gtest/gtest.h>

#include <string>

#include "core/base/angles.h"
#include "core/camera/nominal_rig.h"

namespace kambara {
namespace {

constexpr PictureSize vga{640, 480};

Rig brown_rig(const std::vector<double>& left, const std::vector<double>& right) {
    const Camera a{BrownLens(533.0, 534.0, 341.0, 235.0, left), 640, 480, {}};
    const Camera b{BrownLens(536.0, 537.0, 326.0, 250.0, right), 640, 480, {}};
    return rig_from_pair(a, b,
                         {rotation_about_y(rad_from_deg(3.0)) * rotation_about_x(rad_from_deg(1.0)),
                          {-99.8, 1.1, -2.0}});
}

// Points before the cameras must land on the same pixels through both rigs, seen from the left
// camera: the rigs' own frames may differ.
void expect_same_pixels(const Rig& a, const Rig& b, double tolerance_px) {
    for (const double x : {-250.0, 0.0, 310.0}) {
        for (const double y : {-180.0, 0.0, 170.0}) {
            for (const double z : {600.0, 1500.0}) {
                const Eigen::Vector3d in_left(x, y, z);
                const auto la = project(a.left.lens, in_left);
                const auto lb = project(b.left.lens, in_left);
                const auto ra = project(a.right->lens, T_right_from_left(a) * in_left);
                const auto rb = project(b.right->lens, T_right_from_left(b) * in_left);
                ASSERT_TRUE(la && lb && ra && rb);
                EXPECT_LT((*la - *lb).norm(), tolerance_px);
                EXPECT_LT((*ra - *rb).norm(), tolerance_px);
            }
        }
    }
}

const std::vector<double> five{-0.28, 0.09, 0.001, -0.0003, 0.01};
const std::vector<double> four{-0.28, 0.09, 0.001, -0.0003, 0.0};
const std::vector<double> eight{0.12, -0.05, 0.001, -0.0003, 0.01, 0.4, 0.02, 0.003};

TEST(ForeignFormats, OpenCvComesBackTheSame) {
    for (const auto& terms : {four, five, eight}) {
        const Rig rig = brown_rig(terms, terms);
        const auto files = rig_to_opencv(rig);
        ASSERT_TRUE(files) << files.error().text();
        EXPECT_EQ(files->worst_residual_px, 0.0);
        const auto back = rig_from_opencv(files->first, files->second, std::nullopt);
        ASSERT_TRUE(back) << back.error().text();
        EXPECT_EQ(back->left.width_px, 640);
        expect_same_pixels(rig, *back, 1e-9);
    }
}

TEST(ForeignFormats, RosComesBackTheSame) {
    for (const auto& terms : {four, five, eight}) {
        const Rig rig = brown_rig(terms, terms);
        const auto files = rig_to_ros(rig);
        ASSERT_TRUE(files) << files.error().text();
        const auto back = rig_from_ros(files->first, files->second);
        ASSERT_TRUE(back) << back.error().text();
        expect_same_pixels(rig, *back, 1e-6);
    }
}

TEST(ForeignFormats, KalibrComesBackTheSameWhereItsTermsSuffice) {
    const Rig rig = brown_rig(four, four);
    const auto files = rig_to_kalibr(rig);
    ASSERT_TRUE(files) << files.error().text();
    const auto back = rig_from_kalibr(files->first);
    ASSERT_TRUE(back) << back.error().text();
    expect_same_pixels(rig, *back, 1e-9);
}

TEST(ForeignFormats, ALensThatTheOtherSideLacksIsFittedAndTold) {
    const Rig rig = nominal_rig();
    const auto files = rig_to_opencv(rig);
    ASSERT_TRUE(files) << files.error().text();
    EXPECT_GT(files->worst_residual_px, 0.0);
    EXPECT_LT(files->worst_residual_px, most_export_residual_px);
    const auto back = rig_from_opencv(files->first, files->second, vga);
    ASSERT_TRUE(back) << back.error().text();
    // Over the whole picture, no farther off than was told.
    for (int y = 0; y < 480; y += 16) {
        for (int x = 0; x < 640; x += 16) {
            const auto ray = unproject(rig.left.lens, {x, y});
            ASSERT_TRUE(ray);
            const auto pixel = project(back->left.lens, ray->direction);
            ASSERT_TRUE(pixel);
            EXPECT_LT((*pixel - Eigen::Vector2d(x, y)).norm(), 2.0 * files->worst_residual_px);
        }
    }
}

TEST(ForeignFormats, ALensThatDoesNotFitIsRefusedWithTheResidual) {
    const auto files = rig_to_kalibr(nominal_rig());
    ASSERT_FALSE(files);
    EXPECT_NE(files.error().cause.find("px remain"), std::string::npos);
    EXPECT_NE(files.error().remedy.find("opencv"), std::string::npos);
    Rig mono = nominal_rig();
    mono.right.reset();
    EXPECT_FALSE(rig_to_opencv(mono));
}

TEST(ForeignFormats, KittiTellsLensesAndBaseline) {
    const char* plain =
        "7.070912e+02 0 6.018873e+02 0 0 7.070912e+02 1.831104e+02 0 0 0 1 0\n"
        "7.070912e+02 0 6.018873e+02 -3.798145e+02 0 7.070912e+02 1.831104e+02 0 0 0 1 0\n";
    const char* named =
        "P0: 7.070912e+02 0 6.018873e+02 0 0 7.070912e+02 1.831104e+02 0 0 0 1 0\n"
        "P1: 7.070912e+02 0 6.018873e+02 -3.798145e+02 0 7.070912e+02 1.831104e+02 0 0 0 1 0\n";
    for (const char* text : {plain, named}) {
        const auto rig = rig_from_kitti(text, PictureSize{1226, 370});
        ASSERT_TRUE(rig) << rig.error().text();
        EXPECT_NEAR(baseline_mm(*rig), 1000.0 * 379.8145 / 707.0912, 1e-9);
        EXPECT_TRUE(T_right_from_left(*rig).R.isIdentity(1e-12));
        EXPECT_NEAR(pinhole_parameters(rig->left.lens).fx_px, 707.0912, 1e-9);
    }
    EXPECT_NE(rig_from_kitti(plain, std::nullopt).error().remedy.find("--size"), std::string::npos);
}

TEST(ForeignFormats, OpenCvsOwnSpellingIsRead) {
    const char* intrinsics =
        "%YAML:1.0\n---\nM1: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n"
        "   data: [ 5.3e+02, 0., 3.4e+02, 0., 5.3e+02, 2.3e+02, 0., 0., 1. ]\n"
        "D1: !!opencv-matrix\n   rows: 1\n   cols: 5\n   dt: d\n   data: [ -0.28, 0.1, 0., 0., 0. "
        "]\n"
        "M2: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n"
        "   data: [ 5.3e+02, 0., 3.2e+02, 0., 5.3e+02, 2.5e+02, 0., 0., 1. ]\n"
        "D2: !!opencv-matrix\n   rows: 1\n   cols: 14\n   dt: d\n"
        "   data: [ -0.28, 0.1, 0., 0., 0., 0., 0., 0., 0., 0., 0., 0., 0., 0. ]\n";
    const char* extrinsics =
        "%YAML:1.0\n---\nR: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n"
        "   data: [ 1., 0., 0., 0., 1., 0., 0., 0., 1. ]\n"
        "T: !!opencv-matrix\n   rows: 3\n   cols: 1\n   dt: d\n   data: [ -100., 0., 0. ]\n";
    const auto rig = rig_from_opencv(intrinsics, extrinsics, vga);
    ASSERT_TRUE(rig) << rig.error().text();
    EXPECT_NEAR(baseline_mm(*rig), 100.0, 1e-9);
    EXPECT_NE(rig_from_opencv(intrinsics, extrinsics, std::nullopt).error().remedy.find("--size"),
              std::string::npos);
    EXPECT_NE(rig_from_opencv(extrinsics, intrinsics, vga).error().cause.find("M1"),
              std::string::npos);
}

TEST(ForeignFormats, WhatIsMissingIsNamed) {
    const auto files = rig_to_ros(brown_rig(five, five));
    ASSERT_TRUE(files);
    for (const char* key :
         {"image_width", "camera_matrix", "distortion_model", "distortion_coefficients",
          "rectification_matrix", "projection_matrix"}) {
        std::string text = files->second;
        text.replace(text.find(key), 3, "xxx");
        const auto rig = rig_from_ros(files->first, text);
        ASSERT_FALSE(rig) << key;
        EXPECT_NE(rig.error().cause.find(key), std::string::npos) << rig.error().cause;
    }
    EXPECT_NE(rig_from_kalibr("cam0: {}\n").error().cause.find("cam1"), std::string::npos);
    EXPECT_FALSE(rig_from_kitti("1 2 3\n", vga));
    EXPECT_FALSE(rig_from_kalibr(": : :"));
}

}  // namespace
}  // namespace kambara
