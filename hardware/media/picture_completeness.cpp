// SPDX-License-Identifier: GPL-3.0-or-later
#include "hardware/media/picture_completeness.h"

#include <cstddef>

namespace kambara {
namespace {

constexpr std::string_view png_signature("\x89PNG\r\n\x1a\n", 8);

unsigned byte_at(std::string_view bytes, std::size_t at) {
    return static_cast<unsigned char>(bytes[at]);
}

bool is_restart(unsigned marker) {
    return marker >= 0xD0 && marker <= 0xD7;
}

// The next place at which a marker stands: 0xFF, then neither a stuffed zero nor a fill byte.
std::size_t next_marker(std::string_view bytes, std::size_t at) {
    while (at + 1 < bytes.size()) {
        const unsigned next = byte_at(bytes, at + 1);
        if (byte_at(bytes, at) == 0xFF && next != 0x00 && next != 0xFF) {
            return at;
        }
        ++at;
    }
    return bytes.size();
}

// Segments are stepped over by their lengths, since a preview inside one has an end of its own;
// the compressed data after a start of scan has no length and is searched for the next marker.
bool jpeg_ends(std::string_view bytes) {
    std::size_t at = 2;
    while ((at = next_marker(bytes, at)) < bytes.size()) {
        const unsigned marker = byte_at(bytes, at + 1);
        at += 2;
        if (marker == 0xD9) {
            return true;
        }
        if (is_restart(marker) || marker == 0x01) {
            continue;
        }
        if (at + 2 > bytes.size()) {
            return false;
        }
        at += (byte_at(bytes, at) << 8) + byte_at(bytes, at + 1);
    }
    return false;
}

bool png_ends(std::string_view bytes) {
    constexpr std::size_t frame_bytes = 12;  // length, type and checksum around a chunk's data
    std::size_t at = png_signature.size();
    while (at + frame_bytes <= bytes.size()) {
        std::size_t length = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            length = (length << 8) + byte_at(bytes, at + i);
        }
        if (bytes.substr(at + 4, 4) == "IEND") {
            return true;
        }
        at += frame_bytes + length;
    }
    return false;
}

}  // namespace

bool is_cut_short(std::string_view bytes) {
    if (bytes.starts_with("\xFF\xD8\xFF")) {
        return !jpeg_ends(bytes);
    }
    return bytes.starts_with(png_signature) && !png_ends(bytes);
}

}  // namespace kambara
