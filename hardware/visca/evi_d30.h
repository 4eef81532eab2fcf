// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace kambara::visca::evi_d30 {

/// The EVI-D30's units and ends (visca: EVI-D30 units, ranges and tables). Steps count from home,
/// to the right and upwards; speeds are linear in their codes.
inline constexpr double pan_stop_steps = 880.0;
inline constexpr double tilt_stop_steps = 300.0;
inline constexpr double pan_steps_per_deg = 8.8;
inline constexpr double tilt_steps_per_deg = 12.0;
inline constexpr int pan_speed_codes = 0x18;
inline constexpr int tilt_speed_codes = 0x14;
inline constexpr double pan_steps_s_per_code = 80.0 * pan_steps_per_deg / pan_speed_codes;
inline constexpr double tilt_steps_s_per_code = 50.0 * tilt_steps_per_deg / tilt_speed_codes;
inline constexpr double zoom_tele = 0x3FF;
inline constexpr double focus_far = 0x1000;
inline constexpr double focus_near = 0x9FFF;
inline constexpr int slowest_zoom = 2;  ///< codes below do as this one
inline constexpr int fastest_zoom = 7;
inline constexpr int last_shutter = 0x1B;
inline constexpr int last_iris = 0x11;
inline constexpr int last_gain = 0x07;
inline constexpr int vendor = 0x0020;
inline constexpr int model = 0x0402;

/// Most switches of VISCA.
inline constexpr int on = 2;
inline constexpr int off = 3;
inline constexpr int other_one = 0x10;

}  // namespace kambara::visca::evi_d30
