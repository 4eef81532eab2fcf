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

// The fastest of so many equal speeds that is not above the wanted one, and the slowest at least.
double quantised(double speed, double fastest, int speeds) {
    if (speed == 0.0) {
        return 0.0;
    }
    const double step = fastest / speeds;
    const double steps = std::floor(std::abs(speed) / step + 1e-9);
    return std::copysign(std::clamp(steps, 1.0, static_cast<double>(speeds)) * step, speed);
}

// Where an encoder leaves its axis, which it draws along at half the play.
double carried(double axis, double encoder, double play) {
    return std::clamp(axis, encoder - 0.5 * play, encoder + 0.5 * play);
}

// Written so that what is not a number is refused as well.
Result<Done> is_share(const char* what, double share) {
    if (share >= 0.0 && share <= 1.0) {
        return Done{};
    }
    return Error{std::string("The ") + what + " can't be set to " + std::to_string(share) + ".",
                 "Give a number from 0 to 1."};
}

Result<Done> is_preset(int number) {
    if (number >= 0 && number < SimulatedHead::presets) {
        return Done{};
    }
    return Error{"There is no preset " + std::to_string(number) + ".",
                 "Give a number from 0 to " + std::to_string(SimulatedHead::presets - 1) + "."};
}

}  // namespace

double SimulatedHead::Course::at(std::int64_t time_ns) const {
    const double passed_s =
        static_cast<double>(std::max<std::int64_t>(0, time_ns - since_ns)) * 1e-9;
    // There to the last bit, so that the head knows that it has arrived.
    const double reach = speed * passed_s;
    return std::abs(to - from) <= reach ? to : from + std::copysign(reach, to - from);
}

void SimulatedHead::Course::go(double goal, double at_speed, std::int64_t now_ns) {
    from = at(now_ns);
    to = goal;
    speed = at_speed;
    since_ns = now_ns;
}

SimulatedHead::SimulatedHead(std::shared_ptr<const Clock> clock, const Options& options)
    : clock_(std::move(clock)), options_(options) {
    focus_.from = focus_.to = options_.sharp_focus;
}

HeadAngles SimulatedHead::angles_at(std::int64_t time_ns) const {
    return {pan_.at(time_ns), tilt_.at(time_ns)};
}

// A course goes one way, so that its axis is carried along from where the last one left it.
HeadAngles SimulatedHead::axes_at(std::int64_t time_ns) const {
    const HeadAngles encoders = angles_at(time_ns);
    return {carried(carried_to_.pan_rad, encoders.pan_rad, options_.backlash.pan_rad),
            carried(carried_to_.tilt_rad, encoders.tilt_rad, options_.backlash.tilt_rad)};
}

HeadAngles SimulatedHead::axes() {
    std::lock_guard lock(mutex_);
    return axes_at(clock_->now_ns());
}

void SimulatedHead::look(const HeadAngles& angles, std::int64_t now_ns) {
    carried_to_ = axes_at(now_ns);
    const HeadLimits& most = options_.limits;
    pan_.go(stepped(angles.pan_rad, options_.pan_steps_per_deg, most.pan_rad), most.pan_speed_rad_s,
            now_ns);
    tilt_.go(stepped(angles.tilt_rad, options_.tilt_steps_per_deg, most.tilt_rad),
             most.tilt_speed_rad_s, now_ns);
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
    look(angles, clock_->now_ns());
    return Done{};
}

Result<Done> SimulatedHead::halt() {
    std::lock_guard lock(mutex_);
    const std::int64_t now_ns = clock_->now_ns();
    carried_to_ = axes_at(now_ns);
    for (Course* axis : {&pan_, &tilt_}) {
        axis->go(axis->at(now_ns), 0.0, now_ns);
    }
    return Done{};
}

