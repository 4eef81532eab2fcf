// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "app/cli/outcome.h"

namespace kambara::cli {

struct LiveOptions {
    std::string profile = "default";
    std::string pan_tilt;           ///< a real head's URI in place of the simulated one
    std::optional<double> seconds;  ///< until interrupted, where not given
    bool servo = false;  ///< the head's aim is made right by its camera's own picture (ServoHead)
};

/// The main job on the simulated rig in real time: chooses the target, follows it, aims the head,
/// and shows state, position, uncertainty, head angles, rate and the truth beside them.
Outcome run_live(const LiveOptions& options);

}  // namespace kambara::cli
