// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/calibration/session/session_setup.h"
#include "core/calibration/session/shot_checks.h"

namespace kambara {

/// Writes a picture in the format of the name's ending; the file appears whole or not at all.
/// The port to whoever knows picture files.
using PictureWriter = std::function<Result<Done>(const std::filesystem::path&, const Image&)>;

/// A session folder's content (resources/README.md: calibration session). Pictures lie in a folder
/// for each camera, shots' corners in `shots`, the rest beside them.
struct SessionContent {
    SessionSetup setup;
    std::vector<Shot> shots;  ///< in the order of their numbers
    std::vector<Decision> decisions;
    std::optional<Rig> solved;  ///< the last rig that was not refused
    double noise_px = 0.1;      ///< of a coordinate, as that solution had it
};

/// Begins a folder; refuses one that holds a session already.
Result<Done> begin_session_folder(const std::filesystem::path& folder, const SessionSetup& setup);

/// Where a shot's picture of a camera (as camera_names counts) lies.
std::filesystem::path shot_picture_file(const std::filesystem::path& folder, std::size_t camera,
                                        int shot);

/// Adds a shot: pictures first, the corners last, so that a shot is there whole or not at all.
Result<Done> write_shot(const std::filesystem::path& folder, const Shot& shot,
                        const PictureSet& pictures, const PictureWriter& write_picture);

/// Writes what may change but for the shots: decisions and noise.
Result<Done> write_session_state(const std::filesystem::path& folder,
                                 const SessionContent& content);

/// Writes the rig last solved for.
Result<Done> write_session_rig(const std::filesystem::path& folder, const Rig& rig);

/// Reads a folder back; shots that were written after the state count as kept. Refuses, naming
/// file and key, what is missing or can't be.
Result<SessionContent> read_session_folder(const std::filesystem::path& folder);

/// A shot's corners as text (YAML) and back, with all digits; `corners`: how many the target has.
std::string shot_to_text(const Shot& shot);
Result<Shot> shot_from_text(std::string_view text, int corners);

}  // namespace kambara
