// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <optional>

#include "app/cli/compare_scene.h"
#include "core/base/result.h"

namespace kambara::cli {

/// Where the cameras of a rig see a point of the left camera's frame; empty where the left one does
/// not.
std::optional<Sighting> sighting_of(const Rig& rig, const Eigen::Vector3d& point_in_left_mm);

/// Reads a table with the columns frame, left_x_px, left_y_px, and where they are there right_x_px,
/// right_y_px, x_mm, y_mm, z_mm (as `simulate` writes it) into the scene's truth, by the number of
/// the left frame. Refuses a table without those, one that does not know the first frame, and one
/// whose point is more than 3 px from the template's centre there. What it is less than that apart
/// is carried through all frames.
Result<Done> read_truth(const std::filesystem::path& file, CompareScene& scene);

}  // namespace kambara::cli
