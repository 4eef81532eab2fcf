// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

/// How far and how fast a head can turn; symmetric about home.
struct HeadLimits {
    double pan_rad = rad_from_deg(100.0);
    double tilt_rad = rad_from_deg(25.0);
    double pan_speed_rad_s = rad_from_deg(80.0);
    double tilt_speed_rad_s = rad_from_deg(50.0);
    bool operator==(const HeadLimits&) const = default;
};

}  // namespace kambara
