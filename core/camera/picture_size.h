// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace kambara {

/// The width and height of a picture, in pixels.
struct PictureSize {
    int width_px = 0;
    int height_px = 0;

    bool operator==(const PictureSize&) const = default;
};

}  // namespace kambara
