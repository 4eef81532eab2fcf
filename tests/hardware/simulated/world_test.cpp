// SPDX-License-Identifier: GPL-3.0-or-later
#include "hardware/simulated/simulated_world.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <array>
#include <cmath>
#include <thread>
#include <vector>

namespace kambara {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

SimulatedProfile profile_of(std::string_view text) {
    return simulated_profile(text).value();
}

TEST(SimulatedWorld, AFrameIsTheSameInAnyOrderInstanceAndThread) {
    for (const char* text : {"default", "chessboard"}) {
        SCOPED_TRACE(text);
        const SimulatedWorld one(profile_of(text));
        const SimulatedWorld other(profile_of(text));
        constexpr std::array<std::int64_t, 4> frames{0, 29, 31, 700};
        std::array<Image, 4> forward;
        std::array<Image, 4> backward;
        const HeadAngles aside{0.3, -0.2};
        std::thread worker([&] {
            for (std::size_t i = frames.size(); i-- > 0;) {
                backward[i] = one.picture(FixedCamera::right, frames[i]);
            }
        });
        for (std::size_t i = 0; i < frames.size(); ++i) {
            forward[i] = one.picture(FixedCamera::right, frames[i]);
        }
        worker.join();
        for (std::size_t i = 0; i < frames.size(); ++i) {
            EXPECT_EQ(forward[i], backward[i]) << frames[i];
        }
        EXPECT_EQ(forward[2], other.picture(FixedCamera::right, frames[2]));
        EXPECT_EQ(one.pan_tilt_picture(5, aside), other.pan_tilt_picture(5, aside));
    }
}

// Mean absolute difference of two pictures, grey levels.
double difference(const Image& a, const Image& b) {
    double sum = 0.0;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            sum += std::abs(a.at(x, y) - b.at(x, y));
        }
    }
    return sum / (a.width() * a.height());
}

TEST(SimulatedWorld, AnotherSeedIsAnotherWorld) {
    const SimulatedWorld one(profile_of("default?noise=0&particles=0"));
    const SimulatedWorld two(profile_of("default?noise=0&particles=0&seed=2"));
    EXPECT_GT(difference(one.picture(FixedCamera::left, 0), two.picture(FixedCamera::left, 0)),
              5.0);
    EXPECT_GT((one.T_left_from_target(0).t_mm - two.T_left_from_target(0).t_mm).norm(), 10.0);
}

TEST(SimulatedWorld, NoiseIsWhiteGaussianAndNewInEveryFrame) {
    // A still scene, so that frames differ by their noise only.
    const SimulatedWorld still(profile_of("chessboard?noise=0&particles=0"));
    const SimulatedWorld noisy(profile_of("chessboard?noise=3&particles=0"));
    const Image clean = still.picture(FixedCamera::left, 3);
    const auto noise_of = [&](std::int64_t frame) {
        std::vector<double> noise;
        const Image picture = noisy.picture(FixedCamera::left, frame);
        for (int y = 0; y < clean.height(); ++y) {
            for (int x = 0; x < clean.width(); ++x) {
                noise.push_back(picture.at(x, y) - clean.at(x, y));
            }
        }
        return noise;
    };
    const auto correlation = [](const std::vector<double>& a, const std::vector<double>& b,
                                std::size_t apart) {
        double sum = 0.0;
        for (std::size_t i = 0; i + apart < a.size(); ++i) {
            sum += a[i] * b[i + apart];
        }
        return sum / static_cast<double>(a.size() - apart);
    };
    const auto noise = noise_of(3);
    double mean = 0.0;
    double fourth = 0.0;
    for (const double n : noise) {
        mean += n / static_cast<double>(noise.size());
        fourth += n * n * n * n / static_cast<double>(noise.size());
    }
    const double variance = correlation(noise, noise, 0);
    EXPECT_NEAR(mean, 0.0, 0.03);
    // Both pictures are rounded, each by a variance of 1/12.
    EXPECT_NEAR(std::sqrt(variance - 2.0 / 12.0), 3.0, 0.03);
    EXPECT_NEAR(fourth / (variance * variance), 3.0, 0.1);
    EXPECT_NEAR(correlation(noise, noise, 1) / variance, 0.0, 0.01);
    EXPECT_NEAR(correlation(noise, noise, 640) / variance, 0.0, 0.01);
    EXPECT_NEAR(correlation(noise, noise_of(4), 0) / variance, 0.0, 0.01);
}

