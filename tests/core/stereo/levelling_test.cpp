// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/stereo/levelling.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/base/angles.h"
#include "core/camera/nominal_rig.h"
#include "core/camera/position_frame.h"
#include "core/camera/rig_file.h"

namespace kambara {
namespace {

using Points = std::vector<Eigen::Vector3d>;

Mount mounted(double pitch_deg, double roll_deg) {
    Mount mount;
    mount.pitch_rad = rad_from_deg(pitch_deg);
    mount.roll_rad = rad_from_deg(roll_deg);
    return mount;
}

// Noise of a stereo rig: 1 mm across, 3 mm in depth.
Eigen::Vector3d noise(std::mt19937& random, double share) {
    std::normal_distribution<double> unit(0.0, share);
    return {unit(random), unit(random), 3.0 * unit(random)};
}

Points plumb_line(const Mount& mount, double noise_mm, unsigned seed) {
    std::mt19937 random(seed);
    Points points;
    for (int i = 0; i < 60; ++i) {
        const Eigen::Vector3d level(200.0, -300.0 + 10.0 * i, 1400.0);
        points.push_back(R_level_from_rig(mount).transpose() * level + noise(random, noise_mm));
    }
    return points;
}

Points wall(const Mount& mount, double facing_deg, double noise_mm, unsigned seed) {
    std::mt19937 random(seed);
    Points points;
    const Eigen::Matrix3d turned = rotation_about_y(rad_from_deg(facing_deg));
    for (int i = -4; i <= 4; ++i) {
        for (int j = -4; j <= 4; ++j) {
            const Eigen::Vector3d level =
                Eigen::Vector3d(0, 0, 1800) + turned * Eigen::Vector3d(100.0 * i, 80.0 * j, 0.0);
            points.push_back(R_level_from_rig(mount).transpose() * level + noise(random, noise_mm));
        }
    }
    return points;
}

TEST(Levelling, TheMountSaysWhereDownIs) {
    const Mount mount = mounted(15.0, 4.0);
    // Looking down: straight ahead and level is seen above the axis.
    EXPECT_LT((R_level_from_rig(mounted(15, 0)).transpose() * Eigen::Vector3d::UnitZ()).y(), 0.0);
    // The right side hangs down: so does the x axis.
    EXPECT_GT((R_level_from_rig(mount) * Eigen::Vector3d::UnitX()).y(), 0.0);
    const Mount again = mount_of_down(R_level_from_rig(mount).row(1).transpose());
    EXPECT_NEAR(again.pitch_rad, mount.pitch_rad, 1e-12);
    EXPECT_NEAR(again.roll_rad, mount.roll_rad, 1e-12);
}

TEST(Levelling, AVerticalMovementTellsPitchAndRoll) {
    for (const auto& [pitch, roll] : {std::pair{15.0, 0.0}, {36.0, -5.0}, {-10.0, 8.0}}) {
        const auto exact = level_from_vertical(plumb_line(mounted(pitch, roll), 0.0, 1));
        ASSERT_TRUE(exact) << exact.error().text();
        EXPECT_NEAR(deg_from_rad(exact->mount.pitch_rad), pitch, 1e-6);
        EXPECT_NEAR(deg_from_rad(exact->mount.roll_rad), roll, 1e-6);
        EXPECT_NEAR(exact->extent_mm, 590.0, 1e-6);
    }
}

// The deviations told hold against 300 repetitions, for pitch by either means and for roll.
TEST(Levelling, ItsDeviationsAreWhatRepetitionShows) {
    double off[3] = {};
    double told[3] = {};
    const int times = 300;
    const Mount truth = mounted(15.0, 3.0);
    for (unsigned seed = 0; seed < times; ++seed) {
        const auto line = level_from_vertical(plumb_line(truth, 1.0, seed));
        const auto plane = level_from_wall(wall(truth, 20.0, 1.0, seed), truth.roll_rad);
        ASSERT_TRUE(line && plane);
        off[0] += std::pow(line->mount.pitch_rad - truth.pitch_rad, 2) / times;
        off[1] += std::pow(line->mount.roll_rad - truth.roll_rad, 2) / times;
        off[2] += std::pow(plane->mount.pitch_rad - truth.pitch_rad, 2) / times;
        told[0] += *line->mount.pitch_sigma_rad / times;
        told[1] += *line->mount.roll_sigma_rad / times;
        told[2] += *plane->mount.pitch_sigma_rad / times;
    }
    for (int i = 0; i < 3; ++i) {
        std::printf("deviation %d: told %.4f, found %.4f degrees\n", i, deg_from_rad(told[i]),
                    deg_from_rad(std::sqrt(off[i])));
        EXPECT_NEAR(told[i] / std::sqrt(off[i]), 1.0, 0.2) << i;
    }
}

TEST(Levelling, WildPointsAreLeftOut) {
    auto points = plumb_line(mounted(15.0, 0.0), 0.5, 1);
    points[7].z() += 400.0;
    points[30].x() -= 90.0;
    const auto result = level_from_vertical(points);
    ASSERT_TRUE(result) << result.error().text();
    EXPECT_GE(result->points_left_out, 2);
    EXPECT_NEAR(deg_from_rad(result->mount.pitch_rad), 15.0, 0.3);
}

TEST(Levelling, RefusesWhatTellsNoAngle) {
    Points across;
    Points cloud;
    std::mt19937 random(1);
    for (int i = 0; i < 30; ++i) {
        across.emplace_back(20.0 * i, 1.0, 1500.0);
        cloud.push_back(Eigen::Vector3d(0, 0, 1500) + noise(random, 30.0));
    }
    EXPECT_FALSE(level_from_vertical(across));
    EXPECT_FALSE(level_from_vertical(cloud));
    EXPECT_FALSE(level_from_vertical({across.begin(), across.begin() + 3}));
    EXPECT_FALSE(level_from_wall(across));
    EXPECT_FALSE(level_from_wall(wall(mounted(15, 0), 80.0, 0.0, 1)));
    EXPECT_FALSE(level_from_vertical(Points(20, Eigen::Vector3d(0, 0, 1500))));
    // Swung aside it tells the pitch, but not the roll.
    Points swung;
    for (int i = 0; i < 10; ++i) {
        swung.emplace_back(i % 2 == 0 ? 120.0 : -120.0, 110.0 * i, 1500.0);
    }
    EXPECT_FALSE(level_from_vertical(swung));
    auto lost = plumb_line(mounted(15, 0), 0.0, 1);
    lost[3].x() = NAN;
    EXPECT_FALSE(level_from_vertical(lost));
}

TEST(Levelling, TheMovementIsToldWhetherOrNotItIsOfUse) {
    EXPECT_EQ(movement_of({}).extent_mm, 0.0);
    EXPECT_EQ(movement_of({{1, 2, 3}}).extent_mm, 0.0);
    // 100 mm along a line, each end off it by 3 mm to the sides and by 4 mm in depth.
    std::vector<Eigen::Vector3d> points;
    for (int i = 0; i <= 10; ++i) {
        for (const double side : {-1.0, 1.0}) {
            points.push_back({3.0 * side, 10.0 * i, 1000.0 + 4.0 * side});
        }
    }
    const Movement movement = movement_of(points);
    EXPECT_NEAR(movement.extent_mm, 100.0, 1e-9);
    EXPECT_NEAR(movement.off_line_rms_mm, 5.0, 1e-9);
    EXPECT_NEAR(movement.off_plane_rms_mm, 0.0, 1e-6);
}

TEST(Levelling, ABendMayTurnALineByItsResidual) {
    EXPECT_EQ(largest_turn_by_bending_rad(1.0, 0.0), 0.0);
    // Along 300 mm evenly from -a to a: its RMS is a / sqrt(3), and it is turned by 2 a / 300.
    const double a = 3.0;
    EXPECT_NEAR(largest_turn_by_bending_rad(a / std::sqrt(3.0), 300.0), std::atan(2.0 * a / 300.0),
                1e-12);
}

TEST(Levelling, TheRigKeepsWhatWasNotMeasured) {
    Rig rig = nominal_rig();
    rig.mount = Mount{0.1, 0.2, 0.3, {1, 2, 3}, 0.01, 0.02};
    Levelling found;
    found.mount = Mount{0.5, 0.2, 0.0, {0, 0, 0}, 0.001, std::nullopt};
    const Mount by_wall = *with_mount(rig, found, true).mount;
    EXPECT_EQ(by_wall, (Mount{0.5, 0.2, 0.3, {1, 2, 3}, 0.001, 0.02}));
    EXPECT_FALSE(with_mount(rig, found, false).mount->roll_sigma_rad);
    rig.mount.reset();
    EXPECT_EQ(with_mount(rig, found, false).mount->heading_rad, 0.0);
}

TEST(Levelling, PositionsInEachFrame) {
    Rig rig = nominal_rig();
    EXPECT_FALSE(T_frame_from_left(rig, "level"));
    EXPECT_FALSE(T_frame_from_left(rig, "elsewhere"));
    rig.mount = mounted(15.0, 0.0);
    rig.mount->heading_rad = rad_from_deg(90.0);
    rig.mount->rig_in_vehicle_mm = {400.0, -225.0, 100.0};
    const auto read = rig_from_text(rig_to_text(rig));
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_NEAR(read->mount->pitch_rad, rig.mount->pitch_rad, 1e-14);
    EXPECT_NEAR(read->mount->heading_rad, rig.mount->heading_rad, 1e-14);
    EXPECT_EQ(read->mount->rig_in_vehicle_mm, rig.mount->rig_in_vehicle_mm);
    // A metre straight ahead and level; the rig looks to starboard.
    const Eigen::Vector3d in_rig(0.0, -1000.0 * std::sin(rad_from_deg(15.0)),
                                 1000.0 * std::cos(rad_from_deg(15.0)));
    const Eigen::Vector3d in_left = rig.left.T_camera_from_rig * in_rig;
    const auto at = [&](const char* frame) -> Eigen::Vector3d {
        return T_frame_from_left(*read, frame).value() * in_left;
    };
    EXPECT_LT((at("left") - in_left).norm(), 1e-9);
    EXPECT_LT((at("rig") - in_rig).norm(), 1e-9);
    EXPECT_LT((at("level") - Eigen::Vector3d(0, 0, 1000)).norm(), 1e-9);
    EXPECT_LT((at("vehicle") - Eigen::Vector3d(400.0, 775.0, 100.0)).norm(), 1e-9);
}

}  // namespace
}  // namespace kambara
