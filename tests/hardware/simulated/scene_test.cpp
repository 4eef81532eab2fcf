// SPDX-License-Identifier: GPL-3.0-or-later
#include "hardware/simulated/scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "core/camera/nominal_rig.h"
#include "core/pointing/aim.h"
#include "hardware/simulated/blur.h"

namespace kambara {
namespace {

using Eigen::Vector3d;

SimulatedProfile profile_of(std::string_view text) {
    return simulated_profile(text).value();
}

// How far inside a camera's picture a point lies, px; negative outside.
double margin_px(const Camera& camera, const Vector3d& point_in_rig_mm) {
    const auto pixel = camera.project(point_in_rig_mm);
    if (!pixel) {
        return -1e9;
    }
    return std::min({pixel->x(), pixel->y(), camera.width_px - 1 - pixel->x(),
                     camera.height_px - 1 - pixel->y()});
}

TEST(Scene, TheTargetKeepsWithinWhatBothCamerasAndTheHeadSee) {
    for (const Medium medium : {Medium::air, Medium::water}) {
        const Rig rig = nominal_rig(medium);
        for (std::uint32_t seed = 1; seed <= 5; ++seed) {
            SimulatedProfile profile;
            profile.seed = seed;
            const Scene scene(profile);
            constexpr double step_s = 0.1;
            double fastest_mm_s = 0.0;
            double nearest_mm = 1e9;
            double farthest_mm = 0.0;
            double widest_pan_rad = 0.0;
            double widest_tilt_rad = 0.0;
            double narrowest_px = 1e9;
            double most_turned_rad = 0.0;
            for (double t = 0.0; t < 120.0; t += step_s) {
                const RigidTransform pose = scene.T_rig_from_target(t);
                const HeadAngles towards =
                    angles_towards(rig, rig.left.T_camera_from_rig * pose.t_mm);
                const double range = pose.t_mm.z();
                nearest_mm = std::min(nearest_mm, range);
                farthest_mm = std::max(farthest_mm, range);
                widest_pan_rad = std::max(widest_pan_rad, std::abs(towards.pan_rad));
                widest_tilt_rad = std::max(widest_tilt_rad, std::abs(towards.tilt_rad));
                most_turned_rad = std::max(most_turned_rad, std::acos(pose.R(2, 2)));
                const Vector3d moved = scene.T_rig_from_target(t + step_s).t_mm - pose.t_mm;
                fastest_mm_s = std::max(fastest_mm_s, moved.norm() / step_s);
                for (const double x : {-1.0, 1.0}) {
                    for (const double y : {-1.0, 1.0}) {
                        const Vector3d corner =
                            pose * (Scene::target_half_side_mm * Vector3d(x, y, 0.0));
                        narrowest_px = std::min({narrowest_px, margin_px(rig.left, corner),
                                                 margin_px(*rig.right, corner)});
                    }
                }
            }
            SCOPED_TRACE("seed " + std::to_string(seed));
            EXPECT_GT(nearest_mm, 1200.0);
            EXPECT_LT(farthest_mm, 2800.0);
            EXPECT_GT(farthest_mm - nearest_mm, 1000.0);
            EXPECT_LT(widest_pan_rad, rad_from_deg(60.0));
            EXPECT_LT(widest_tilt_rad, rad_from_deg(24.0));
            EXPECT_GT(narrowest_px, 60.0);
            EXPECT_LT(fastest_mm_s, 330.0);
            EXPECT_GT(fastest_mm_s, 200.0);
            EXPECT_LT(most_turned_rad, rad_from_deg(4.3));
        }
    }
}

TEST(Scene, CalibrationTargetsStandStillInPicturesOfBothCameras) {
    for (const char* text : {"chessboard", "chessboard?seed=2", "two-plane-24"}) {
        SCOPED_TRACE(text);
        const SimulatedProfile profile = profile_of(text);
        const Scene scene(profile);
        const Rig rig = nominal_rig();
        const auto corners = corners_in_target_mm(*profile.calibration_target);
        constexpr int poses = 40;
        int in_both = 0;
        double nearest_mm = 1e9;
        double farthest_mm = 0.0;
        for (int pose = 0; pose < poses; ++pose) {
            const RigidTransform early = scene.T_rig_from_target(pose);
            const RigidTransform late = scene.T_rig_from_target(pose + 0.99);
            EXPECT_EQ(early.R, late.R);
            EXPECT_EQ(early.t_mm, late.t_mm);
            EXPECT_EQ(scene.still_since(pose), scene.still_since(pose + 0.99));
            EXPECT_NE(scene.still_since(pose), scene.still_since(pose + 1.0));
            EXPECT_GT((early.t_mm - scene.T_rig_from_target(pose + 1.0).t_mm).norm(), 5.0);
            double narrowest_px = 1e9;
            for (const Vector3d& corner : corners) {
                const Vector3d point = early * corner;
                nearest_mm = std::min(nearest_mm, point.z());
                farthest_mm = std::max(farthest_mm, point.z());
                narrowest_px = std::min(
                    {narrowest_px, margin_px(rig.left, point), margin_px(*rig.right, point)});
            }
            in_both += narrowest_px > 10.0 ? 1 : 0;
        }
        EXPECT_GE(in_both, poses * 9 / 10);
        EXPECT_GT(nearest_mm, 400.0);
        EXPECT_LT(farthest_mm, 1800.0);
    }
}

TEST(Scene, TheSeabedEndsAtTheHorizon) {
    const Scene scene(profile_of("default"));
    // The cameras look 15 degrees down from 1.5 m above the bed.
    const double up = rad_from_deg(15.0);
    EXPECT_EQ(scene.seabed_range_mm({{0, 0, 0}, {0, -std::sin(up), std::cos(up)}}),
              Scene::no_seabed);
    const double below = up - rad_from_deg(1.0);
    EXPECT_NEAR(scene.seabed_range_mm({{0, 0, 0}, {0, -std::sin(below), std::cos(below)}}),
                1500.0 / std::sin(rad_from_deg(1.0)), 1e-6);
}

TEST(Scene, TheLightStepsAndTheSeabedsTakeTurns) {
    const Scene scene(profile_of("default?step=0.4&swap=2"));
    EXPECT_EQ(scene.light(1.0), 1.0);
    EXPECT_DOUBLE_EQ(scene.light(4.0), 0.6);
    EXPECT_EQ(scene.light(7.0), 1.0);
    EXPECT_EQ(scene.seabed_at(1.0), 0);
    EXPECT_EQ(scene.seabed_at(3.0), 1);
    EXPECT_EQ(scene.seabed_at(5.0), 0);
    const Ray down{{0, 0, 0}, Eigen::Vector3d(0.0, 1.0, 0.3).normalized()};
    EXPECT_NE(scene.seabed<float>(0, down, 1500.0, 0.0), scene.seabed<float>(1, down, 1500.0, 0.0));
    const Scene still(profile_of("default"));
    EXPECT_EQ(still.light(4.0), 1.0);
    EXPECT_EQ(still.seabed_at(100.0), 0);
    EXPECT_EQ(still.blur_px(1.0), 0.0);
}

TEST(Blur, KeepsTheLightAndSpreadsAPointAsItsWidthSays) {
    constexpr int side = 61;
    std::vector<float> grey(side * side, 0.0F);
    grey[30 * side + 30] = 1000.0F;
    blur(grey.data(), side, std::vector<double>(side, 2.5));
    double sum = 0.0;
    double squares = 0.0;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const double value = grey[static_cast<std::size_t>(y * side + x)];
            sum += value;
            squares += value * (x - 30) * (x - 30);
        }
    }
    EXPECT_NEAR(sum, 1000.0, 0.01);
    EXPECT_NEAR(std::sqrt(squares / sum), 2.5, 0.05);
    std::vector<float> flat(side * side, 90.0F);
    blur(flat.data(), side, std::vector<double>(side, 3.0));
    EXPECT_NEAR(*std::min_element(flat.begin(), flat.end()), 90.0F, 1e-3F);
}

