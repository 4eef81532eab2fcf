// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/outcome.h"
#include "app/sources/sources.h"

namespace kambara::cli {

struct TrackOptions {
    SourceOptions sources;
    /// X,Y,W,H in the first frame, a target each; `auto` with sim:
    std::vector<std::string> templates;
    int steer = 1;       ///< the number of the target that the head is steered to
    bool servo = false;  ///< the head's aim is made right by its camera's own picture (ServoHead)
    std::string measure = "zncc";
    std::string transform = "none";
    std::string temporal;  ///< median:N or mean:N; empty: the pictures as they are
    std::string position_method = "reprojection";  ///< or sine, midpoint, parallel
    std::string frame = "left";  ///< of the positions: left, rig, level or vehicle
    std::optional<std::filesystem::path> csv;
    std::optional<std::filesystem::path> record;
    std::optional<double> seconds;  ///< stop after so much of the source's time
};

/// Follows targets through stereo pictures. The table is written when the source has come to its
/// end, whole or not at all. JSON: frames, tracked_frames, tracked_fraction, rate_hz, first and
/// last frame, of the steered target; with several also what was tracked of each; with a simulated
/// source also `truth`; position_method; rig_watch, where enough was tracked to tell (the worst of
/// the run: matches, offset_px, sigma_px, turn_deg, moved; moved_frame, when it was first raised).
Outcome run_track(const TrackOptions& options);

}  // namespace kambara::cli
