// SPDX-License-Identifier: GPL-3.0-or-later
// The methods that the reported position is compared with.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "core/stereo/midpoint.h"
#include "core/stereo/parallel_range.h"
#include "core/stereo/sine_rule.h"
#include "tests/core/stereo/stereo_samples.h"

namespace kambara {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

TEST(Midpoint, IsThePointWhereTheRaysMeet) {
    for (const Rig& rig : rig_samples()) {
        for (const SeenPoint& point : seen_points(rig, 100)) {
            const auto found = midpoint_from_pair(rig, point.left_px, point.right_px);
            ASSERT_TRUE(found);
            EXPECT_LT((*found - point.in_left_mm).norm(), 1e-6);
        }
    }
}

TEST(SineRule, IsThePointWhereTheRaysMeet) {
    for (const Rig& rig : rig_samples()) {
        for (const SeenPoint& point : seen_points(rig, 100)) {
            const auto found = sine_rule_from_pair(rig, point.left_px, point.right_px);
            ASSERT_TRUE(found);
            EXPECT_LT((found->along_left_mm - point.in_left_mm).norm(), 1e-5);
            EXPECT_LT((found->along_right_mm - point.in_left_mm).norm(), 1e-5);
        }
    }
}

TEST(SineRule, WorksInAnyWorldFrame) {
    const Rig rig = nominal_rig();
    const RigidTransform T_rig_from_world{rotation_about_x(0.8) * rotation_about_y(-2.1),
                                          {700, -300, 1500}};
    const double f_left_mm = 2.846366;
    const double f_right_mm = 2.882766;
    for (const Vector3d& in_rig_mm : {Vector3d(225, 0, 1232), Vector3d(-200, 150, 3000)}) {
        const Vector3d in_left = rig.left.T_camera_from_rig * in_rig_mm;
        const Vector3d in_right = rig.right->T_camera_from_rig * in_rig_mm;
        const auto found = sine_rule(
            {rig.left.T_camera_from_rig * T_rig_from_world, in_left * (f_left_mm / in_left.z())},
            {rig.right->T_camera_from_rig * T_rig_from_world,
             in_right * (f_right_mm / in_right.z())});
        ASSERT_TRUE(found);
        EXPECT_LT((found->mean_mm() - in_left).norm(), 1e-7);
    }
}

// Equation 40 as printed takes the angle between BF and HF, not the triangle's inner one: with
// 1999's own poses a target at 1232 mm comes out at 5429 mm, with the nominal rig far beyond.
TEST(SineRule, AsPrintedIn1999ItIsOffByMetres) {
    const Rig rig = nominal_rig();
    const Vector3d in_rig_mm(225, 0, 1232);
    const auto angle = [](const Vector3d& a, const Vector3d& b) {
        return std::atan2(a.cross(b).norm(), a.dot(b));
    };
    const auto on_sensor = [&](const Camera& camera, double f_mm) {
        const Vector3d in_camera = camera.T_camera_from_rig * in_rig_mm;
        return Vector3d(camera.T_camera_from_rig.R.transpose() *
                        (in_camera * (f_mm / in_camera.z())));
    };
    const Vector3d DH = on_sensor(rig.left, 2.846366);
    const Vector3d BF = on_sensor(*rig.right, 2.882766);
    const Vector3d HF = (rig.right->T_camera_from_rig.centre_mm() + BF) -
                        (rig.left.T_camera_from_rig.centre_mm() + DH);
    const auto range_mm = [&](const Vector3d& side_at_F) {
        const double at_F = angle(BF, side_at_F);
        const double at_P = std::numbers::pi - angle(DH, HF) - at_F;
        return std::abs(HF.norm() * std::sin(at_F) / std::sin(at_P)) + DH.norm();
    };
    const double truth_mm = (in_rig_mm - rig.left.T_camera_from_rig.centre_mm()).norm();
    EXPECT_NEAR(range_mm(-HF), truth_mm, 1e-6);
    EXPECT_GT(range_mm(HF), 4.0 * truth_mm);
    std::printf("as printed: %.0f mm for %.0f mm\n", range_mm(HF), truth_mm);
}

TEST(SineRule, OffTheEpipolarLineTheTwoLinesOfSightDisagree) {
    const Rig rig = nominal_rig();
    const SeenPoint point = seen(rig, {100, 50, 1500});
    const Vector2d right = point.right_px + Vector2d(0.0, 1.0);
    const auto found = sine_rule_from_pair(rig, point.left_px, right);
    const auto midpoint = midpoint_from_pair(rig, point.left_px, right);
    ASSERT_TRUE(found && midpoint);
    EXPECT_GT((found->along_left_mm - found->along_right_mm).norm(), 2.0);
    EXPECT_LT((found->mean_mm() - *midpoint).norm(), 2.0);
    // Each stays on its own line of sight.
    const Vector3d left_ray = unproject(rig.left.lens, point.left_px)->direction;
    EXPECT_LT(found->along_left_mm.cross(left_ray).norm(), 1e-9 * found->along_left_mm.norm());
}

TEST(SineRule, RefusesParallelAndDivergingLines) {
    const SensorPoint left{{}, {0.0, 0.0, 3.0}};
    const RigidTransform right_pose{Eigen::Matrix3d::Identity(), {-450, 0, 0}};
    EXPECT_FALSE(sine_rule(left, {right_pose, {0.0, 0.0, 3.0}}));
    EXPECT_FALSE(sine_rule(left, {right_pose, {0.5, 0.0, 3.0}}));
    const auto met = sine_rule(left, {right_pose, {-0.5, 0.0, 3.0}});
    ASSERT_TRUE(met);
    EXPECT_LT((met->mean_mm() - Vector3d(0, 0, 2700)).norm(), 1e-9);
}

TEST(References, RefuseFarPointsAsThePositionDoes) {
    const Rig rig = nominal_rig();
    const SeenPoint far = seen(rig, {0, 0, 2e6});
    EXPECT_FALSE(midpoint_from_pair(rig, far.left_px, far.right_px));
    EXPECT_FALSE(sine_rule_from_pair(rig, far.left_px, far.right_px));
}

TEST(ParallelRange, IsBaselineTimesFocalLengthByDisparity) {
    // 450 mm apart, 3 mm lenses: a point at 1500 mm is 0.9 mm, 120 pixels of 0.0075 mm, across.
    EXPECT_NEAR(*parallel_range_mm(450.0, 3.0, 120.0, 0.0075), 1500.0, 1e-9);
    EXPECT_NEAR(*parallel_range_mm(450.0, 3.0, 60.0, 0.0075), 3000.0, 1e-9);
    EXPECT_FALSE(parallel_range_mm(450.0, 3.0, 0.0, 0.0075));
    EXPECT_FALSE(parallel_range_mm(450.0, 3.0, -5.0, 0.0075));
    EXPECT_FALSE(parallel_range_mm(450.0, 3.0, std::nan(""), 0.0075));
}

}  // namespace
}  // namespace kambara
