// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as what a camera and what a controller says, as datagrams, as a head's URI and as a
// table of heads. What is understood is written again as it was; the simulated camera stays within
// its stops, and the session is never stuck.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "hardware/visca/evi_simulator.h"
#include "hardware/visca/head_kind.h"
#include "hardware/visca/head_uri.h"
#include "hardware/visca/session.h"
#include "hardware/visca/sony_end.h"

namespace {

using namespace kambara::visca;

constexpr std::int64_t ms = 1'000'000;

void require(bool holds) {
    if (!holds) {
        std::abort();
    }
}

void as_packets(std::span<const std::uint8_t> bytes) {
    for (const Bytes& packet : PacketReader().read(bytes)) {
        require(packet.size() >= shortest_packet && packet.size() <= longest_packet);
        if (const auto reply = decode_reply(packet)) {
            require(encode(*reply) == packet);
        }
        for (const Dialect& dialect : {Dialect{}, Dialect{5, 0x11}}) {
            if (const auto message = decode_message(packet, dialect)) {
                require(encode(message->message, message->address, dialect) == packet);
            }
            for (const Op op : all_ops()) {
                const std::span<const std::uint8_t> data(packet.data() + 1, packet.size() - 2);
                if (const auto values = decode_answer(op, data, dialect)) {
                    const Bytes again = encode_answer(op, *values, dialect);
                    require(again == Bytes(data.begin(), data.end()));
                }
            }
        }
    }
}

void to_camera(std::span<const std::uint8_t> bytes) {
    EviSimulator camera(0);
    std::int64_t now_ns = 0;
    for (const Bytes& packet : PacketReader().read(bytes)) {
        camera.receive(packet, 1, now_ns);
        now_ns += 40 * ms;
        for (const auto& output : camera.advance(now_ns)) {
            require(decode_reply(output.packet).has_value());
        }
        const auto state = camera.state();
        require(state.sockets_in_use <= 2 && std::abs(state.pan_steps) <= 880.0 &&
                std::abs(state.tilt_steps) <= 300.0 && state.zoom >= 0.0 && state.zoom <= 0x3FF);
    }
    SonyEnd().take(bytes);
    if (const auto datagram = decode_datagram(bytes)) {
        require(encode(*datagram) == Bytes(bytes.begin(), bytes.end()));
    }
}

// Whatever a camera said before: one that answers properly from now on is understood.
void to_session(std::span<const std::uint8_t> bytes, Wiring wiring) {
    Session::Options options;
    options.wiring = wiring;
    Session session(options);
    std::int64_t now_ns = 0;
    session.open(now_ns);
    while (!bytes.empty()) {
        const std::size_t size = 1 + bytes[0] % std::min<std::size_t>(bytes.size(), 20);
        session.receive(bytes.first(size), now_ns);
        bytes = bytes.subspan(size);
        now_ns += 10 * ms;
        session.tick(now_ns);
        if (session.free(now_ns)) {
            session.send(bytes.size() % 2 == 0 ? Message{Op::home} : Message{Op::ask_position},
                         now_ns);
        }
        session.take_output();
        session.take_outcomes();
        session.take_notes();
    }
    if (wiring != Wiring::serial) {
        return;
    }
    EviSimulator camera(now_ns);
    PacketReader reader;
    const std::int64_t until_ns = now_ns + 20'000 * ms;
    while (now_ns < until_ns && !(session.ready() && session.free(now_ns))) {
        for (const Bytes& packet : session.take_output()) {
            camera.receive(packet, 1, now_ns);
        }
        now_ns += 5 * ms;
        for (const auto& output : camera.advance(now_ns)) {
            session.receive(output.packet, now_ns);
        }
        session.tick(now_ns);
    }
    require(session.ready());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::span<const std::uint8_t> bytes(data, size);
    as_packets(bytes);
    to_camera(bytes);
    for (const Wiring wiring : {Wiring::serial, Wiring::udp, Wiring::udp_sony}) {
        to_session(bytes, wiring);
    }
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    (void)parse_head_uri(text).ok();
    if (const auto heads = heads_from_text(text)) {
        for (const HeadKind& head : *heads) {
            require(std::isfinite(head.zoom.horizontal_view_rad(head.zoom.tele / 2)));
            encode({Op::absolute,
                    {head.pan.fastest_code, head.tilt.fastest_code, head.pan.steps_from_deg(1e3),
                     head.tilt.steps_from_deg(-1e3)}},
                   1, head.dialect());
        }
    }
    return 0;
}
