// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "app/cli/outcome.h"

namespace kambara::cli {

struct TriangulateOptions {
    std::filesystem::path rig;
    std::filesystem::path points;         ///< lines `xl yl xr yr`, px; # begins a comment
    double sigma_px = 0.1;                ///< of each coordinate
    std::string method = "reprojection";  ///< or sine, midpoint, parallel
};

/// Positions from pairs of pixels, in the left camera's frame. JSON: points, a list of x_mm, y_mm,
/// z_mm, sigma_x_mm, sigma_y_mm, sigma_z_mm, residual_px, calibration_sigma_x_mm, _y_, _z_ (null
/// where the rig file does not tell them), or nulls and the reason; method.
Outcome run_triangulate(const TriangulateOptions& options);

}  // namespace kambara::cli
