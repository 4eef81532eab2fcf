// SPDX-License-Identifier: GPL-3.0-or-later
#include "hardware/visca/reply.h"

namespace kambara::visca {
namespace {

constexpr std::uint8_t broadcast_header = 0x88;

bool is_fault(std::uint8_t code) {
    return (code >= 0x01 && code <= 0x05) || code == 0x41;
}

std::optional<Reply> from_camera(std::span<const std::uint8_t> message) {
    const std::uint8_t first = message[0];
    const int socket = first & 0x0F;
    switch (first >> 4) {
        case 3:
            if (first == 0x38 && message.size() == 1) {
                return NetworkChanged{};
            }
            return std::nullopt;
        case 4:
            if (message.size() == 1) {
                return Acknowledged{socket};
            }
            return std::nullopt;
        case 5:
            return Completed{socket, Bytes(message.begin() + 1, message.end())};
        case 6:
            if (message.size() == 2 && is_fault(message[1])) {
                return Refused{socket, static_cast<Fault>(message[1])};
            }
            return std::nullopt;
        default:
            return std::nullopt;
    }
}

std::optional<Reply> from_chain(std::span<const std::uint8_t> message) {
    if (message.size() == 2 && message[0] == 0x30 && message[1] >= 1 && message[1] <= 8) {
        return AddressesSet{message[1]};
    }
    if (message.size() == 3 && message[0] == 0x01 && message[1] == 0x00 && message[2] == 0x01) {
        return InterfaceCleared{};
    }
    return std::nullopt;
}

struct MessageOf {
    static std::uint8_t with_socket(int upper, int socket) {
        return static_cast<std::uint8_t>(upper | (socket & 0x0F));
    }
    Bytes operator()(const AddressesSet& reply) const {
        return {0x30, static_cast<std::uint8_t>(reply.next)};
    }
    Bytes operator()(const InterfaceCleared&) const { return {0x01, 0x00, 0x01}; }
    Bytes operator()(const NetworkChanged&) const { return {0x38}; }
    Bytes operator()(const Acknowledged& reply) const { return {with_socket(0x40, reply.socket)}; }
    Bytes operator()(const Completed& reply) const {
        Bytes message{with_socket(0x50, reply.socket)};
        message.insert(message.end(), reply.data.begin(), reply.data.end());
        return message;
    }
    Bytes operator()(const Refused& reply) const {
        return {with_socket(0x60, reply.socket), static_cast<std::uint8_t>(reply.fault)};
    }
};

}  // namespace

std::optional<ReplyFrom> decode_reply(std::span<const std::uint8_t> packet) {
    if (packet.size() < shortest_packet || packet.size() > longest_packet ||
        packet.back() != terminator) {
        return std::nullopt;
    }
    const auto message = packet.subspan(1, packet.size() - 2);
    if (packet[0] == broadcast_header) {
        if (auto reply = from_chain(message)) {
            return ReplyFrom{std::move(*reply), broadcast_address};
        }
        return std::nullopt;
    }
    // 1 sss 0 000: from camera s to the controller.
    const int address = (packet[0] >> 4) - 8;
    if ((packet[0] & 0x8F) != 0x80 || address < 1) {
        return std::nullopt;
    }
    if (auto reply = from_camera(message)) {
        return ReplyFrom{std::move(*reply), address};
    }
    return std::nullopt;
}

Bytes encode(const ReplyFrom& reply) {
    Bytes packet{reply.address == broadcast_address
                     ? broadcast_header
                     : static_cast<std::uint8_t>((reply.address + 8) << 4)};
    const Bytes message = std::visit(MessageOf{}, reply.reply);
    packet.insert(packet.end(), message.begin(), message.end());
    packet.push_back(terminator);
    return packet;
}

std::string name_of(Fault fault) {
    switch (fault) {
        case Fault::message_length:
            return "message length error";
        case Fault::syntax:
            return "syntax error";
        case Fault::buffer_full:
            return "command buffer full";
        case Fault::cancelled:
            return "command cancelled";
        case Fault::no_socket:
            return "no such socket";
        case Fault::not_executable:
            return "command not executable";
    }
    return "unknown error";
}

}  // namespace kambara::visca
