// SPDX-License-Identifier: GPL-3.0-or-later
#include "hardware/visca/ip_header.h"

namespace kambara::visca {
namespace {

constexpr std::uint8_t reset_code = 0x01;
constexpr std::uint8_t fault_code = 0x0F;

bool is_type(unsigned type) {
    switch (static_cast<PayloadType>(type)) {
        case PayloadType::command:
        case PayloadType::inquiry:
        case PayloadType::reply:
        case PayloadType::device_setting:
        case PayloadType::control:
        case PayloadType::control_reply:
            return true;
    }
    return false;
}

}  // namespace

Bytes encode(const Datagram& datagram) {
    const auto type = static_cast<unsigned>(datagram.type);
    const auto length = static_cast<unsigned>(datagram.payload.size());
    Bytes bytes;
    for (const unsigned half : {type, length, datagram.sequence >> 16, datagram.sequence}) {
        bytes.push_back(static_cast<std::uint8_t>((half >> 8) & 0xFF));
        bytes.push_back(static_cast<std::uint8_t>(half & 0xFF));
    }
    bytes.insert(bytes.end(), datagram.payload.begin(), datagram.payload.end());
    return bytes;
}

std::optional<Datagram> decode_datagram(std::span<const std::uint8_t> bytes) {
    if (bytes.size() < ip_header_size) {
        return std::nullopt;
    }
    const auto half = [&](std::size_t at) {
        return static_cast<unsigned>(bytes[at]) << 8 | bytes[at + 1];
    };
    if (!is_type(half(0)) || half(2) != bytes.size() - ip_header_size) {
        return std::nullopt;
    }
    return Datagram{static_cast<PayloadType>(half(0)), half(4) << 16 | half(6),
                    Bytes(bytes.begin() + ip_header_size, bytes.end())};
}

PayloadType type_of_packet(std::span<const std::uint8_t> packet) {
    const bool inquiry = packet.size() > 2 && packet[1] == 0x09;
    const bool clear = packet.size() == 5 && packet[1] == 0x01 && packet[2] == 0x00;
    const bool version = inquiry && packet.size() == 5 && packet[2] == 0x00;
    if (clear || version) {
        return PayloadType::device_setting;
    }
    return inquiry ? PayloadType::inquiry : PayloadType::command;
}

Datagram sequence_reset() {
    return {PayloadType::control, 0, {reset_code}};
}

std::optional<ControlFault> control_fault(const Datagram& datagram) {
    if (datagram.type != PayloadType::control_reply || datagram.payload.size() != 2 ||
        datagram.payload[0] != fault_code || datagram.payload[1] < 1 || datagram.payload[1] > 2) {
        return std::nullopt;
    }
    return datagram.payload[1] == 1 ? ControlFault::sequence_abnormal
                                    : ControlFault::message_abnormal;
}

Datagram complaint(ControlFault fault, std::uint32_t sequence) {
    return {
        PayloadType::control_reply,
        sequence,
        {fault_code, static_cast<std::uint8_t>(fault == ControlFault::sequence_abnormal ? 1 : 2)}};
}

}  // namespace kambara::visca
