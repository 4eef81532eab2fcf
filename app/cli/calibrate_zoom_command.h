// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "app/cli/outcome.h"

namespace kambara::cli {

struct CalibrateZoomOptions {
    std::filesystem::path rig;  ///< its pan-tilt camera as it is at its widest
    /// Table: pan_tilt (pictures, from the table's folder), zoom_share (0 wide, 1 tele).
    std::filesystem::path views;
    std::string head = "evi-d30";  ///< the kind, of `heads`
    std::filesystem::path heads;   ///< a table of heads; empty: the one that is built in
    std::string widest;            ///< F,WIDTH: the lens at its widest, mm; empty: the table's
    std::filesystem::path out;     ///< the table of heads with the curve
};

/// How much larger the head's lens shows things at each place of its zoom, from pictures of a scene
/// at rest, and the table of heads with that. JSON: head, worst_table_error_pct (of what the table
/// said before; null where it said nothing), places[{zoom_share, magnification,
/// magnification_sigma, table_magnification, points, rms_px}], out.
Outcome run_calibrate_zoom(const CalibrateZoomOptions& options);

}  // namespace kambara::cli
