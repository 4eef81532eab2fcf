// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "core/base/result.h"
#include "core/devices/grabber_base.h"

namespace kambara {

struct MediaOptions {
    std::int64_t start = 0;          ///< the first frame to deliver; numbering is kept
    double pictures_rate_hz = 10.0;  ///< time stamps of single pictures, which carry none
};

/// Opens a recording: a pattern of pictures (see files_of_pattern), one picture, or a video file.
/// A name that exists is that file, whatever characters it has; a folder is refused.
/// All frames have the first one's size; one that differs, a picture that can't be read, and a
/// video that ends before the number of frames it announces make grab() fail with the reason (the
/// last frame before a cut may be damaged). Containers that announce a duration instead are only
/// held to it where the file itself is cut short.
Result<std::unique_ptr<GrabberBase>> open_media(const std::string& source,
                                                const MediaOptions& options = {});

}  // namespace kambara
