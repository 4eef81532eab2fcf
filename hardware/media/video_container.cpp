// SPDX-License-Identifier: GPL-3.0-or-later
#include "hardware/media/video_container.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>

namespace kambara {
namespace {

// Random access to the file's bytes; zero past its end.
class Bytes {
  public:
    explicit Bytes(const std::filesystem::path& file) : stream_(file, std::ios::binary) {
        stream_.seekg(0, std::ios::end);
        const auto end = stream_.tellg();
        size_ = end > 0 ? static_cast<std::uint64_t>(end) : 0;
    }

    std::uint64_t size() const { return size_; }

    std::uint64_t at(std::uint64_t place) {
        if (place >= size_) {
            return 0;
        }
        stream_.seekg(static_cast<std::streamoff>(place));
        return static_cast<std::uint64_t>(stream_.get());
    }

    std::uint64_t big_endian(std::uint64_t place, int bytes) {
        std::uint64_t value = 0;
        for (int i = 0; i < bytes; ++i) {
            value = (value << 8) | at(place + static_cast<std::uint64_t>(i));
        }
        return value;
    }

    std::uint64_t little_endian_32(std::uint64_t place) {
        return at(place) | at(place + 1) << 8 | at(place + 2) << 16 | at(place + 3) << 24;
    }

    std::string text(std::uint64_t place) {
        std::string four;
        for (std::uint64_t i = 0; i < 4; ++i) {
            four += static_cast<char>(at(place + i));
        }
        return four;
    }

  private:
    std::ifstream stream_;
    std::uint64_t size_ = 0;
};

VideoContainer avi(Bytes& bytes) {
    return {true, bytes.little_endian_32(4) + 8 > bytes.size()};
}

// MP4 and MOV: boxes one after the other, each with its length. A length of 1 is followed by a long
// one, a length of 0 means "to the end of the file".
VideoContainer boxes(Bytes& bytes) {
    std::uint64_t at = 0;
    while (at + 8 <= bytes.size()) {
        std::uint64_t length = bytes.big_endian(at, 4);
        if (length == 1) {
            length = bytes.big_endian(at + 8, 8);
        }
        if (length == 0) {
            return {true, false};
        }
        if (length < 8 || length > bytes.size() - at) {
            return {true, length >= 8};
        }
        at += length;
    }
    return {true, at < bytes.size()};
}

// A Matroska length: the position of the first byte's highest one tells how many bytes it takes;
// all further bits set means that the length is not known.
struct Length {
    std::optional<std::uint64_t> value;
    std::uint64_t own_bytes = 0;
};

Length matroska_length(Bytes& bytes, std::uint64_t place) {
    int own = 1;
    for (std::uint64_t mask = 0x80; own <= 8 && (bytes.at(place) & mask) == 0; mask >>= 1) {
        ++own;
    }
    if (own > 8) {
        return {};
    }
    const std::uint64_t all_ones = (std::uint64_t{1} << (7 * own)) - 1;
    const std::uint64_t value = bytes.big_endian(place, own) & all_ones;
    return {value == all_ones ? std::nullopt : std::optional(value),
            static_cast<std::uint64_t>(own)};
}

VideoContainer matroska(Bytes& bytes) {
    const Length header = matroska_length(bytes, 4);
    if (!header.value) {
        return {};
    }
    const std::uint64_t segment = 4 + header.own_bytes + *header.value;
    constexpr std::uint64_t segment_id = 0x18538067;
    if (bytes.big_endian(segment, 4) != segment_id) {
        return {false, segment >= bytes.size()};
    }
    const Length length = matroska_length(bytes, segment + 4);
    const std::uint64_t begin = segment + 4 + length.own_bytes;
    return {false, length.value && (begin >= bytes.size() || *length.value > bytes.size() - begin)};
}

}  // namespace

VideoContainer video_container(const std::filesystem::path& file) {
    Bytes bytes(file);
    constexpr std::uint64_t matroska_signature = 0x1A45DFA3;
    if (bytes.text(0) == "RIFF" && bytes.text(8) == "AVI ") {
        return avi(bytes);
    }
    if (bytes.big_endian(0, 4) == matroska_signature) {
        return matroska(bytes);
    }
    constexpr std::array<std::string_view, 6> first_boxes{"ftyp", "moov", "mdat",
                                                          "free", "wide", "skip"};
    if (std::find(first_boxes.begin(), first_boxes.end(), bytes.text(4)) != first_boxes.end()) {
        return boxes(bytes);
    }
    return {};
}

}  // namespace kambara
