// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/cli/outcome.h"

namespace kambara::cli {

struct RangeTestOptions {
    std::filesystem::path rig;
    /// Known places: with pixels, or with the frames of a track table in which the target was
    /// there (resources/README.md: range experiment).
    std::string known;
    std::string track;  ///< a track table; with `left` it is written first
    /// Pictures to follow the target in; sim:stations knows its places itself.
    std::string left;
    std::string right;
    std::string templ = "auto";  ///< X,Y,W,H in the first frame
    std::string frame = "left";  ///< of the known places: left, rig or own
    std::optional<double> true_baseline_mm;
    std::optional<std::filesystem::path> csv;
    std::optional<std::filesystem::path> report;
};

/// A range experiment: known places against measured positions, before and after a correction of
/// the baseline. JSON: stations, baseline_mm, corrected_baseline_mm, before and after with the
/// mean and worst errors.
Outcome run_range_test(const RangeTestOptions& options);

}  // namespace kambara::cli
