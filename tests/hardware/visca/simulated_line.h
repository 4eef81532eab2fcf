// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "hardware/visca/evi_simulator.h"
#include "hardware/visca/faulty_line.h"

namespace kambara::visca {

/// A simulated camera at the other end of a line with faults, on time that is told.
class SimulatedLine {
  public:
    explicit SimulatedLine(std::int64_t now_ns, const LineFaults& faults = {}, int baud = 9600,
                           const EviSimulator::Options& options = {})
        : camera(now_ns, options),
          to_camera_(faults, byte_time_ns(baud), now_ns),
          to_controller_(with_other_seed(faults), byte_time_ns(baud), now_ns) {}

    void send(const Bytes& packet, std::int64_t now_ns) {
        if (carries_to_camera) {
            to_camera_.put(packet, now_ns);
        }
    }

    /// Lives on until `now_ns`; what arrived at the controller by then.
    std::vector<Bytes> advance(std::int64_t now_ns) {
        while (true) {
            std::int64_t step_ns = now_ns;
            for (const auto next : {to_camera_.next_ns(), camera.next_event_ns()}) {
                step_ns = std::min(step_ns, next.value_or(now_ns));
            }
            for (const Bytes& arrived : to_camera_.take(step_ns)) {
                for (const Bytes& packet : reader_.read(arrived)) {
                    camera.receive(packet, 0, step_ns);
                }
            }
            for (const auto& output : camera.advance(step_ns)) {
                if (carries_replies) {
                    to_controller_.put(output.packet, output.time_ns);
                }
            }
            if (step_ns >= now_ns) {
                return to_controller_.take(now_ns);
            }
        }
    }
    /// When something may arrive at the controller, at the earliest.
    std::int64_t next_ns(std::int64_t not_after_ns) const {
        std::int64_t next_ns = not_after_ns;
        for (const auto next :
             {to_camera_.next_ns(), camera.next_event_ns(), to_controller_.next_ns()}) {
            next_ns = std::min(next_ns, next.value_or(not_after_ns));
        }
        return next_ns;
    }
    bool plugged(std::int64_t now_ns) const { return to_camera_.plugged(now_ns); }
    void forget_begun_packet() { reader_.reset(); }

    EviSimulator camera;
    bool carries_to_camera = true;
    bool carries_replies = true;

  private:
    static LineFaults with_other_seed(LineFaults faults) {
        faults.seed += 1000;
        return faults;
    }
    FaultyLine to_camera_;
    FaultyLine to_controller_;
    PacketReader reader_;
};

}  // namespace kambara::visca
