// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "core/base/angles.h"

namespace kambara {

struct SteeringOptions {
    /// The head is left alone while the target is nearer to its axis than this: a step of its
    /// motors.
    double dead_band_rad = rad_from_deg(0.1);
    /// Commands follow each other no faster than this, so that a slow line to the head does not
    /// fill up; 0 for as often as asked.
    double min_interval_s = 0.0;
    /// The aim is led to where the target will be when the head gets there.
    bool leads = true;
    /// From a picture's exposure to its arrival, of live cameras; what they declare or one
    /// measured.
    double camera_latency_s = 0.0;
};

/// Decides when a head is told to move, and where to. Keeps within the limits always. Automatic
/// until the operator takes over; then silent until it is handed back.
class Steering {
  public:
    explicit Steering(SteeringOptions options, const HeadLimits& limits)
        : options_(options), limits_(limits) {}

    bool automatic() const { return automatic_; }
    void set_automatic(bool automatic) { automatic_ = automatic; }

    /// The wanted angles were beyond the limits at the last call.
    bool at_limit() const { return at_limit_; }
    /// There is no target to look at, or it is not for steering to look there: nothing is beyond
    /// reach.
    void nothing_wanted() { at_limit_ = false; }

    /// What to command so that the head looks along `wanted`, given what it was last told; empty
    /// where nothing need be done, or where `time_ns` (on any clock that never runs backwards; not
    /// given: no interval is kept) is too soon after the last command.
    std::optional<HeadAngles> command_for(const HeadAngles& wanted,
                                          const std::optional<HeadAngles>& last_command,
                                          std::optional<std::int64_t> time_ns = std::nullopt);

  private:
    SteeringOptions options_;
    HeadLimits limits_;
    bool automatic_ = true;
    bool at_limit_ = false;
    std::optional<std::int64_t> commanded_ns_;
};

}  // namespace kambara
