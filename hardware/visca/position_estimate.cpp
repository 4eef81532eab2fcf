// SPDX-License-Identifier: GPL-3.0-or-later
#include "hardware/visca/position_estimate.h"

#include <algorithm>
#include <cmath>

namespace kambara::visca {
namespace {

// Speeds are not known so exactly, nor the times of readings.
constexpr double speed_slack = 1.3;
constexpr double angle_slack_rad = rad_from_deg(3.0);

double towards(double from, double to, double reach) {
    return from + std::clamp(to - from, -reach, reach);
}

}  // namespace

void PositionEstimate::set_speeds(double pan_rad_s, double tilt_rad_s) {
    pan_speed_rad_s_ = pan_rad_s;
    tilt_speed_rad_s_ = tilt_rad_s;
}

void PositionEstimate::set_target(const std::optional<HeadAngles>& target, std::int64_t time_ns) {
    if (reading_) {
        reading_ = Reading{moved_on(time_ns), std::max(time_ns, reading_->time_ns)};
    }
    target_ = target;
    pursuit_rad_s_ = {pan_speed_rad_s_, tilt_speed_rad_s_};
    drive_.reset();
    since_ns_ = time_ns;
}

void PositionEstimate::set_target(const HeadAngles& target, const HeadAngles& speed_rad_s,
                                  std::int64_t time_ns) {
    set_target(target, time_ns);
    pursuit_rad_s_ = speed_rad_s;
}

void PositionEstimate::set_drive(double pan_rad_s, double tilt_rad_s, std::int64_t time_ns) {
    set_target(std::nullopt, time_ns);
    drive_ = HeadAngles{pan_rad_s, tilt_rad_s};
}

bool PositionEstimate::reachable(const Reading& from, const Reading& to) const {
    const double passed_s = static_cast<double>(std::abs(to.time_ns - from.time_ns)) * 1e-9;
    const auto within = [&](double a, double b, double speed) {
        return std::abs(a - b) <= speed_slack * speed * passed_s + angle_slack_rad;
    };
    return within(from.angles.pan_rad, to.angles.pan_rad, pan_speed_rad_s_) &&
           within(from.angles.tilt_rad, to.angles.tilt_rad, tilt_speed_rad_s_);
}

bool PositionEstimate::add_reading(const HeadAngles& angles, std::int64_t time_ns) {
    const Reading now{angles, time_ns};
    const bool believed =
        !reading_ || reachable(*reading_, now) || (doubtful_ && reachable(*doubtful_, now));
    if (!believed) {
        doubtful_ = now;
        return false;
    }
    doubtful_.reset();
    at_rest_ = reading_ && reading_->angles == angles;
    reading_ = now;
    return true;
}

void PositionEstimate::forget() {
    reading_.reset();
    doubtful_.reset();
    target_.reset();
    drive_.reset();
    at_rest_ = false;
}

HeadAngles PositionEstimate::moved_on(std::int64_t time_ns) const {
    const double passed_s = static_cast<double>(std::max<std::int64_t>(
                                0, time_ns - std::max(reading_->time_ns, since_ns_))) *
                            1e-9;
    const HeadAngles& from = reading_->angles;
    if (drive_) {
        return {from.pan_rad + drive_->pan_rad * passed_s,
                from.tilt_rad + drive_->tilt_rad * passed_s};
    }
    if (!target_) {
        return from;
    }
    return {towards(from.pan_rad, target_->pan_rad, pursuit_rad_s_.pan_rad * passed_s),
            towards(from.tilt_rad, target_->tilt_rad, pursuit_rad_s_.tilt_rad * passed_s)};
}

HeadStatus PositionEstimate::at(std::int64_t time_ns) const {
    const HeadAngles angles = moved_on(time_ns);
    const bool pursues = target_ && angles != *target_;
    return {angles, pursues || drive_.has_value(), std::max(time_ns, reading_->time_ns)};
}

}  // namespace kambara::visca
