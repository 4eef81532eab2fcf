// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/outcome.h"

namespace kambara::cli {

struct ConvertOptions {
    std::vector<std::filesystem::path> files;
    std::string from;  ///< opencv, ros, kalibr or kitti: the files are theirs
    std::string to;    ///< opencv, ros or kalibr: the files are a rig file and a folder
    std::optional<std::filesystem::path> out;
    std::optional<std::string> size;  ///< W,H of the pictures
};

/// Rig files from other programs' calibrations and back. Where a format does not tell the pictures'
/// size and --size is not given, a picture that lies beside the files is looked at (KITTI's left/,
/// image_0/, image_2/). Tells what the other format has no place for. JSON: width_px, height_px,
/// baseline_mm, out; or worst_residual_px, left_out, out.
Outcome run_convert(const ConvertOptions& options);

}  // namespace kambara::cli
