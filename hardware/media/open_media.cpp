// SPDX-License-Identifier: GPL-3.0-or-later
#include "hardware/media/open_media.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <system_error>

#include "hardware/media/picture_grabber.h"
#include "hardware/media/video_grabber.h"

namespace kambara {
namespace {

bool names_pictures(const std::string& source) {
    std::error_code code;
    if (source.find_first_of("*?%") != std::string::npos &&
        !std::filesystem::exists(source, code)) {
        return true;
    }
    constexpr std::array endings{".png", ".jpg", ".jpeg", ".pgm",  ".ppm",
                                 ".bmp", ".tif", ".tiff", ".webp", ".pnm"};
    std::string ending = std::filesystem::path(source).extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return std::find(endings.begin(), endings.end(), ending) != endings.end();
}

}  // namespace

Result<std::unique_ptr<GrabberBase>> open_media(const std::string& source,
                                                const MediaOptions& options) {
    if (options.start < 0) {
        return Error{"Frame " + std::to_string(options.start) + " does not exist.",
                     "Frames are numbered from 0: start at 0 or later."};
    }
    return names_pictures(source) ? PictureGrabber::open(source, options)
                                  : VideoGrabber::open(source, options);
}

}  // namespace kambara
