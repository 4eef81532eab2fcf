// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "app/cli/outcome.h"

namespace kambara::cli {

struct SimulateOptions {
    std::string profile = "default";
    double seconds = 10.0;
    std::filesystem::path out;
    bool servo = false;  ///< the head's aim is made right by its camera's own picture (ServoHead)
    std::string position_method = "reprojection";  ///< by which the head follows
};

/// Records the simulated rig: left/, right/ and pan_tilt/ with numbered PNG pictures (the head
/// follows the target, unless the water hides it), rig.yaml, truth.csv (frame, time_s, the target's
/// place in the left camera's frame and its pixels, the head's angles) and template.txt, the
/// rectangle about the target in frame 0. The folder must not exist, or be empty; it appears whole
/// or not at all.
Outcome run_simulate(const SimulateOptions& options);

}  // namespace kambara::cli
