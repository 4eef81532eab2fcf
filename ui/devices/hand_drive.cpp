// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/devices/hand_drive.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace kambara::ui {
namespace {

constexpr int tick_ms = 20;
constexpr int renewal_ms = 50;  // a quarter of what a drive lasts
constexpr double fineness = 64.0;
constexpr double zoom_range_s = 3.0;  // end to end, the trigger pressed
constexpr int zoom_renewal_ms = 100;

std::size_t number(HandDrive::Source source) {
    return static_cast<std::size_t>(source);
}

// In whole parts, so that a hand's tremble is no new speed each time.
double coarse(double deflection) {
    return std::round(std::clamp(deflection, -1.0, 1.0) * fineness) / fineness;
}

std::int64_t steady_ns() {
    return std::chrono::steady_clock::now().time_since_epoch() / std::chrono::nanoseconds(1);
}

}  // namespace

HandDrive::HandDrive(QObject* parent) : QObject(parent) {
    time_.start();
    timer_.setTimerType(Qt::PreciseTimer);
    connect(&timer_, &QTimer::timeout, this, &HandDrive::tick);
}

void HandDrive::set_gamepad(std::shared_ptr<const GamepadBase> gamepad) {
    gamepad_ = std::move(gamepad);
    run_timer();
}

void HandDrive::show_head(const std::optional<HeadSnapshot>& head) {
    head_ = head;
}

void HandDrive::set_speed_share(double share) {
    speed_share_ = share;
}

void HandDrive::run_timer() {
    if (!gamepad_ && !holding_) {
        timer_.stop();
    } else if (!timer_.isActive()) {
        timer_.start(tick_ms);
    }
}

void HandDrive::hold(Source source, const QPointF& deflection) {
    if (!head_ || !head_->abilities.drive) {
        return;
    }
    const QPointF whole(coarse(deflection.x()), coarse(deflection.y()));
    const bool anew = !is_held_[number(source)];
    const bool changed = anew || deflections_[number(source)] != whole;
    is_held_[number(source)] = true;
    deflections_[number(source)] = whole;
    if (anew) {
        holding_ = source;
        run_timer();
    }
    if (changed && holding_ == source && (anew || time_.elapsed() - told_ms_ >= renewal_ms)) {
        tell();
    }
}

void HandDrive::release(Source source) {
    if (!std::exchange(is_held_[number(source)], false) || holding_ != source) {
        return;
    }
    holding_.reset();
    for (const Source other : {Source::keys, Source::stick, Source::gamepad}) {
        if (is_held_[number(other)]) {
            holding_ = other;
        }
    }
    if (holding_) {
        tell();
    } else {
        emit halt();
    }
    run_timer();
}

void HandDrive::drop_all() {
    is_held_ = {};
    law_.disarm();
    if (std::exchange(holding_, std::nullopt)) {
        emit halt();
    }
    emit dropped();
    run_timer();
}

void HandDrive::tell() {
    told_ms_ = time_.elapsed();
    const HeadLimits limits = head_ ? head_->limits : HeadLimits{};
    const double magnification =
        head_ && head_->lens ? std::max(1.0, head_->lens->magnification()) : 1.0;
    const double share = speed_share_ / magnification;
    const QPointF& way = deflections_[number(*holding_)];
    emit drive(way.x() * share * limits.pan_speed_rad_s, way.y() * share * limits.tilt_speed_rad_s);
}

void HandDrive::tick() {
    if (gamepad_) {
        ask_gamepad();
    }
    if (holding_ && time_.elapsed() - told_ms_ >= renewal_ms) {
        tell();
    }
}

void HandDrive::ask_gamepad() {
    const PadReading reading = gamepad_->reading();
    // Without a head there is nothing for the stick to turn.
    StickWish wish = law_.update(reading, steady_ns());
    if (wish.state != pad_state_) {
        pad_state_ = wish.state;
        emit pad_changed(wish.state, QString::fromStdString(reading.name));
    }
    if (!head_) {
        wish = {wish.state, 0.0, 0.0, 0.0, false};
    }
    if (wish.halt && !pad_halts_) {
        emit halt();
        drop_all();  // a key that is still held would turn it again
    }
    pad_halts_ = wish.halt;
    if (wish.turns()) {
        hold(Source::gamepad, {wish.pan, wish.tilt});
    } else {
        release(Source::gamepad);
    }
    follow_zoom(wish.zoom);
}

void HandDrive::follow_zoom(double wish) {
    if (wish == 0.0 || !head_ || !head_->lens || !head_->abilities.zoom) {
        if (zoom_) {
            emit zoom(*zoom_);
        }
        zoom_.reset();
        return;
    }
    const qint64 now_ms = time_.elapsed();
    if (!zoom_) {
        zoom_ = head_->lens->zoom_share;
        zoomed_ms_ = now_ms;
        zoom_told_ms_ = 0;
    }
    const double passed_s = 0.001 * static_cast<double>(now_ms - zoomed_ms_);
    zoomed_ms_ = now_ms;
    zoom_ = std::clamp(*zoom_ + wish * passed_s / zoom_range_s, 0.0, 1.0);
    if (now_ms - zoom_told_ms_ >= zoom_renewal_ms) {
        zoom_told_ms_ = now_ms;
        emit zoom(*zoom_);
    }
}

}  // namespace kambara::ui
