// SPDX-License-Identifier: GPL-3.0-or-later
#include "hardware/visca/packet.h"

namespace kambara::visca {
namespace {

constexpr std::string_view hex_digits = "0123456789ABCDEF";

int value_of(char digit) {
    if (digit >= '0' && digit <= '9') {
        return digit - '0';
    }
    if (digit >= 'A' && digit <= 'F') {
        return digit - 'A' + 10;
    }
    if (digit >= 'a' && digit <= 'f') {
        return digit - 'a' + 10;
    }
    return -1;
}

}  // namespace

std::optional<Bytes> bytes_from_hex(std::string_view text) {
    Bytes bytes;
    for (std::size_t i = 0; i < text.size();) {
        if (text[i] == ' ') {
            ++i;
            continue;
        }
        if (i + 1 >= text.size() || value_of(text[i]) < 0 || value_of(text[i + 1]) < 0) {
            return std::nullopt;
        }
        bytes.push_back(static_cast<std::uint8_t>(16 * value_of(text[i]) + value_of(text[i + 1])));
        i += 2;
    }
    return bytes;
}

std::string hex_from_bytes(std::span<const std::uint8_t> bytes) {
    std::string text;
    for (const std::uint8_t byte : bytes) {
        text += text.empty() ? "" : " ";
        text += hex_digits[byte >> 4];
        text += hex_digits[byte & 0x0F];
    }
    return text;
}

std::vector<Bytes> PacketReader::read(std::span<const std::uint8_t> bytes) {
    std::vector<Bytes> packets;
    for (const std::uint8_t byte : bytes) {
        if (skipping_ || (begun_.empty() && (byte < 0x80 || byte == terminator))) {
            skipping_ = byte != terminator;
            ++thrown_away_;
            continue;
        }
        begun_.push_back(byte);
        if (byte == terminator) {
            if (begun_.size() >= shortest_packet) {
                packets.push_back(begun_);
            } else {
                thrown_away_ += begun_.size();
            }
            begun_.clear();
        } else if (begun_.size() == longest_packet) {
            thrown_away_ += begun_.size();
            ++too_long_;
            begun_.clear();
            skipping_ = true;
        }
    }
    return packets;
}

}  // namespace kambara::visca
