// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/rectangle.h"

#include <array>
#include <charconv>

namespace kambara {

bool Rectangle::inside(int image_width, int image_height) const {
    return x >= 0 && y >= 0 && width > 0 && height > 0 && width <= image_width &&
           height <= image_height && x <= image_width - width && y <= image_height - height;
}

Result<Rectangle> parse_rectangle(std::string_view text) {
    const auto refused = [&](const std::string& why) {
        return Error{"The rectangle \"" + std::string(text) + "\" " + why + ".",
                     "Give it as X,Y,W,H in whole pixels, X,Y the top-left one, for example "
                     "300,200,31,31."};
    };
    std::array<int, 4> numbers{};
    const char* at = text.data();
    const char* const end = text.data() + text.size();
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (i > 0) {
            if (at == end || *at != ',') {
                return refused("does not have four numbers");
            }
            ++at;
        }
        const auto [stopped, code] = std::from_chars(at, end, numbers[i]);
        if (code != std::errc{}) {
            return refused("is not made of whole numbers");
        }
        at = stopped;
    }
    if (at != end) {
        return refused("has something after its four numbers");
    }
    if (numbers[2] <= 0 || numbers[3] <= 0) {
        return refused("has no area");
    }
    return Rectangle{numbers[0], numbers[1], numbers[2], numbers[3]};
}

std::string to_string(const Rectangle& r) {
    return std::to_string(r.x) + "," + std::to_string(r.y) + "," + std::to_string(r.width) + "," +
           std::to_string(r.height);
}

}  // namespace kambara
