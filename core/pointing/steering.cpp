// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pointing/steering.h"

#include <cmath>

#include "core/pointing/aim.h"

namespace kambara {

std::optional<HeadAngles> Steering::command_for(const HeadAngles& wanted,
                                                const std::optional<HeadAngles>& last_command,
                                                std::optional<std::int64_t> time_ns) {
    if (!automatic_ || !std::isfinite(wanted.pan_rad) || !std::isfinite(wanted.tilt_rad)) {
        return std::nullopt;
    }
    const HeadAngles reachable = within_limits(wanted, limits_);
    at_limit_ = reachable != wanted;
    if (last_command) {
        // On the sphere a step of pan counts less the higher the head looks.
        const double across =
            (reachable.pan_rad - last_command->pan_rad) * std::cos(reachable.tilt_rad);
        const double up = reachable.tilt_rad - last_command->tilt_rad;
        if (std::hypot(across, up) < options_.dead_band_rad) {
            return std::nullopt;
        }
    }
    // A time before the last command's is that of a recording that was wound back.
    if (time_ns && commanded_ns_ && *time_ns >= *commanded_ns_ &&
        static_cast<double>(*time_ns - *commanded_ns_) < options_.min_interval_s * 1e9) {
        return std::nullopt;
    }
    commanded_ns_ = time_ns;
    return reachable;
}

}  // namespace kambara
