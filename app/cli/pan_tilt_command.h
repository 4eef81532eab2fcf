// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cli/outcome.h"

namespace kambara::cli {

struct PanTiltOptions {
    std::string device;  ///< a head's URI
    /// position; move PAN,TILT (degrees); drive PAN,TILT (degrees/s); halt, home, reset; zoom
    /// SHARE; focus SHARE or auto; keep N, recall N
    std::string action = "position";
    std::string value;
    std::optional<double> seconds = {};  ///< of a drive, which then ends; without, it goes on
};

/// Drives a head by hand and waits until it has come to rest (but for a drive that goes on). Fails
/// where the head does not tell that its zoom or focus is where it was sent. JSON: name, pan_deg,
/// tilt_deg, moving, zoom_share, horizontal_view_deg, autofocus, focus_share.
Outcome run_pan_tilt(const PanTiltOptions& options);

}  // namespace kambara::cli
