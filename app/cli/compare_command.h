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
    /// Simulated profiles; where neither these nor a recording is given, a set from clear air to
    /// harbour water.
    std::vector<std::string> profiles;
    SourceOptions recording;  ///< left, right, rig, start; left empty: none
    std::string templ;        ///< X,Y,W,H in the recording's first frame
    int template_px = 31;     ///< the square chosen on the simulated target
    int frames = 120;         ///< of each scene
    std::string temporal;     ///< median:N or mean:N over each scene's pictures; empty: as they are
    std::optional<std::filesystem::path> report;  ///< HTML to write
};

/// Follows one target by every measure after every transform, in every scene, and sets them side by
/// side: frames right, frames silently wrong, error, time. On simulated scenes by the truth; on a
/// recording by the median of all methods' positions, frame by frame. JSON: temporal (where given),
/// scenes[{name, reference, frames, methods[{measure, transform, right_fraction, wrong_fraction,
/// lost_fraction, error_mean_pct, ms_median}]}].
Outcome run_compare(const CompareOptions& options);

}  // namespace kambara::cli
