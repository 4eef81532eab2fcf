// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <numbers>

namespace kambara {

constexpr double rad_from_deg(double angle_deg) {
    return angle_deg * std::numbers::pi / 180.0;
}
constexpr double deg_from_rad(double angle_rad) {
    return angle_rad * 180.0 / std::numbers::pi;
}

/// Where a pan-tilt head looks, from its home position: pan positive to the right, tilt positive
/// upwards (geometry: pan-tilt mapping).
struct HeadAngles {
    double pan_rad = 0.0;
    double tilt_rad = 0.0;
    bool operator==(const HeadAngles&) const = default;
};

/// Where a head is to look while it follows something that moves: `angles` at `time_ns`, going on
/// at the rate. Times on the system's clock.
struct HeadAim {
    HeadAngles angles;
    HeadAngles rate_rad_s;
    std::int64_t time_ns = 0;
    std::int64_t computed_ns = 0;  ///< when it was found out; it is worth nothing for long

    /// The rate goes on for a tenth of a second at most.
    HeadAngles at(std::int64_t when_ns) const {
        constexpr std::int64_t farthest_ns = 100'000'000;
        const std::int64_t off_ns = when_ns - time_ns;
        const double ahead_s = 1e-9 * static_cast<double>(off_ns > farthest_ns    ? farthest_ns
                                                          : off_ns < -farthest_ns ? -farthest_ns
                                                                                  : off_ns);
        return {angles.pan_rad + ahead_s * rate_rad_s.pan_rad,
                angles.tilt_rad + ahead_s * rate_rad_s.tilt_rad};
    }
    bool operator==(const HeadAim&) const = default;
};

/// How far and how fast a head can turn; symmetric about home.
struct HeadLimits {
    double pan_rad = rad_from_deg(100.0);
    double tilt_rad = rad_from_deg(25.0);
    double pan_speed_rad_s = rad_from_deg(80.0);
    double tilt_speed_rad_s = rad_from_deg(50.0);
    bool operator==(const HeadLimits&) const = default;
};

}  // namespace kambara
