// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace kambara::visca {

using Bytes = std::vector<std::uint8_t>;

/// A packet is a header, 1 to 14 message bytes and the terminator (visca: wire format).
inline constexpr std::uint8_t terminator = 0xFF;
inline constexpr std::size_t shortest_packet = 3;
inline constexpr std::size_t longest_packet = 16;
inline constexpr int broadcast_address = 8;
inline constexpr int most_cameras = 7;

/// "81 01 04" and "810104" alike; empty where that is no text of whole bytes.
std::optional<Bytes> bytes_from_hex(std::string_view text);
std::string hex_from_bytes(std::span<const std::uint8_t> bytes);

/// Cuts a stream of bytes into packets: what a header byte (0x80 and above) begins and the
/// terminator ends. Bytes before a header, and packets that are too short or too long, are thrown
/// away up to the next terminator and counted, so that after damage the next whole packet is read
/// right.
class PacketReader {
  public:
    /// Packets that are complete by these bytes, in their order.
    std::vector<Bytes> read(std::span<const std::uint8_t> bytes);
    /// Forgets a packet that has begun.
    void reset() { begun_.clear(); }
    std::uint64_t bytes_thrown_away() const { return thrown_away_; }
    /// Packets with more than 14 message bytes: a camera answers them with an error.
    std::uint64_t too_long() const { return too_long_; }

  private:
    Bytes begun_;
    bool skipping_ = false;
    std::uint64_t thrown_away_ = 0;
    std::uint64_t too_long_ = 0;
};

}  // namespace kambara::visca
