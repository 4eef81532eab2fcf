// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/cli/outcome.h"

namespace kambara::cli {

struct LevelOptions {
    std::filesystem::path rig;
    std::string track;   ///< a track table: a target moved up and down
    std::string points;  ///< positions x_mm,y_mm,z_mm in the left camera's frame, or pixels
    std::string by = "vertical";     ///< or wall
    std::optional<double> roll_deg;  ///< of the rig, for a wall, which says nothing of it
    std::optional<double> heading_deg;
    std::string rig_in_vehicle;  ///< X,Y,Z in mm: forward, to the right, down
    std::optional<std::filesystem::path> out;
};

/// The angle in which the rig is mounted. JSON: pitch_deg, pitch_sigma_deg, roll_deg,
/// roll_sigma_deg (null where it was not measured), points_used, points_left_out, rms_mm,
/// extent_mm. With `out` the rig file is written with its mount.
Outcome run_level(const LevelOptions& options);

}  // namespace kambara::cli
