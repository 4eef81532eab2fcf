// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <random>
#include <span>
#include <vector>

#include "hardware/visca/packet.h"

namespace kambara::visca {

/// What goes wrong on a line, on purpose. Shares are of 1.
struct LineFaults {
    double lost_bytes = 0.0;
    double doubled_bytes = 0.0;
    double garbled_bytes = 0.0;
    double late_packets = 0.0;
    double late_s = 0.3;
    double unplug_every_s = 0.0;  ///< 0: never
    double unplug_for_s = 2.0;    ///< at the end of each such span
    std::uint64_t seed = 1;
};

/// Whether the plug is in at a time (counted from the line's beginning), and when that changes.
bool is_plugged(const LineFaults& faults, double time_s);

/// One direction of a line: what is put in comes out later, in its order, at the line's pace, with
/// the faults asked for; always the same ones for the same seed. Is told the time in ns.
class FaultyLine {
  public:
    /// `byte_ns`: what a byte takes on the line; 1.04 ms at 9600 baud, 0 over a network.
    FaultyLine(const LineFaults& faults, std::int64_t byte_ns, std::int64_t now_ns);

    void put(std::span<const std::uint8_t> packet, std::int64_t now_ns);
    /// What has arrived by then, a packet or what is left of it each. What was under way while the
    /// plug was out is lost.
    std::vector<Bytes> take(std::int64_t now_ns);
    std::optional<std::int64_t> next_ns() const;
    bool plugged(std::int64_t now_ns) const;

  private:
    struct UnderWay {
        Bytes bytes;
        std::int64_t due_ns;
    };
    bool happens(double share);

    LineFaults faults_;
    std::int64_t byte_ns_;
    std::int64_t start_ns_;
    std::int64_t free_ns_ = 0;
    std::mt19937_64 random_;
    std::deque<UnderWay> under_way_;
};

/// At so many bits a second, with a start and a stop bit.
constexpr std::int64_t byte_time_ns(int baud) {
    return baud > 0 ? 10'000'000'000 / baud : 0;
}

}  // namespace kambara::visca
