// SPDX-License-Identifier: GPL-3.0-or-later
// A head at the end of a slow line that follows a target which goes round on a circle, on time that
// is told: camera, predictor, aim, driver, 9600 baud, motors.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <numbers>
#include <random>
#include <vector>

#include "core/camera/nominal_rig.h"
#include "core/pointing/aim.h"
#include "core/pointing/steering.h"
#include "core/stereo/position.h"
#include "core/tracking/predictor.h"
#include "hardware/visca/faulty_line.h"
#include "hardware/visca/head_driver.h"
#include "tests/hardware/visca/simulated_link.h"

namespace kambara::visca {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double pixel_noise_px = 0.1;
constexpr double speed_mm_s = 300.0;
constexpr std::int64_t ms = 1'000'000;
constexpr std::int64_t frame_ns = 33'333'333;
constexpr std::int64_t arrives_after_ns = 20 * ms;  // exposure to the tracker's result

struct Outcome {
    double share_within_0_8_deg = 0.0;
    double at_95_deg = 0.0;
    double worst_deg = 0.0;
    double oldest_aim_s = 0.0;
    double rms_acceleration_deg_s2 = 0.0;  // of the head, both axes
    bool within_limits = true;
};

Outcome follow_circle(double radius_mm, bool leads, double seconds, bool paces = true) {
    const Rig rig = nominal_rig();
    const Eigen::Vector3d middle_in_rig(225.0, 350.0, 1500.0);
    const auto truth = [&](std::int64_t time_ns) {
        const double turned = speed_mm_s * 1e-9 * static_cast<double>(time_ns) / radius_mm;
        return Vector3d(
            rig.left.T_camera_from_rig *
            (middle_in_rig + radius_mm * Vector3d(std::cos(turned), std::sin(turned), 0.0)));
    };
    const RigidTransform T_rig_from_left = rig.left.T_camera_from_rig.inverse();
    ManualClock clock(1'000 * ms);
    HeadQueue queue;
    HeadDriver::Options options;
    options.heads = built_in_heads();
    options.session.byte_ns = byte_time_ns(9600);
    options.paces = paces;
    SimulatedLine line(clock.now_ns());
    SimulatedLink link(clock, line);
    HeadDriver driver(link, queue, clock, options);
    Predictor predictor;
    Steering steering({}, HeadLimits{});
    std::optional<HeadAngles> commanded;
    std::mt19937 random(5);
    std::normal_distribution<double> noise(0.0, pixel_noise_px);
    const std::int64_t start_ns = clock.now_ns();
    const auto end_ns = start_ns + static_cast<std::int64_t>(seconds * 1e9);
    std::int64_t exposed_ns = start_ns;
    std::int64_t looked_ns = start_ns;
    std::int64_t placed_ns = start_ns;
    std::vector<double> errors_deg;
    std::vector<Vector2d> places_deg;  // every 10 ms
    Outcome outcome;
    while (clock.now_ns() < end_ns) {
        driver.step();
        const std::int64_t now_ns = clock.now_ns();
        if (now_ns >= exposed_ns + arrives_after_ns) {
            const Vector3d in_rig = T_rig_from_left * truth(exposed_ns);
            const Vector2d off_left(noise(random), noise(random));
            const Vector2d off_right(noise(random), noise(random));
            const Eigen::Matrix2d covariance =
                pixel_noise_px * pixel_noise_px * Eigen::Matrix2d::Identity();
            const auto position =
                position_from_pair(rig, {*rig.left.project(in_rig) + off_left, covariance},
                                   {*rig.right->project(in_rig) + off_right, covariance});
            if (!position) {
                ADD_FAILURE() << position.error().text();
                return outcome;
            }
            predictor.update(exposed_ns, position->point_in_left_mm, position->covariance_mm2);
            HeadAim aim{angles_towards(rig, position->point_in_left_mm), {}, now_ns, now_ns};
            if (leads && predictor.has_velocity()) {
                const std::int64_t pictured_ns = exposed_ns + (now_ns - exposed_ns);
                aim = *led_aim(
                    rig, [&](std::int64_t time_ns) { return predictor.at(time_ns); }, pictured_ns,
                    now_ns, driver.lag_s());
            }
            if (const auto command = steering.command_for(aim.angles, commanded, exposed_ns)) {
                commanded = aim.angles = *command;
                queue.put(Motion{Motion::Kind::look, aim.angles, {}, false, aim});
            }
            exposed_ns += frame_ns;
        }
        if (now_ns >= looked_ns + 2 * ms) {
            looked_ns = now_ns;
            const auto state = line.camera.state();
            const HeadAngles looks{rad_from_deg(state.pan_steps / 8.8),
                                   rad_from_deg(state.tilt_steps / 12.0)};
            outcome.within_limits = outcome.within_limits && std::abs(state.pan_steps) <= 880.0 &&
                                    std::abs(state.tilt_steps) <= 300.0;
            if (now_ns > start_ns + 2'000 * ms) {
                if (now_ns >= placed_ns + 10 * ms) {
                    placed_ns = now_ns;
                    places_deg.emplace_back(deg_from_rad(looks.pan_rad),
                                            deg_from_rad(looks.tilt_rad));
                }
                errors_deg.push_back(deg_from_rad(aiming_error_rad(rig, looks, truth(now_ns))));
            }
        }
    }
    std::sort(errors_deg.begin(), errors_deg.end());
    const auto within = std::upper_bound(errors_deg.begin(), errors_deg.end(), 0.8);
    outcome.share_within_0_8_deg =
        static_cast<double>(within - errors_deg.begin()) / static_cast<double>(errors_deg.size());
    outcome.at_95_deg = errors_deg[errors_deg.size() * 95 / 100];
    outcome.worst_deg = errors_deg.back();
    double square_sum = 0.0;
    for (std::size_t i = 2; i < places_deg.size(); ++i) {
        constexpr double step_s = 0.01;
        const Vector2d acceleration =
            (places_deg[i] - 2.0 * places_deg[i - 1] + places_deg[i - 2]) / (step_s * step_s);
        square_sum += acceleration.squaredNorm();
    }
    outcome.rms_acceleration_deg_s2 =
        std::sqrt(square_sum / static_cast<double>(places_deg.size() - 2));
    outcome.oldest_aim_s = driver.oldest_aim_s();
    return outcome;
}

TEST(Following, ATargetOnACircleIsKeptInTheMiddle) {
    for (const double radius_mm : {150.0, 250.0, 350.0, 500.0}) {
        const Outcome with = follow_circle(radius_mm, true, 30.0);
        const Outcome without = follow_circle(radius_mm, false, 30.0);
        std::printf(
            "radius %.2f m: 95 %% within %.2f degrees, worst %.2f, oldest aim %.1f ms; "
            "without prediction 95 %% within %.2f, worst %.2f\n",
            1e-3 * radius_mm, with.at_95_deg, with.worst_deg, 1e3 * with.oldest_aim_s,
            without.at_95_deg, without.worst_deg);
        EXPECT_GE(with.share_within_0_8_deg, 0.95) << radius_mm;
        EXPECT_LE(with.worst_deg, 1.5) << radius_mm;
        EXPECT_LE(with.oldest_aim_s, 0.050) << radius_mm;
        EXPECT_GT(with.oldest_aim_s, 0.0) << radius_mm;
        EXPECT_TRUE(with.within_limits) << radius_mm;
        EXPECT_GT(without.at_95_deg, 1.3 * with.at_95_deg) << radius_mm;
    }
}

// Each aim at full speed makes the head start and stop thirty times a second.
TEST(Following, TheHeadTurnsSmoothly) {
    for (const double radius_mm : {150.0, 250.0, 350.0, 500.0}) {
        const Outcome with = follow_circle(radius_mm, true, 30.0);
        const Outcome without = follow_circle(radius_mm, true, 30.0, false);
        std::printf(
            "radius %.2f m: acceleration %.0f degrees/s^2 (RMS), 95 %% within %.2f degrees, worst "
            "%.2f; each aim at full speed: %.0f, %.2f, %.2f\n",
            1e-3 * radius_mm, with.rms_acceleration_deg_s2, with.at_95_deg, with.worst_deg,
            without.rms_acceleration_deg_s2, without.at_95_deg, without.worst_deg);
        EXPECT_LT(with.rms_acceleration_deg_s2, 0.6 * without.rms_acceleration_deg_s2) << radius_mm;
    }
}

}  // namespace
}  // namespace kambara::visca
