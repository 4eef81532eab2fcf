// SPDX-License-Identifier: GPL-3.0-or-later
// Simulated pictures against a plain ray caster, the rig's projection, and OpenCV's corners.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "core/image/opencv_view.h"
#include "core/pointing/aim.h"
#include "hardware/simulated/simulated_world.h"

namespace kambara {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

SimulatedProfile profile_of(std::string_view text) {
    return simulated_profile(text).value();
}

// One ray through the exact lens, in double precision.
double cast(const Scene& scene, const Camera& camera, const Vector2d& pixel, double time_s) {
    const Lighting<float> sunlight(scene.water());
    const Ray ray = camera.unproject(pixel).value();
    const RigidTransform T_rig_from_target = scene.T_rig_from_target(time_s);
    const Ray in_target = T_rig_from_target.inverse() * ray;
    const double range = -in_target.origin_mm.z() / in_target.direction.z();
    const double half = Scene::target_half_side_mm;
    const Vector3d at = in_target.at(range);
    if (range > 0.0 && at.head<2>().cwiseAbs().maxCoeff() < half) {
        return sunlight.seen(scene.surface<float>(0, static_cast<float>(at.x() + half),
                                                  static_cast<float>(at.y() + half)),
                             pixel.x(), pixel.y(), range);
    }
    const double bed = scene.seabed_range_mm(ray);
    return bed == Scene::no_seabed
               ? sunlight.endless(pixel.x(), pixel.y())
               : sunlight.seen(scene.seabed<float>(0, ray, bed, 0.0), pixel.x(), pixel.y(), bed);
}

// The mean over a pixel's area of very many rays.
double plain_pixel(const Scene& scene, const Camera& camera, int x, int y, double time_s) {
    constexpr int n = 24;
    double sum = 0.0;
    for (int i = 0; i < n * n; ++i) {
        const Vector2d within((i % n + 0.5) / n - 0.5, (i / n + 0.5) / n - 0.5);
        sum += cast(scene, camera, Vector2d(x, y) + within, time_s);
    }
    return sum / (n * n);
}

TEST(SimulatedPicture, IsTheMeanOverEveryPixelsArea) {
    const SimulatedProfile profile = profile_of("default?noise=0&particles=0");
    const SimulatedWorld world(profile);
    const Scene scene(profile);
    constexpr std::int64_t frame = 47;
    const double time_s = static_cast<double>(frame) / profile.rate_hz;
    for (const FixedCamera which : {FixedCamera::left, FixedCamera::right}) {
        const Camera& camera = which == FixedCamera::left ? world.rig().left : *world.rig().right;
        const Image picture = world.picture(which, frame);
        // Across the target and beyond its edges.
        const Vector2d centre = camera.project(scene.T_rig_from_target(time_s).t_mm).value();
        double worst = 0.0;
        double squares = 0.0;
        int count = 0;
        for (int y = -60; y <= 60; y += 12) {
            for (int x = -70; x <= 70; ++x) {
                const int px = static_cast<int>(centre.x()) + x;
                const int py = static_cast<int>(centre.y()) + y;
                const double error =
                    picture.at(px, py) - plain_pixel(scene, camera, px, py, time_s);
                worst = std::max(worst, std::abs(error));
                squares += error * error;
                ++count;
            }
        }
        EXPECT_LT(std::sqrt(squares / count), 0.6) << "rounding alone is 0.29";
        EXPECT_LT(worst, 6.0) << "at the target's edge, where 16 rays are few";
    }
}

TEST(SimulatedPicture, TheFarSeabedDoesNotAlias) {
    // Without haze nothing hides the bed's texture where many of its grains fall into one pixel.
    const SimulatedProfile profile = profile_of("default?noise=0&particles=0&haze=0");
    const SimulatedWorld world(profile);
    const Scene scene(profile);
    const Camera& camera = world.rig().left;
    const Image picture = world.picture(FixedCamera::left, 0);
    for (const auto& [row, tolerance] : {std::pair{470, 1.0}, {330, 2.5}, {200, 4.0}}) {
        double squares = 0.0;
        double mean = 0.0;
        constexpr int count = 60;
        for (int x = 5; x < 5 + count; ++x) {
            const double error = picture.at(x, row) - plain_pixel(scene, camera, x, row, 0.0);
            squares += error * error / count;
            mean += error / count;
        }
        EXPECT_LT(std::sqrt(squares), tolerance) << "row " << row;
        EXPECT_NEAR(mean, 0.0, 0.6) << "row " << row;
    }
}

// Corners as OpenCV finds them, or none.
std::vector<cv::Point2f> found_corners(const Image& picture, const ChessboardTarget& board) {
    std::vector<cv::Point2f> corners;
    const cv::Mat view = opencv_view(picture);
    if (cv::findChessboardCorners(view, {board.corners_across, board.corners_down}, corners)) {
        cv::cornerSubPix(view, corners, {5, 5}, {-1, -1},
                         {cv::TermCriteria::EPS + cv::TermCriteria::COUNT, 100, 1e-4});
    }
    return corners;
}

// The found corner nearest to where the projection puts one; OpenCV may number them backwards.
Vector2d nearest(const std::vector<cv::Point2f>& found, const Vector2d& expected) {
    Vector2d best(1e9, 1e9);
    for (const cv::Point2f& corner : found) {
        const Vector2d at(corner.x, corner.y);
        if ((at - expected).norm() < (best - expected).norm()) {
            best = at;
        }
    }
    return best;
}

TEST(SimulatedPicture, ChessboardCornersAreWhereTheRigProjectsThem) {
    const ChessboardTarget board{9, 6, 30.0};
    const SimulatedWorld world(profile_of("chessboard?noise=0&particles=0"));
    const RigidTransform T_rig_from_left = world.rig().left.T_camera_from_rig.inverse();
    for (const FixedCamera which : {FixedCamera::left, FixedCamera::right}) {
        const Camera& camera = which == FixedCamera::left ? world.rig().left : *world.rig().right;
        double squares = 0.0;
        Vector2d bias = Vector2d::Zero();
        int count = 0;
        for (int pose = 0; pose < 8; ++pose) {
            const std::int64_t frame = 30 * pose;
            const auto found = found_corners(world.picture(which, frame), board);
            if (found.empty()) {
                continue;
            }
            for (const Vector3d& corner : corners_in_target_mm(board)) {
                const Vector3d in_rig =
                    T_rig_from_left * (world.T_left_from_target(frame) * corner);
                const Vector2d expected = camera.project(in_rig).value();
                const Vector2d error = nearest(found, expected) - expected;
                squares += error.squaredNorm();
                bias += error;
                ++count;
            }
        }
        ASSERT_GE(count, 6 * 54) << "most poses must be found";
        EXPECT_LT(std::sqrt(squares / count), 0.1);
        EXPECT_LT(bias.norm() / count, 0.02);
    }
}

TEST(SimulatedPicture, AHeadAimedAtAPointHasItInThePicturesMiddle) {
    const ChessboardTarget board{5, 5, 30.0};
    const SimulatedWorld world(
        profile_of("chessboard?target=chessboard:5x5:30&noise=0&particles=0&haze=0"));
    int found_in = 0;
    for (int pose = 0; pose < 6; ++pose) {
        const std::int64_t frame = 30 * pose;
        const Vector3d middle = world.T_left_from_target(frame) * corners_in_target_mm(board)[12];
        const Image picture = world.pan_tilt_picture(frame, angles_towards(world.rig(), middle));
        const auto found = found_corners(picture, board);
        if (!found.empty()) {
            ++found_in;
            EXPECT_LT((nearest(found, {319.5, 239.5}) - Vector2d(319.5, 239.5)).norm(), 0.15);
        }
    }
    EXPECT_GE(found_in, 4);
}

TEST(SimulatedPicture, ZoomedInThingsAreLargerAboutTheMiddle) {
    const ChessboardTarget board{5, 5, 30.0};
    const SimulatedWorld world(
        profile_of("chessboard?target=chessboard:5x5:30&noise=0&particles=0&haze=0"));
    int found_in = 0;
    for (int pose = 0; pose < 6; ++pose) {
        const std::int64_t frame = 30 * pose;
        const Vector3d middle = world.T_left_from_target(frame) * corners_in_target_mm(board)[12];
        const HeadAngles there = angles_towards(world.rig(), middle);
        const auto wide = found_corners(world.pan_tilt_picture(frame, there), board);
        const auto tele = found_corners(world.pan_tilt_picture(frame, there, 2.0), board);
        if (wide.empty() || tele.empty()) {
            continue;
        }
        ++found_in;
        const Vector2d axis(319.5, 239.5);
        for (const cv::Point2f& corner : wide) {
            const Vector2d expected = axis + 2.0 * (Vector2d(corner.x, corner.y) - axis);
            EXPECT_LT((nearest(tele, expected) - expected).norm(),
                      0.5);  // twice the wide one's error
        }
    }
    EXPECT_GE(found_in, 3);
}

// Where a lone speck is in the difference of two pictures: its centroid near where it should be.
std::optional<Vector2d> speck(const Image& with, const Image& without, const Vector2d& expected) {
    const int cx = static_cast<int>(std::lround(expected.x()));
    const int cy = static_cast<int>(std::lround(expected.y()));
    constexpr int reach = 8;
    if (!with.contains(cx - reach, cy - reach) || !with.contains(cx + reach, cy + reach)) {
        return std::nullopt;
    }
    Vector2d sum = Vector2d::Zero();
    double weight = 0.0;
    for (int y = cy - reach; y <= cy + reach; ++y) {
        for (int x = cx - reach; x <= cx + reach; ++x) {
            const double grey = with.at(x, y) - without.at(x, y);
            sum += grey * Vector2d(x, y);
            weight += grey;
        }
    }
    if (std::abs(weight) < 20.0) {
        return std::nullopt;
    }
    return Vector2d(sum / weight);
}

TEST(SimulatedPicture, ParticlesArePointsInSpaceForBothCameras) {
    // Still scenes that differ by one speck only; it drifts through them.
    const SimulatedProfile profile = profile_of("chessboard?noise=0&haze=0&particles=1");
    const SimulatedWorld with(profile);
    const SimulatedWorld without(profile_of("chessboard?noise=0&haze=0&particles=0"));
    const Scene scene(profile);
    const Rig& rig = with.rig();
    int seen = 0;
    for (std::int64_t frame = 0; frame < 4000 && seen < 5; frame += 60) {
        const double time_s = static_cast<double>(frame) / profile.rate_hz;
        const Vector3d place = scene.particle_place_mm(scene.particles().front(), time_s);
        const auto in_left = rig.left.project(place);
        const auto in_right = rig.right->project(place);
        if (!in_left || !in_right || !rig.left.sees(*in_left) || !rig.right->sees(*in_right)) {
            continue;
        }
        const auto left = speck(with.picture(FixedCamera::left, frame),
                                without.picture(FixedCamera::left, frame), *in_left);
        const auto right = speck(with.picture(FixedCamera::right, frame),
                                 without.picture(FixedCamera::right, frame), *in_right);
        if (left && right) {
            ++seen;
            EXPECT_LT((*left - *in_left).norm(), 0.25) << frame;
            EXPECT_LT((*right - *in_right).norm(), 0.25) << frame;
        }
    }
    EXPECT_EQ(seen, 5);
}

TEST(SimulatedPicture, WhatIsBehindTheTargetIsHidden) {
    const SimulatedProfile profile = profile_of("default?noise=0&particles=3000");
    const SimulatedWorld with(profile);
    const SimulatedWorld without(profile_of("default?noise=0&particles=0"));
    const Scene scene(profile);
    const Camera& camera = with.rig().left;
    const RigidTransform T_target_from_rig = scene.T_rig_from_target(0.0).inverse();
    const Image full = with.picture(FixedCamera::left, 0);
    const Image clear = without.picture(FixedCamera::left, 0);
    // Every change of the target's picture must come from a speck in front of it.
    std::vector<Vector2d> in_front;
    int behind = 0;
    for (const Particle& particle : scene.particles()) {
        const Vector3d place = scene.particle_place_mm(particle, 0.0);
        const auto pixel = camera.project(place);
        if (pixel && (T_target_from_rig * place).z() < 0.0) {
            in_front.push_back(*pixel);
        } else if (pixel && with.target_point_under(*pixel, 0)) {
            ++behind;
        }
    }
    ASSERT_GT(behind, 10);
    int unexplained = 0;
    int looked_at = 0;
    for (int y = 0; y < full.height(); ++y) {
        for (int x = 0; x < full.width(); ++x) {
            const auto on_target = with.target_point_under(Vector2d(x, y), 0);
            const bool well_inside = on_target && on_target->cwiseAbs().maxCoeff() < 140.0;
            const bool free = std::none_of(in_front.begin(), in_front.end(), [&](const auto& at) {
                return (at - Vector2d(x, y)).norm() < 12.0;
            });
            if (well_inside && free) {
                ++looked_at;
                unexplained += full.at(x, y) != clear.at(x, y) ? 1 : 0;
            }
        }
    }
    EXPECT_GT(looked_at, 100);
    EXPECT_EQ(unexplained, 0);
}

}  // namespace
}  // namespace kambara
