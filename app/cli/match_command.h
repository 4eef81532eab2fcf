// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/cli/outcome.h"

namespace kambara::cli {

struct MatchOptions {
    std::filesystem::path image;
    std::filesystem::path templ;
    std::string measure = "zncc";
    std::string transform = "none";
    std::string search = "full";
    std::optional<std::filesystem::path> map;  ///< the scores, as a 32-bit float TIFF
};

/// One search of a template picture in another picture. JSON: x_px, y_px (the template's centre,
/// sub-pixel), score, quality.
Outcome run_match(const MatchOptions& options);

}  // namespace kambara::cli
