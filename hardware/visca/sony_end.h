// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <span>

#include "hardware/visca/ip_header.h"

namespace kambara::visca {

/// A camera's end of VISCA over UDP with Sony's header: takes datagrams apart and remembers which
/// sequence numbers it has had.
class SonyEnd {
  public:
    struct Taken {
        std::optional<Bytes> answer;  ///< a datagram to send back at once
        std::optional<Bytes> packet;  ///< for the camera
        std::uint32_t sequence = 0;   ///< of the packet
        bool has_header = false;
    };

    Taken take(std::span<const std::uint8_t> bytes);
    /// The camera's reply to a packet.
    static Bytes reply(const Bytes& packet, std::uint32_t sequence);

  private:
    std::deque<std::uint32_t> had_;
};

}  // namespace kambara::visca
