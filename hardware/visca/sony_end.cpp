// SPDX-License-Identifier: GPL-3.0-or-later
#include "hardware/visca/sony_end.h"

#include <algorithm>

namespace kambara::visca {
namespace {

constexpr std::size_t numbers_remembered = 32;

}  // namespace

SonyEnd::Taken SonyEnd::take(std::span<const std::uint8_t> bytes) {
    const auto datagram = decode_datagram(bytes);
    if (!datagram) {
        return {std::nullopt, Bytes(bytes.begin(), bytes.end()), 0, false};
    }
    const std::uint32_t sequence = datagram->sequence;
    const auto answer = [&](const Datagram& reply) {
        return Taken{encode(reply), std::nullopt, sequence, true};
    };
    if (datagram->type == PayloadType::control) {
        if (datagram->payload != sequence_reset().payload) {
            return answer(complaint(ControlFault::message_abnormal, sequence));
        }
        had_.clear();
        return answer({PayloadType::control_reply, sequence, datagram->payload});
    }
    if (datagram->type == PayloadType::reply || datagram->type == PayloadType::control_reply ||
        datagram->payload.empty() || datagram->payload.size() > longest_packet) {
        return answer(complaint(ControlFault::message_abnormal, sequence));
    }
    if (std::find(had_.begin(), had_.end(), sequence) != had_.end()) {
        return answer(complaint(ControlFault::sequence_abnormal, sequence));
    }
    had_.push_back(sequence);
    if (had_.size() > numbers_remembered) {
        had_.pop_front();
    }
    return {std::nullopt, datagram->payload, sequence, true};
}

Bytes SonyEnd::reply(const Bytes& packet, std::uint32_t sequence) {
    return encode(Datagram{PayloadType::reply, sequence, packet});
}

}  // namespace kambara::visca
