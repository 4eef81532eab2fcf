// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace kambara {

/// A picture of 8-bit pixels: 1 channel (grey) or 3 (blue, green, red, interleaved). Rows follow
/// each other without gaps. Pixel (0, 0) is the top-left one, and its coordinates name its centre.
class Image {
  public:
    Image() = default;
    Image(int width, int height, int channels = 1, std::uint8_t value = 0);

    int width() const { return width_; }
    int height() const { return height_; }
    int channels() const { return channels_; }
    bool empty() const { return pixels_.empty(); }
    std::size_t row_bytes() const {
        return static_cast<std::size_t>(width_) * static_cast<std::size_t>(channels_);
    }

    std::uint8_t* row(int y) { return pixels_.data() + static_cast<std::size_t>(y) * row_bytes(); }
    const std::uint8_t* row(int y) const {
        return pixels_.data() + static_cast<std::size_t>(y) * row_bytes();
    }
    std::uint8_t& at(int x, int y, int channel = 0) { return row(y)[x * channels_ + channel]; }
    std::uint8_t at(int x, int y, int channel = 0) const { return row(y)[x * channels_ + channel]; }
    bool contains(int x, int y) const { return x >= 0 && y >= 0 && x < width_ && y < height_; }

    bool operator==(const Image&) const = default;

  private:
    int width_ = 0;
    int height_ = 0;
    int channels_ = 1;
    std::vector<std::uint8_t> pixels_;
};

/// Pictures are shared without copies once they are made; nobody writes to a shared one.
using ImagePtr = std::shared_ptr<const Image>;

/// The picture in grey: itself when it has one channel, else 0.299 R + 0.587 G + 0.114 B rounded
/// (ITU-R BT.601).
Image grey_from(const Image& picture);

/// As above, sharing the picture when it is grey already.
ImagePtr grey_from(const ImagePtr& picture);

}  // namespace kambara
