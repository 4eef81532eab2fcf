// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pointing/stick_law.h"

#include <algorithm>
#include <cmath>

namespace kambara {
namespace {

bool in_one_place(const PadReading& a, const PadReading& b) {
    return a.right == b.right && a.up == b.up && a.zoom_in == b.zoom_in && a.zoom_out == b.zoom_out;
}

bool older_than(std::int64_t time_ns, std::int64_t now_ns, double seconds) {
    return 1e-9 * static_cast<double>(now_ns - time_ns) > seconds;
}

}  // namespace

bool StickLaw::let_go(const PadReading& reading) const {
    return std::hypot(reading.right, reading.up) <= options_.dead_zone &&
           std::max(reading.zoom_in, reading.zoom_out) <= options_.dead_zone;
}

// A hand is never quite still; a radio link that broke leaves the last numbers.
bool StickLaw::held_too_still(const PadReading& reading, std::int64_t now_ns) {
    if (!in_one_place(reading, last_) || let_go(reading)) {
        changed_ns_ = now_ns;
    }
    return older_than(changed_ns_, now_ns, options_.held_still_s);
}

StickWish StickLaw::update(const PadReading& reading, std::int64_t now_ns) {
    if (!reading.present) {
        armed_ = frozen_ = false;
        last_ = reading;
        return {};
    }
    if (!last_.present || reading.device != last_.device) {
        armed_ = frozen_ = false;
        changed_ns_ = now_ns;
    }
    const bool still = held_too_still(reading, now_ns);
    last_ = reading;
    if (older_than(reading.time_ns, now_ns, options_.silent_s)) {
        armed_ = false;
        return {PadState::frozen, 0.0, 0.0, 0.0, false};
    }
    if (still) {
        armed_ = false;
        frozen_ = true;
    }
    if (reading.halt) {
        armed_ = frozen_ = false;
        return {PadState::centre_first, 0.0, 0.0, 0.0, true};
    }
    if (!armed_ && let_go(reading)) {
        armed_ = true;
        frozen_ = false;
    }
    if (!armed_) {
        return {frozen_ ? PadState::frozen : PadState::centre_first, 0.0, 0.0, 0.0, false};
    }
    const auto beyond = [&](double way) {
        const double share = (std::min(way, 1.0) - options_.dead_zone) / (1.0 - options_.dead_zone);
        return share > 0.0 ? share * share : 0.0;
    };
    const double way = std::hypot(reading.right, reading.up);
    const double speed = beyond(way);
    StickWish wish{PadState::armed, 0.0, 0.0, beyond(reading.zoom_in) - beyond(reading.zoom_out),
                   false};
    if (speed > 0.0) {
        wish.pan = speed * reading.right / way;
        wish.tilt = speed * reading.up / way;
    }
    return wish;
}

}  // namespace kambara
