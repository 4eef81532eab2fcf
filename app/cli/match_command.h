// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/cli/match_search.h"
#include "app/cli/outcome.h"

namespace kambara::cli {

struct MatchOptions {
    std::filesystem::path image;
    std::filesystem::path templ;
    std::string measure = "zncc";
    std::string transform = "none";
    MatchSearchOptions search;
    std::optional<std::filesystem::path> map;  ///< the scores, as a 32-bit float TIFF
};

/// One search of a template picture in another picture. JSON: x_px, y_px (the template's centre,
/// sub-pixel), score, quality (the probability that it is right), likeness (the score in [0, 1]),
/// covariance_px2 (null where the template has no texture in some direction), second_score (of the
/// best other peak; null where there is none), peak_ratio (the other peak's likeness by this one's,
/// in [0, 1]).
Outcome run_match(const MatchOptions& options);

}  // namespace kambara::cli
