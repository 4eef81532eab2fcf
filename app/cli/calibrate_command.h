// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/cli/outcome.h"

namespace kambara::cli {

struct CalibrateOptions {
    std::string left;      ///< pattern of pictures
    std::string right;     ///< empty: one camera only
    std::string pan_tilt;  ///< empty: none
    std::string target;
    std::string model = "brown";
    std::optional<std::string> sensor;    ///< dx,dy,Ncx,Nfx
    std::optional<std::string> baseline;  ///< MM,SIGMA
    std::string medium = "air";
    std::optional<std::filesystem::path> expected;  ///< rig file
    bool estimate_target = false;
    std::filesystem::path out;
    std::optional<std::filesystem::path> report;
};

/// Calibrates from pictures of a target and writes the rig file; a refused result writes none and
/// leaves an older file as it was. The JSON is the contract's, filled as far as known when refused.
Outcome run_calibrate(const CalibrateOptions& options);

}  // namespace kambara::cli
