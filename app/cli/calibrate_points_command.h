// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/cli/outcome.h"

namespace kambara::cli {

struct CalibratePointsOptions {
    std::filesystem::path
        points;                   ///< lines `x y z X Y`, or `x y z XL YL XR YR`; # begins a comment
    std::string sensor;           ///< dx,dy,Ncx,Nfx: mm, mm, elements and picture columns a line
    std::string center;           ///< Cx,Cy in px
    std::string method = "full";  ///< or basic
    bool coplanar = false;        ///< points on one plane, s_x = 1 taken as known
    std::optional<std::string> size;  ///< W,H of the pictures, for the rig file
    std::optional<std::filesystem::path> out;
};

/// Tsai's calibration from a list of points. JSON: method, accepted, reasons, outliers (line
/// numbers), camera or cameras{left, right} with the parameters, R, T_mm, sse_px2, mean_error_px,
/// sigma and interval_95 (half-widths), and for two cameras pairs.left_right{baseline_mm, R, T_mm}.
Outcome run_calibrate_points(const CalibratePointsOptions& options);

}  // namespace kambara::cli
