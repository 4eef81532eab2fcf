// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/base/angles.h"

namespace kambara {

struct SteeringOptions {
    /// The head is left alone while the target is nearer to its axis than this.
    double dead_band_rad = rad_from_deg(0.15);
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

    /// What to command so that the head looks along `wanted`, given what it was last told; empty
    /// where nothing need be done.
    std::optional<HeadAngles> command_for(const HeadAngles& wanted,
                                          const std::optional<HeadAngles>& last_command);

  private:
    SteeringOptions options_;
    HeadLimits limits_;
    bool automatic_ = true;
    bool at_limit_ = false;
};

}  // namespace kambara
