// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/image.h"

#include <stdexcept>

namespace kambara {

Image::Image(int width, int height, int channels, std::uint8_t value)
    : width_(width), height_(height), channels_(channels) {
    if (width < 0 || height < 0 || (channels != 1 && channels != 3)) {
        throw std::invalid_argument("kambara::Image: impossible size or number of channels");
    }
    pixels_.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
                       static_cast<std::size_t>(channels),
                   value);
}

Image grey_from(const Image& picture) {
    if (picture.channels() == 1) {
        return picture;
    }
    Image grey(picture.width(), picture.height());
    for (int y = 0; y < picture.height(); ++y) {
        const std::uint8_t* in = picture.row(y);
        std::uint8_t* out = grey.row(y);
        for (int x = 0; x < picture.width(); ++x, in += 3) {
            out[x] =
                static_cast<std::uint8_t>((114 * in[0] + 587 * in[1] + 299 * in[2] + 500) / 1000);
        }
    }
    return grey;
}

ImagePtr grey_from(const ImagePtr& picture) {
    if (!picture || picture->channels() == 1) {
        return picture;
    }
    return std::make_shared<const Image>(grey_from(*picture));
}

}  // namespace kambara
