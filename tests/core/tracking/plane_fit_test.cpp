// SPDX-License-Identifier: GPL-3.0-or-later
// Leaning planes of known slope, seen by two cameras of which one is rolled by 60 degrees.
#include "core/tracking/plane_fit.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <random>

#include "core/camera/nominal_rig.h"
#include "tests/support/textured_plane.h"

namespace kambara {
namespace {

using testing_support::drawn;
using testing_support::TexturedPlane;

const Eigen::Vector2d centre_px(310.0, 230.0);
constexpr double range_z_mm = 1500.0;

Rig rolled_rig() {
    Rig rig = nominal_rig();
    const Eigen::AngleAxisd roll(std::numbers::pi / 3.0, Eigen::Vector3d::UnitZ());
    RigidTransform& T = rig.right->T_camera_from_rig;
    T.R = roll * T.R;
    T.t_mm = roll * T.t_mm;
    return rig;
}

Image noisy(const Image& picture, double sigma_grey, std::mt19937& random) {
    std::normal_distribution<double> noise(0.0, sigma_grey);
    Image result = picture;
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            result.at(x, y) = static_cast<std::uint8_t>(
                std::lround(std::clamp(picture.at(x, y) + noise(random), 0.0, 255.0)));
        }
    }
    return result;
}

class PlaneFitTest : public testing::Test {
  protected:
    PlaneFitTest() : rig_(rolled_rig()), ray_(*rig_.left.unproject(centre_px)) {}

    void lean(const Eigen::Vector2d& slope) {
        point_ = ray_.at(range_z_mm / ray_.direction.z());
        TexturedPlane plane{point_};
        plane.slope = slope;
        left_ = drawn(plane, rig_.left);
        right_ = drawn(plane, *rig_.right);
        truth_px_ = *rig_.right->project(point_);
    }
    ReferencePatch patch(const Image& left, int size_px = 41) const {
        return {std::make_shared<const Image>(left), centre_px, {size_px, size_px}, point_};
    }
    double range_mm() const { return (point_ - ray_.origin_mm).norm(); }

    Rig rig_;
    Ray ray_;
    Eigen::Vector3d point_;
    Image left_;
    Image right_;
    Eigen::Vector2d truth_px_;
};

TEST_F(PlaneFitTest, FindsDistanceAndSlopesFromASquareStartAFewPixelsOff) {
    for (const Eigen::Vector2d& slope :
         {Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(0.5, 0.2), Eigen::Vector2d(-0.3, 0.6)}) {
        lean(slope);
        const auto fit = fit_plane(patch(left_), rig_, right_, 1.02 * range_mm());
        ASSERT_TRUE(fit) << slope.transpose();
        EXPECT_LT((fit->right_px - truth_px_).norm(), 0.03) << slope.transpose();
        EXPECT_NEAR(fit->range_mm, range_mm(), 0.0005 * range_mm()) << slope.transpose();
        EXPECT_LT((fit->slope - slope).norm(), 0.02) << fit->slope.transpose();
        EXPECT_LT(std::abs(fit->off_curve_px), 0.03);
        EXPECT_GT(fit->likeness, 0.99);
    }
}

TEST_F(PlaneFitTest, SaysHowFarOffItMayBe) {
    lean({0.3, -0.2});
    std::mt19937 random(5);
    double squared = 0.0;
    constexpr double noise_grey = 2.0;
    constexpr int cases = 200;
    for (int i = 0; i < cases; ++i) {
        const auto fit = fit_plane(patch(noisy(left_, noise_grey, random), 25), rig_,
                                   noisy(right_, noise_grey, random), range_mm());
        ASSERT_TRUE(fit);
        const Eigen::Vector2d off = fit->right_px - truth_px_;
        squared += off.dot(fit->covariance_px2.inverse() * off);
    }
    // Two dimensions: 2 on average, 2.5 measured, since noise counts as texture: the covariance is
    // about a fifth too small.
    std::printf("error squared by covariance: %.2f\n", squared / cases);
    EXPECT_GT(squared / cases, 1.6);
    EXPECT_LT(squared / cases, 3.0);
}

TEST_F(PlaneFitTest, TellsTheCalibrationsErrorAcrossTheCurve) {
    lean({0.2, 0.4});
    Rig bent = rig_;  // the right camera turned by what moves its picture by about two pixels
    const Eigen::AngleAxisd turn(0.002, Eigen::Vector3d::UnitX());
    bent.right->T_camera_from_rig.R = turn * bent.right->T_camera_from_rig.R;
    bent.right->T_camera_from_rig.t_mm = turn * bent.right->T_camera_from_rig.t_mm;
    const auto fit = fit_plane(patch(left_), bent, right_, range_mm());
    ASSERT_TRUE(fit);
    EXPECT_GT(std::abs(fit->off_curve_px), 0.2);
    EXPECT_LT((fit->right_px - truth_px_).norm(), 0.05);
}

TEST_F(PlaneFitTest, RefusesWhereNothingTellsThePlane) {
    lean({0.0, 0.0});
    const Image flat = [&] {
        Image picture(left_.width(), left_.height());
        for (int y = 0; y < picture.height(); ++y) {
            std::fill_n(picture.row(y), picture.row_bytes(), std::uint8_t{120});
        }
        return picture;
    }();
    EXPECT_FALSE(fit_plane(patch(flat), rig_, flat, range_mm()));
    EXPECT_FALSE(fit_plane(patch(left_), rig_, flat, range_mm()));
    // So far off it may settle anywhere, but the pictures do not agree there.
    const auto astray = fit_plane(patch(left_), rig_, right_, 1.5 * range_mm());
    EXPECT_LT(astray ? astray->likeness : 0.0, 0.8);
}

}  // namespace
}  // namespace kambara
