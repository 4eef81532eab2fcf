// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/outcome.h"
#include "core/calibration/target.h"
#include "core/pointing/head_calibration.h"

namespace kambara::cli {

struct CalibrateHeadOptions {
    std::filesystem::path rig;
    /// Table: left,right,pan_tilt (pictures, from the table's folder), pan_deg,tilt_deg (told by
    /// the head), and where known pan_from,tilt_from: below or above.
    std::string views;
    std::string target = "two-plane-24";
    std::filesystem::path out;
    /// Writes the rig as the views correct it, too; else `out` has the rig as given, and the head's
    /// model that steers best beside it.
    bool refine_rig = false;
};

/// A row of a table of head views that can't be used, and why.
struct RejectedHeadView {
    int line = 0;
    std::string reason;
};

struct HeadRecord {
    std::vector<HeadView> views;
    std::vector<RejectedHeadView> rejected;
};

/// The views of a table (resources/README.md: head views) and its pictures. `progress` is called
/// before each row. The rig must have all three cameras.
Result<HeadRecord> read_head_record(const std::filesystem::path& file, const Rig& rig,
                                    const Target& target,
                                    const std::function<void(double share)>& progress);

/// The head's axes, lever arms and backlash, from pictures of a target by all three cameras at
/// several head positions, jointly with the rig where its file has a covariance. The target may
/// move between the views, not within one. JSON: rms_px, pair_rms_px, rms_without_model_px,
/// views_used, views_rejected[{line, reason}], points, rig (held, prior or refined),
/// rig_most_moved, rig_most_moved_sigmas, the head's own numbers and deviations. Written beside a
/// rig that is not refined are those that steer best with it as it is (HeadCalibration).
Outcome run_calibrate_head(const CalibrateHeadOptions& options);

}  // namespace kambara::cli
