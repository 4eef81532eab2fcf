// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "core/base/angles.h"
#include "core/devices/pan_tilt_camera.h"

namespace kambara::visca {

/// Where a head looks between two readings of its position: from the last one on towards where it
/// was told to look, at its speed. Times in ns on any clock.
class PositionEstimate {
  public:
    /// The speeds in rad/s at which it turns towards a target.
    void set_speeds(double pan_rad_s, double tilt_rad_s);
    /// From then on it turns there; empty: it is not known to turn anywhere.
    void set_target(const std::optional<HeadAngles>& target, std::int64_t time_ns);
    /// Slower than it could.
    void set_target(const HeadAngles& target, const HeadAngles& speed_rad_s, std::int64_t time_ns);
    /// It turns at these speeds.
    void set_drive(double pan_rad_s, double tilt_rad_s, std::int64_t time_ns);

    /// Takes what the head said; false for what can't be (a jump that no motor makes), which is
    /// believed only when the next reading agrees.
    bool add_reading(const HeadAngles& angles, std::int64_t time_ns);
    /// After the link was lost the head may be anywhere.
    void forget();

    bool known() const { return reading_.has_value(); }
    /// Only where known. Never earlier than the last reading.
    HeadStatus at(std::int64_t time_ns) const;
    /// The last two readings were the same.
    bool at_rest() const { return at_rest_; }

  private:
    struct Reading {
        HeadAngles angles;
        std::int64_t time_ns = 0;
    };
    bool reachable(const Reading& from, const Reading& to) const;
    HeadAngles moved_on(std::int64_t time_ns) const;

    double pan_speed_rad_s_ = 0.0;
    double tilt_speed_rad_s_ = 0.0;
    std::optional<Reading> reading_;
    std::optional<Reading> doubtful_;
    std::optional<HeadAngles> target_;
    HeadAngles pursuit_rad_s_;         // the speeds on the way to the target
    std::optional<HeadAngles> drive_;  // speeds
    std::int64_t since_ns_ = 0;        // the target is pursued
    bool at_rest_ = false;
};

}  // namespace kambara::visca
