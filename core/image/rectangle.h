// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"

namespace kambara {

/// A rectangle of whole pixels; (x, y) is its top-left pixel.
struct Rectangle {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;

    /// The mean of its pixels' coordinates: the reference point of a template.
    double centre_x_px() const { return x + 0.5 * (width - 1); }
    double centre_y_px() const { return y + 0.5 * (height - 1); }
    bool inside(int image_width, int image_height) const;
    bool operator==(const Rectangle&) const = default;
};

/// Reads `X,Y,W,H`: four whole numbers, the last two positive.
Result<Rectangle> parse_rectangle(std::string_view text);

std::string to_string(const Rectangle& rectangle);

}  // namespace kambara
