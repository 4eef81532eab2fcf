// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/outcome.h"
#include "app/sources/sources.h"

namespace kambara::cli {

struct CompareOptions {
    std::string scenes;                  ///< names of simulated scenes, see parse_scenes
    std::vector<std::string> profiles;   ///< more simulated scenes
    SourceOptions recording;             ///< left, right, rig, start, rate; left empty: none
    std::vector<std::string> templates;  ///< X,Y,W,H in the recording's first frame, a scene each
    std::string truth;                   ///< the recording's, as `simulate` writes it
    int template_px = 31;                ///< the square chosen on the simulated target
    std::optional<double> seconds;       ///< of each scene; simulated ones 7, recordings whole
    bool sparse = false;   ///< every method also with every second pixel of every second row
    std::string temporal;  ///< median:N or mean:N over each scene's pictures; empty: as they are
    std::optional<std::filesystem::path> report;  ///< HTML to write
};

/// Follows one target by every measure after every transform, in every scene, and sets robustness,
/// accuracy and time side by side; says what that means for the default method. Where neither
/// scenes nor profiles nor a recording are named: all simulated scenes. Works on all cores; times
/// are measured afterwards on one. JSON: see resources/README.md.
Outcome run_compare(const CompareOptions& options);

}  // namespace kambara::cli
