// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace kambara {

/// What the container of a video file says about its own length.
struct VideoContainer {
    bool counts_frames = false;  ///< the number of frames is stored (AVI, MP4, MOV); in others the
                                 ///< decoder derives it from a duration, which sound may lengthen
    bool cut_short = false;      ///< it claims more bytes than the file has
};

/// Reads the outermost sizes of AVI, MP4, MOV and Matroska files; any other file, or one that can't
/// be read, makes no claim.
VideoContainer video_container(const std::filesystem::path& file);

}  // namespace kambara
