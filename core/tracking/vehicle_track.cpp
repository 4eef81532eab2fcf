// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/vehicle_track.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace kambara {
namespace {

constexpr std::int64_t kept_ns = 3'000'000'000;
constexpr std::int64_t step_ns = 4'000'000;
// So long a piece of the past tells how the turn rate changes.
constexpr std::int64_t slope_span_ns = 40'000'000;
constexpr double slope_holds_s = 0.08;  // it is not believed for longer

double seconds(std::int64_t ns) {
    return static_cast<double>(ns) * 1e-9;
}

VehicleMotion mixed(const VehicleMotion& a, const VehicleMotion& b, double share_of_b) {
    VehicleMotion mix = b;
    mix.velocity_mm_s += (1.0 - share_of_b) * (a.velocity_mm_s - b.velocity_mm_s);
    mix.turn_rad_s += (1.0 - share_of_b) * (a.turn_rad_s - b.turn_rad_s);
    return mix;
}

}  // namespace

bool VehicleTrack::add(const VehicleMotion& motion) {
    const auto is_sigma = [](double sigma) { return std::isfinite(sigma) && sigma >= 0.0; };
    if (!motion.velocity_mm_s.allFinite() || !motion.turn_rad_s.allFinite() ||
        !is_sigma(motion.velocity_sigma_mm_s) || !is_sigma(motion.turn_sigma_rad_s)) {
        return false;
    }
    if (!samples_.empty() && motion.time_ns <= samples_.back().time_ns) {
        return true;
    }
    samples_.push_back(motion);
    while (samples_.front().time_ns < motion.time_ns - kept_ns) {
        samples_.pop_front();
    }
    return true;
}

VehicleMotion VehicleTrack::at(std::int64_t time_ns) const {
    const auto after = std::upper_bound(
        samples_.begin(), samples_.end(), time_ns,
        [](std::int64_t time, const VehicleMotion& sample) { return time < sample.time_ns; });
    if (after == samples_.begin()) {
        return samples_.front();
    }
    const VehicleMotion& before = *std::prev(after);
    if (after != samples_.end()) {
        const double share =
            seconds(time_ns - before.time_ns) / seconds(after->time_ns - before.time_ns);
        return mixed(before, *after, share);
    }
    // Later than the last one: a straight line through what was told of late, least squares.
    VehicleMotion onward = before;
    double mean_s = 0.0;
    int count = 0;
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (auto s = samples_.rbegin();
         s != samples_.rend() && s->time_ns >= before.time_ns - slope_span_ns; ++s) {
        mean_s += seconds(s->time_ns - before.time_ns);
        mean += s->turn_rad_s;
        ++count;
    }
    mean_s /= count;
    mean /= count;
    double spread = 0.0;
    Eigen::Vector3d slope = Eigen::Vector3d::Zero();
    for (auto s = samples_.rbegin(); count > 2 && s != samples_.rbegin() + count; ++s) {
        const double off_s = seconds(s->time_ns - before.time_ns) - mean_s;
        spread += off_s * off_s;
        slope += off_s * (s->turn_rad_s - mean);
    }
    if (spread > 0.0) {
        const double ahead_s = std::min(seconds(time_ns - before.time_ns), slope_holds_s);
        onward.turn_rad_s = mean + (ahead_s - mean_s) / spread * slope;
    }
    return onward;
}

std::optional<RigChange> VehicleTrack::between(std::int64_t then_ns, std::int64_t now_ns) const {
    if (samples_.empty() || now_ns < then_ns || then_ns < samples_.front().time_ns ||
        seconds(now_ns - samples_.back().time_ns) > stale_after_s) {
        return std::nullopt;
    }
    RigChange change;
    for (std::int64_t from_ns = then_ns; from_ns < now_ns; from_ns += step_ns) {
        const std::int64_t length_ns = std::min(step_ns, now_ns - from_ns);
        const double length_s = seconds(length_ns);
        const VehicleMotion middle = at(from_ns + length_ns / 2);
        const Eigen::Vector3d turn = -length_s * middle.turn_rad_s;
        const double angle = turn.norm();
        const Eigen::Matrix3d R = angle > 0.0
                                      ? Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix()
                                      : Eigen::Matrix3d(Eigen::Matrix3d::Identity());
        // Half the way is gone before the turn, half after it.
        const Eigen::Vector3d half_way = -0.5 * length_s * middle.velocity_mm_s;
        change.T_now_from_then =
            RigidTransform{R, R * half_way + half_way} * change.T_now_from_then;
        change.turn_sigma_rad += length_s * middle.turn_sigma_rad_s;
        change.way_sigma_mm += length_s * middle.velocity_sigma_mm_s;
    }
    return change;
}

}  // namespace kambara
