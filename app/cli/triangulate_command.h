// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "app/cli/outcome.h"

namespace kambara::cli {

struct TriangulateOptions {
    std::filesystem::path rig;
    std::filesystem::path points;  ///< lines `xl yl xr yr`, px; # begins a comment
    double sigma_px = 0.1;         ///< of each coordinate
};

/// Positions from pairs of pixels, in the left camera's frame. JSON: points, a list of x_mm, y_mm,
/// z_mm, sigma_x_mm, sigma_y_mm, sigma_z_mm, residual_px, or nulls and the reason.
Outcome run_triangulate(const TriangulateOptions& options);

}  // namespace kambara::cli