Result<Done> SimulatedHead::drive(double pan_rad_s, double tilt_rad_s) {
    if (!std::isfinite(pan_rad_s) || !std::isfinite(tilt_rad_s)) {
        return Error{"The head can't turn at such a speed.", "Give degrees a second."};
    }
    std::lock_guard lock(mutex_);
    const std::int64_t now_ns = clock_->now_ns();
    carried_to_ = axes_at(now_ns);
    const HeadLimits& most = options_.limits;
    const auto drive_axis = [&](Course& axis, double wanted, double fastest, int speeds,
                                double limit) {
        const double speed = quantised(wanted, fastest, speeds);
        axis.go(speed == 0.0 ? axis.at(now_ns) : std::copysign(limit, speed), std::abs(speed),
                now_ns);
    };
    drive_axis(pan_, pan_rad_s, most.pan_speed_rad_s, options_.pan_speeds, most.pan_rad);
    drive_axis(tilt_, tilt_rad_s, most.tilt_speed_rad_s, options_.tilt_speeds, most.tilt_rad);
    return Done{};
}

Result<HeadStatus> SimulatedHead::status() {
    std::lock_guard lock(mutex_);
    const std::int64_t now_ns = clock_->now_ns();
    const HeadAngles angles = angles_at(now_ns);
    return HeadStatus{angles, angles != HeadAngles{pan_.to, tilt_.to}, now_ns};
}

void SimulatedHead::zoom(double share, std::int64_t now_ns) {
    zoom_.go(share, 1.0 / options_.lens_range_s, now_ns);
}

void SimulatedHead::focus(double share, bool by_itself, std::int64_t now_ns) {
    focus_.go(share, 1.0 / options_.lens_range_s, now_ns);
    autofocus_ = by_itself;
}

Result<Done> SimulatedHead::zoom_to(double share) {
    auto possible = is_share("zoom", share);
    if (possible) {
        std::lock_guard lock(mutex_);
        zoom(share, clock_->now_ns());
    }
    return possible;
}

Result<Done> SimulatedHead::focus_to(double share) {
    auto possible = is_share("focus", share);
    if (possible) {
        std::lock_guard lock(mutex_);
        focus(share, false, clock_->now_ns());
    }
    return possible;
}

Result<Done> SimulatedHead::autofocus() {
    std::lock_guard lock(mutex_);
    focus(options_.sharp_focus, true, clock_->now_ns());
    return Done{};
}

double SimulatedHead::view_rad(double zoom_share) const {
    const double f_mm =
        options_.wide_f_mm * std::pow(options_.tele_f_mm / options_.wide_f_mm, zoom_share);
    return 2.0 * std::atan2(options_.sensor_width_mm, 2.0 * f_mm);
}

Result<LensStatus> SimulatedHead::lens() {
    std::lock_guard lock(mutex_);
    const std::int64_t now_ns = clock_->now_ns();
    const double share = zoom_.at(now_ns);
    return LensStatus{share, view_rad(share), view_rad(0.0), focus_.at(now_ns), autofocus_};
}

Result<Done> SimulatedHead::keep_preset(int number) {
    auto possible = is_preset(number);
    if (possible) {
        std::lock_guard lock(mutex_);
        const std::int64_t now_ns = clock_->now_ns();
        kept_[static_cast<std::size_t>(number)] =
            Preset{angles_at(now_ns), zoom_.at(now_ns), focus_.at(now_ns), autofocus_};
    }
    return possible;
}

Result<Done> SimulatedHead::recall_preset(int number) {
    auto possible = is_preset(number);
    if (possible) {
        std::lock_guard lock(mutex_);
        const std::int64_t now_ns = clock_->now_ns();
        const auto& preset = kept_[static_cast<std::size_t>(number)];
        if (!preset) {
            return Error{"Nothing was kept in preset " + std::to_string(number) + ".",
                         "Keep a position in it first."};
        }
        look(preset->angles, now_ns);
        zoom(preset->zoom, now_ns);
        focus(preset->focus, preset->autofocus, now_ns);
    }
    return possible;
}

}  // namespace kambara
