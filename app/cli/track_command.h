// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "app/cli/outcome.h"
#include "app/sources/sources.h"

namespace kambara::cli {

struct TrackOptions {
    SourceOptions sources;
    std::string templ;  ///< X,Y,W,H in the first frame; `auto` with sim:
    std::string measure = "zncc";
    std::string transform = "none";
    std::string temporal;  ///< median:N or mean:N; empty: the pictures as they are
    std::optional<std::filesystem::path> csv;
    std::optional<std::filesystem::path> record;
    std::optional<double> seconds;  ///< stop after so much of the source's time
};

/// Follows a target through stereo pictures. The table is written when the source has come to its
/// end, whole or not at all. JSON: frames, tracked_frames, tracked_fraction, rate_hz, first and
/// last frame; with a simulated source also `truth`.
Outcome run_track(const TrackOptions& options);

}  // namespace kambara::cli
