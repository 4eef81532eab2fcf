// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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
};

/// Drives a head by hand and waits until it has come to rest (but for drive). JSON: name, pan_deg,
/// tilt_deg, moving, zoom_share, horizontal_view_deg, autofocus, focus_share.
Outcome run_pan_tilt(const PanTiltOptions& options);

}  // namespace kambara::cli
