// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>

#include "hardware/visca/packet.h"

namespace kambara::visca {

/// What a camera says (visca: replies, sockets, errors).

/// To the broadcast of addresses: the number the next camera in the chain would have.
struct AddressesSet {
    int next = 2;
    bool operator==(const AddressesSet&) const = default;
};
/// The broadcast interface clear has gone around the chain.
struct InterfaceCleared {
    bool operator==(const InterfaceCleared&) const = default;
};
/// Power was applied or the chain changed: the addresses must be set again.
struct NetworkChanged {
    bool operator==(const NetworkChanged&) const = default;
};
struct Acknowledged {
    int socket = 1;
    bool operator==(const Acknowledged&) const = default;
};
/// Without data: a command is done (or, with socket 0, an interface clear). With: an answer.
struct Completed {
    int socket = 1;
    Bytes data;
    bool operator==(const Completed&) const = default;
};
enum class Fault : std::uint8_t {
    message_length = 0x01,
    syntax = 0x02,
    buffer_full = 0x03,
    cancelled = 0x04,
    no_socket = 0x05,
    not_executable = 0x41,
};
struct Refused {
    int socket = 0;
    Fault fault = Fault::syntax;
    bool operator==(const Refused&) const = default;
};

using Reply =
    std::variant<AddressesSet, InterfaceCleared, NetworkChanged, Acknowledged, Completed, Refused>;

struct ReplyFrom {
    Reply reply;
    int address = 1;  ///< the camera's; broadcast_address for what goes around the chain
    bool operator==(const ReplyFrom&) const = default;
};

/// From a whole packet; empty for what is no reply.
std::optional<ReplyFrom> decode_reply(std::span<const std::uint8_t> packet);
Bytes encode(const ReplyFrom& reply);

/// For people: "command buffer full".
std::string name_of(Fault fault);

}  // namespace kambara::visca
