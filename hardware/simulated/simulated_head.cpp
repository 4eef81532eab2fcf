// SPDX-License-Identifier: GPL-3.0-or-later
#include "hardware/simulated/simulated_head.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace kambara {
namespace {

// The nearest whole step that is not beyond the limit.
double stepped(double angle_rad, double steps_per_deg, double limit_rad) {
    const double most = std::floor(deg_from_rad(limit_rad) * steps_per_deg + 1e-6);
    const double steps = std::round(deg_from_rad(angle_rad) * steps_per_deg);
    return rad_from_deg(std::clamp(steps, -most, most) / steps_per_deg);
}

// There to the last bit, so that the head knows that it has arrived.
double moved(double from, double to, double reach) {
    return std::abs(to - from) <= reach ? to : from + std::copysign(reach, to - from);
}

}  // namespace

SimulatedHead::SimulatedHead(std::shared_ptr<const Clock> clock, const Options& options)
    : clock_(std::move(clock)), options_(options), since_ns_(clock_->now_ns()) {}

HeadAngles SimulatedHead::angles_at(std::int64_t time_ns) const {
    const double passed_s =
        static_cast<double>(std::max<std::int64_t>(0, time_ns - since_ns_)) * 1e-9;
    return {moved(from_.pan_rad, to_.pan_rad, options_.limits.pan_speed_rad_s * passed_s),
            moved(from_.tilt_rad, to_.tilt_rad, options_.limits.tilt_speed_rad_s * passed_s)};
}

Result<Done> SimulatedHead::move_to(const HeadAngles& angles) {
    // Written so that what is not a number is refused as well.
    if (!(std::abs(angles.pan_rad) <= options_.limits.pan_rad &&
          std::abs(angles.tilt_rad) <= options_.limits.tilt_rad)) {
        return Error{"The head can't turn to pan " + std::to_string(deg_from_rad(angles.pan_rad)) +
                         ", tilt " + std::to_string(deg_from_rad(angles.tilt_rad)) + " degrees.",
                     "Keep within " + std::to_string(deg_from_rad(options_.limits.pan_rad)) +
                         " and " + std::to_string(deg_from_rad(options_.limits.tilt_rad)) +
                         " degrees."};
    }
    std::lock_guard lock(mutex_);
    const std::int64_t now_ns = clock_->now_ns();
    from_ = angles_at(now_ns);
    to_ = {stepped(angles.pan_rad, options_.pan_steps_per_deg, options_.limits.pan_rad),
           stepped(angles.tilt_rad, options_.tilt_steps_per_deg, options_.limits.tilt_rad)};
    since_ns_ = now_ns;
    return Done{};
}

Result<Done> SimulatedHead::halt() {
    std::lock_guard lock(mutex_);
    const std::int64_t now_ns = clock_->now_ns();
    from_ = angles_at(now_ns);
    to_ = from_;
    since_ns_ = now_ns;
    return Done{};
}

Result<HeadStatus> SimulatedHead::status() {
    std::lock_guard lock(mutex_);
    const std::int64_t now_ns = clock_->now_ns();
    const HeadAngles angles = angles_at(now_ns);
    return HeadStatus{angles, angles != to_, now_ns};
}

}  // namespace kambara