// Grey level between pixels, bilinear.
double sample(const Image& picture, const Vector2d& at) {
    const int x = static_cast<int>(std::floor(at.x()));
    const int y = static_cast<int>(std::floor(at.y()));
    const double a = at.x() - x;
    const double b = at.y() - y;
    return (1 - b) * ((1 - a) * picture.at(x, y) + a * picture.at(x + 1, y)) +
           b * ((1 - a) * picture.at(x, y + 1) + a * picture.at(x + 1, y + 1));
}

// How far the picture `b` is off from where the truth says its patch of the target is, px: the
// least-squares shift, with the grey levels' gain and offset free.
Vector2d misplacement(const SimulatedWorld& world, const Image& a, std::int64_t frame_a,
                      const Image& b, const Camera& camera_b, std::int64_t frame_b) {
    const Rectangle patch = world.suggested_template(31, frame_a);
    Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
    Eigen::Vector4d right_side = Eigen::Vector4d::Zero();
    const RigidTransform T_rig_from_left = world.rig().left.T_camera_from_rig.inverse();
    for (int y = patch.y; y < patch.y + patch.height; ++y) {
        for (int x = patch.x; x < patch.x + patch.width; ++x) {
            const auto on_target = world.target_point_under(Vector2d(x, y), frame_a);
            const Vector3d point =
                T_rig_from_left * world.point_in_left_mm(on_target.value(), frame_b);
            const Vector2d at = camera_b.project(point).value();
            const Vector2d dx(0.5, 0.0);
            const Vector2d dy(0.0, 0.5);
            const Eigen::Vector4d row(sample(b, at + dx) - sample(b, at - dx),
                                      sample(b, at + dy) - sample(b, at - dy), sample(b, at), 1.0);
            normal += row * row.transpose();
            right_side += row * static_cast<double>(a.at(x, y));
        }
    }
    const Eigen::Vector4d solution = normal.inverse() * right_side;
    return solution.head<2>() / solution[2];
}

TEST(SimulatedWorld, PicturesShowTheTargetWhereTheTruthSaysItIs) {
    for (const char* text : {"default?noise=0&particles=0", "default?noise=0&particles=0&seed=4",
                             "default?noise=0&particles=0&medium=water"}) {
        SCOPED_TRACE(text);
        const SimulatedWorld world(profile_of(text));
        const Rig& rig = world.rig();
        const Image first = world.picture(FixedCamera::left, 0);
        for (const std::int64_t frame : {0, 60, 170, 400}) {
            const Vector2d in_left = misplacement(
                world, first, 0, world.picture(FixedCamera::left, frame), rig.left, frame);
            const Vector2d in_right = misplacement(
                world, first, 0, world.picture(FixedCamera::right, frame), *rig.right, frame);
            EXPECT_LT(in_left.norm(), 0.03) << frame;
            EXPECT_LT(in_right.norm(), 0.03) << frame;
        }
    }
}

TEST(SimulatedWorld, PointsOfTheTargetAreFollowed) {
    const SimulatedWorld world(profile_of("default"));
    const Rectangle rectangle = world.suggested_template(31, 12);
    EXPECT_EQ(rectangle.width, 31);
    const Vector2d centre_px(rectangle.centre_x_px(), rectangle.centre_y_px());
    const Vector2d on_target = world.target_point_under(centre_px, 12).value();
    EXPECT_LT(on_target.norm(), 5.0) << "half a pixel off the target's centre at most";
    const auto again = project(world.rig().left.lens, world.point_in_left_mm(on_target, 12));
    EXPECT_LT((*again - centre_px).norm(), 1e-9);
    EXPECT_FALSE(world.target_point_under({5.0, 5.0}, 12));
}

}  // namespace
}  // namespace kambara
