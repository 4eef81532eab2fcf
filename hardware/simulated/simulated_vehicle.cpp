// SPDX-License-Identifier: GPL-3.0-or-later
#include "hardware/simulated/simulated_vehicle.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "hardware/simulated/camera_tilt.h"

namespace kambara {
namespace {

constexpr std::int64_t sample_ns = 10'000'000;

class SimulatedFeed final : public VehicleFeed {
  public:
    explicit SimulatedFeed(const SimulatedProfile& profile)
        : profile_(profile), vehicle_(profile), random_(profile.seed * 7907U + 11U) {}

    std::vector<VehicleMotion> take(std::int64_t now_ns) override {
        std::vector<VehicleMotion> come;
        const auto delay_ns = static_cast<std::int64_t>(profile_.feed_delay_s * 1e9);
        for (; next_ns_ <= now_ns - delay_ns; next_ns_ += sample_ns) {
            VehicleMotion motion = vehicle_.motion(next_ns_);
            for (int i = 0; i < 3; ++i) {
                motion.turn_rad_s[i] += profile_.feed_turn_noise_rad_s * normal_(random_);
                motion.velocity_mm_s[i] += profile_.feed_velocity_noise_mm_s * normal_(random_);
            }
            come.push_back(motion);
        }
        return come;
    }

  private:
    const SimulatedProfile profile_;
    const SimulatedVehicle vehicle_;
    std::mt19937 random_;
    std::normal_distribution<double> normal_;
    std::int64_t next_ns_ = -200'000'000;  // it was there before the cameras
};

}  // namespace

RigidTransform SimulatedVehicle::T_rig_from_world(double time_s) const {
    const double rate = 2.0 * std::numbers::pi / profile_.turn_period_s;
    const double yaw = profile_.turn_rad_s / rate * std::sin(rate * time_s);
    const Eigen::Matrix3d R_world_from_rig = Eigen::AngleAxisd(yaw, down_in_rig).toRotationMatrix();
    const Eigen::Vector3d place(profile_.sway_mm_s / rate * std::sin(rate * time_s), 0.0, 0.0);
    return RigidTransform{R_world_from_rig, place}.inverse();
}

VehicleMotion SimulatedVehicle::motion(std::int64_t time_ns) const {
    const double time_s = static_cast<double>(time_ns) * 1e-9;
    const double rate = 2.0 * std::numbers::pi / profile_.turn_period_s;
    const double swing = std::cos(rate * time_s);
    VehicleMotion motion;
    motion.time_ns = time_ns;
    motion.turn_rad_s = profile_.turn_rad_s * swing * down_in_rig;
    motion.velocity_mm_s =
        T_rig_from_world(time_s).R * Eigen::Vector3d(profile_.sway_mm_s * swing, 0.0, 0.0);
    motion.turn_sigma_rad_s = profile_.feed_turn_noise_rad_s;
    motion.velocity_sigma_mm_s = profile_.feed_velocity_noise_mm_s;
    return motion;
}

std::unique_ptr<VehicleFeed> make_simulated_feed(const SimulatedProfile& profile) {
    if (!profile.feed || !SimulatedVehicle(profile).moves()) {
        return nullptr;
    }
    return std::make_unique<SimulatedFeed>(profile);
}

}  // namespace kambara