TEST(Blur, TreatsTheChannelsApart) {
    constexpr int width = 20;
    constexpr int height = 9;
    std::vector<Colour> colours;
    std::vector<float> channels[3];
    for (int i = 0; i < width * height; ++i) {
        const Colour colour(static_cast<float>(i % 7), static_cast<float>(i % 11),
                            static_cast<float>(i % 13));
        colours.push_back(colour);
        for (int c = 0; c < 3; ++c) {
            channels[c].push_back(colour[c]);
        }
    }
    std::vector<double> sigmas_px;
    for (int y = 0; y < height; ++y) {
        sigmas_px.push_back(0.5 + 0.4 * y);
    }
    blur(colours.data(), width, sigmas_px);
    for (int c = 0; c < 3; ++c) {
        blur(channels[c].data(), width, sigmas_px);
        for (std::size_t i = 0; i < colours.size(); ++i) {
            ASSERT_EQ(colours[i][c], channels[c][i]) << i;
        }
    }
}

TEST(Scene, ParticlesDriftSteadilyInsideTheirBox) {
    const Scene scene(profile_of("default?particles=200"));
    ASSERT_EQ(scene.particles().size(), 200U);
    int wrapped = 0;
    for (const Particle& particle : scene.particles()) {
        for (const double t : {0.0, 7.0, 300.0}) {
            const Vector3d place = scene.particle_place_mm(particle, t);
            EXPECT_GT(place.z(), 400.0);
            EXPECT_LT(place.z(), 2700.0);
            const Vector3d moved = scene.particle_place_mm(particle, t + 0.01) - place;
            if (moved.norm() > 100.0) {
                ++wrapped;  // it left the box on one side and came in on the other
            } else {
                EXPECT_LT((moved - 0.01 * particle.drift_mm_s).norm(), 1e-9);
            }
        }
    }
    EXPECT_LT(wrapped, 10);
}

}  // namespace
}  // namespace kambara
