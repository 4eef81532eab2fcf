// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pointing/servo.h"

#include <algorithm>
#include <cmath>

namespace kambara {
namespace {

constexpr double farthest_s = 0.1;

HeadAngles difference(const HeadAngles& a, const HeadAngles& b) {
    return {a.pan_rad - b.pan_rad, a.tilt_rad - b.tilt_rad};
}

HeadAngles sum(const HeadAngles& a, const HeadAngles& b, double times) {
    return {a.pan_rad + times * b.pan_rad, a.tilt_rad + times * b.tilt_rad};
}

double seconds(std::int64_t ns) {
    return 1e-9 * static_cast<double>(ns);
}

}  // namespace

void ServoAim::see(const HeadAngles& seen, std::int64_t time_ns) {
    const double step_s = seconds(time_ns - seen_ns_);
    if (!seen_ || step_s <= 0.0 || step_s > options_.gap_s) {
        seen_ = seen;
        rate_rad_s_ = {};
    } else {
        const HeadAngles expected = sum(*seen_, rate_rad_s_, step_s);
        const HeadAngles off = difference(seen, expected);
        seen_ = sum(expected, off, options_.alpha);
        rate_rad_s_ = sum(rate_rad_s_, off, options_.beta / step_s);
    }
    seen_ns_ = time_ns;
}

bool ServoAim::compare(const HeadAngles& by_stereo, const HeadAngles& seen, std::int64_t time_ns) {
    const HeadAngles off = difference(seen, by_stereo);
    if (std::hypot(off.pan_rad, off.tilt_rad) > options_.widest_rad) {
        return false;
    }
    if (!correction_) {
        correction_ = off;
    } else {
        const double step_s = std::max(0.0, seconds(time_ns - compared_ns_));
        const double share = 1.0 - std::exp(-step_s / options_.settle_s);
        correction_ = sum(*correction_, difference(off, *correction_), share);
    }
    compared_ns_ = time_ns;
    return true;
}

void ServoAim::forget() {
    correction_.reset();
    seen_.reset();
    rate_rad_s_ = {};
}

std::optional<ServoAim::Alone> ServoAim::alone(std::int64_t time_ns) const {
    if (!seen_) {
        return std::nullopt;
    }
    const double ahead_s = std::clamp(seconds(time_ns - seen_ns_), 0.0, farthest_s);
    return Alone{sum(*seen_, rate_rad_s_, ahead_s), rate_rad_s_};
}

}  // namespace kambara
