// SPDX-License-Identifier: GPL-3.0-or-later
#include "hardware/visca/axis_motion.h"

#include <algorithm>
#include <cmath>

namespace kambara::visca {

void AxisMotion::set_stops(double low, double high) {
    bounds_.low = low;
    bounds_.high = high;
}

void AxisMotion::move_to(double target, double speed) {
    target_ = std::clamp(target, bounds_.low, bounds_.high);
    speed_ = speed;
    to_target_ = true;
    goes_ = true;
}

void AxisMotion::drive(double velocity) {
    driven_ = velocity;
    to_target_ = false;
    goes_ = velocity != 0.0;
}

void AxisMotion::advance(double seconds) {
    if (!moving()) {
        return;
    }
    const double most_change = bounds_.acceleration * seconds;
    double wanted = driven_;
    const double left = target_ - position_;
    if (to_target_) {
        // From here it can still brake in time; less a piece of time's way, which is not known yet.
        const double brakable =
            std::max(0.0, std::sqrt(2.0 * bounds_.acceleration * std::abs(left)) - most_change);
        wanted = std::copysign(std::min(speed_, std::max(brakable, most_change)), left);
    }
    velocity_ += std::clamp(wanted - velocity_, -most_change, most_change);
    const double way = velocity_ * seconds;
    if (to_target_ && std::abs(velocity_) <= 2.0 * most_change &&
        std::abs(left) <= std::abs(way) + 0.5 * most_change * seconds) {
        position_ = target_;
        velocity_ = 0.0;
        goes_ = false;
        return;
    }
    const double next = position_ + way;
    const bool into_stop =
        (next >= bounds_.high && velocity_ > 0.0) || (next <= bounds_.low && velocity_ < 0.0);
    // One that begins outside the stops comes back in freely.
    position_ = into_stop ? std::clamp(next, std::min(bounds_.low, position_),
                                       std::max(bounds_.high, position_))
                          : next;
    if (into_stop) {
        velocity_ = 0.0;
        goes_ = to_target_ && position_ != target_;
    }
}

}  // namespace kambara::visca
