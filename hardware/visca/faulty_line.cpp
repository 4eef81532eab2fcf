// SPDX-License-Identifier: GPL-3.0-or-later
#include "hardware/visca/faulty_line.h"

#include <algorithm>
#include <cmath>

namespace kambara::visca {

bool is_plugged(const LineFaults& faults, double time_s) {
    return !(faults.unplug_every_s > 0.0) ||
           std::fmod(time_s, faults.unplug_every_s) < faults.unplug_every_s - faults.unplug_for_s;
}

FaultyLine::FaultyLine(const LineFaults& faults, std::int64_t byte_ns, std::int64_t now_ns)
    : faults_(faults), byte_ns_(byte_ns), start_ns_(now_ns), random_(faults.seed) {}

bool FaultyLine::happens(double share) {
    return share > 0.0 && std::uniform_real_distribution<double>(0.0, 1.0)(random_) < share;
}

bool FaultyLine::plugged(std::int64_t now_ns) const {
    return is_plugged(faults_, static_cast<double>(now_ns - start_ns_) * 1e-9);
}

void FaultyLine::put(std::span<const std::uint8_t> packet, std::int64_t now_ns) {
    if (!plugged(now_ns)) {
        return;
    }
    Bytes bytes;
    for (std::uint8_t byte : packet) {
        if (happens(faults_.garbled_bytes)) {
            byte = static_cast<std::uint8_t>(byte ^ (1U << (random_() % 8)));
        }
        if (!happens(faults_.lost_bytes)) {
            bytes.push_back(byte);
        }
        if (happens(faults_.doubled_bytes)) {
            bytes.push_back(byte);
        }
    }
    const auto late_ns = static_cast<std::int64_t>(faults_.late_s * 1e9);
    const std::int64_t begins_ns =
        std::max(now_ns + (happens(faults_.late_packets) ? late_ns : 0), free_ns_);
    free_ns_ = begins_ns + static_cast<std::int64_t>(bytes.size()) * byte_ns_;
    if (!bytes.empty()) {
        under_way_.push_back({bytes, free_ns_});
    }
}

std::vector<Bytes> FaultyLine::take(std::int64_t now_ns) {
    std::vector<Bytes> arrived;
    while (!under_way_.empty() && under_way_.front().due_ns <= now_ns) {
        if (plugged(under_way_.front().due_ns)) {
            arrived.push_back(under_way_.front().bytes);
        }
        under_way_.pop_front();
    }
    return arrived;
}

std::optional<std::int64_t> FaultyLine::next_ns() const {
    return under_way_.empty() ? std::nullopt : std::optional(under_way_.front().due_ns);
}

}  // namespace kambara::visca
