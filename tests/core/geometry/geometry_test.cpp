// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/geometry/rigid_transform.h"
#include "core/geometry/triangulate.h"

namespace kambara {
namespace {

using Eigen::Vector3d;

TEST(RigidTransform, ComposesInvertsAndKnowsItsCentre) {
    const RigidTransform T_b_from_a{rotation_about_x(0.3), {1, 2, 3}};
    const RigidTransform T_c_from_b{rotation_about_y(-0.7), {-4, 5, 6}};
    const Vector3d p(7, -8, 9);
    EXPECT_LT(((T_c_from_b * T_b_from_a) * p - T_c_from_b * (T_b_from_a * p)).norm(), 1e-14);
    EXPECT_LT((T_b_from_a.inverse() * (T_b_from_a * p) - p).norm(), 1e-14);
    EXPECT_LT((T_b_from_a * T_b_from_a.centre_mm()).norm(), 1e-14);
}

TEST(RigidTransform, RotationsHaveTheSignsOfTheNominalRig) {
    // A camera turned 3 degrees inward has its axis at (sin 3, 0, cos 3) with R = Ry(-3 degrees).
    const double t = std::numbers::pi / 60.0;
    const Vector3d inward(std::sin(t), 0, std::cos(t));
    const Vector3d down(0, std::sin(t), std::cos(t));
    EXPECT_LT((rotation_about_y(-t) * inward - Vector3d::UnitZ()).norm(), 1e-15);
    EXPECT_LT((rotation_about_x(t) * down - Vector3d::UnitZ()).norm(), 1e-15);
}

TEST(RigidTransform, TellsRotationsFromOtherMatrices) {
    const Eigen::Matrix3d R = rotation_about_x(1.0) * rotation_about_y(2.0);
    EXPECT_TRUE(is_rotation(R, 1e-12));
    EXPECT_FALSE(is_rotation(1.001 * R, 1e-6));
    EXPECT_FALSE(is_rotation(-R, 1e-6));
    EXPECT_FALSE(
        is_rotation(Eigen::Matrix3d::Constant(std::numeric_limits<double>::quiet_NaN()), 1.0));
}

TEST(RigidTransform, FindsTheNearestRotation) {
    const Eigen::Matrix3d R = rotation_about_x(1.0) * rotation_about_y(2.0);
    EXPECT_LT((nearest_rotation(3.0 * R) - R).norm(), 1e-13);
    const Eigen::Matrix3d mirrored = Vector3d(1, 1, -1).asDiagonal();
    EXPECT_TRUE(is_rotation(nearest_rotation(mirrored), 1e-12));
}

TEST(Triangulate, SkewRaysMeetAtTheMiddleOfTheirPerpendicular) {
    const Ray a{{0, 0, 0}, {0, 0, 1}};
    const Ray b{{100, 6, 300}, {-1, 0, 0}};
    const auto meeting = meeting_of(a, b);
    ASSERT_TRUE(meeting);
    EXPECT_NEAR(meeting->distance_a_mm, 300.0, 1e-10);
    EXPECT_NEAR(meeting->distance_b_mm, 100.0, 1e-10);
    EXPECT_NEAR(meeting->gap_mm, 6.0, 1e-10);
    EXPECT_NEAR(meeting->angle_rad, std::numbers::pi / 2.0, 1e-15);
    EXPECT_LT((meeting->midpoint_mm - Vector3d(0, 3, 300)).norm(), 1e-10);
}

TEST(Triangulate, SaysWhereRaysMeetBehindAndThatParallelOnesDoNot) {
    const auto behind = meeting_of({{0, 0, 0}, Vector3d(-1, 0, 1).normalized()},
                                   {{100, 0, 0}, Vector3d(1, 0, 1).normalized()});
    ASSERT_TRUE(behind);
    EXPECT_LT(behind->distance_a_mm, 0.0);
    EXPECT_LT(behind->distance_b_mm, 0.0);
    EXPECT_FALSE(meeting_of({{0, 0, 0}, {0, 0, 1}}, {{100, 0, 0}, {0, 0, 1}}));
}

TEST(Ray, MovesWithItsFrame) {
    const RigidTransform T_b_from_a{rotation_about_x(0.3), {1, 2, 3}};
    const Ray ray{{4, 5, 6}, Vector3d(1, 2, 2) / 3.0};
    EXPECT_LT(((T_b_from_a * ray).at(50.0) - T_b_from_a * ray.at(50.0)).norm(), 1e-13);
}

}  // namespace
}  // namespace kambara
