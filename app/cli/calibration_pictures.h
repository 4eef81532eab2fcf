// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "app/cli/terminal.h"
#include "core/base/result.h"
#include "core/calibration/rig_calibrator.h"
#include "core/image/image.h"

namespace kambara::cli {

/// The files of a calibration: for each camera as many as there are views, or none.
struct CalibrationFiles {
    std::array<std::vector<std::filesystem::path>, most_cameras> of_camera;
    std::size_t views() const { return of_camera[0].size(); }
};

/// The files that the patterns name, left, right, pan-tilt; an empty pattern: no such camera.
/// Refuses lists of different length.
Result<CalibrationFiles> calibration_files(const std::array<std::string, most_cameras>& patterns);

/// A picture's name and its content's hash (FNV-1a, 64 bits), as rig files keep them.
std::string picture_mark(const std::filesystem::path& file, const Image& picture);

/// What the target detector finds in them, and the pictures' sizes.
struct CalibrationViews {
    std::vector<RigView> views;
    std::array<std::optional<PictureSize>, most_cameras> sizes;
    std::vector<std::string> marks;  ///< each picture's name and the hash of its content
};

/// Reads all pictures and looks for the target in them, on all cores. Refuses pictures that can't
/// be read, and a camera's pictures of different sizes.
Result<CalibrationViews> look_at_all(const CalibrationFiles& files, const Target& target,
                                     ProgressLine& progress);

}  // namespace kambara::cli
