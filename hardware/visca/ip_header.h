// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "hardware/visca/packet.h"

namespace kambara::visca {

/// The header that VISCA packets carry over UDP port 52381 (visca: VISCA over IP): type, payload
/// length and sequence number, each with its upper byte first.
enum class PayloadType : std::uint16_t {
    command = 0x0100,
    inquiry = 0x0110,
    reply = 0x0111,
    device_setting = 0x0120,
    control = 0x0200,
    control_reply = 0x0201,
};

inline constexpr std::size_t ip_header_size = 8;

struct Datagram {
    PayloadType type = PayloadType::command;
    std::uint32_t sequence = 0;
    Bytes payload;
    bool operator==(const Datagram&) const = default;
};

/// What a control reply complains of.
enum class ControlFault { sequence_abnormal, message_abnormal };

Bytes encode(const Datagram& datagram);
/// Empty where there is no such header, or its length is not the payload's: then the bytes may be a
/// packet without one.
std::optional<Datagram> decode_datagram(std::span<const std::uint8_t> bytes);

/// The type under which a packet to the camera goes.
PayloadType type_of_packet(std::span<const std::uint8_t> packet);

Datagram sequence_reset();
std::optional<ControlFault> control_fault(const Datagram& datagram);
Datagram complaint(ControlFault fault, std::uint32_t sequence);

}  // namespace kambara::visca
