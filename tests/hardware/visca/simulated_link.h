// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/base/clock.h"
#include "hardware/visca/link.h"
#include "tests/hardware/visca/simulated_line.h"

namespace kambara::visca {

/// A link to a simulated camera. Waiting moves the clock: ten minutes pass in no time. While the
/// plug is out the device is gone, as that of a USB adapter is.
class SimulatedLink final : public Link {
  public:
    SimulatedLink(ManualClock& clock, SimulatedLine& line) : clock_(clock), line_(line) {}

    std::string name() const override { return "simulated line"; }
    Result<Done> open() override {
        if (!there()) {
            return Error{"The line is not there.", "Plug it in."};
        }
        open_ = true;
        ++times_opened;
        return Done{};
    }
    void close() override { open_ = false; }
    Result<Done> send(const Bytes& packet) override {
        if (!there()) {
            return Error{"The line was lost.", "Plug it in."};
        }
        line_.send(packet, clock_.now_ns());
        sent.push_back(packet);
        return Done{};
    }
    Result<std::vector<Bytes>> receive(std::int64_t until_ns) override {
        // A look at least once a millisecond, as a test may want something else meanwhile.
        const std::int64_t step_ns = std::clamp(
            line_.next_ns(until_ns), clock_.now_ns() + 1,
            std::max(clock_.now_ns() + 1, std::min(until_ns, clock_.now_ns() + 1'000'000)));
        clock_.set_ns(step_ns);
        auto arrived = line_.advance(clock_.now_ns());
        if (!open_) {
            return std::vector<Bytes>();
        }
        if (!there()) {
            return Error{"The line was lost.", "Plug it in."};
        }
        return arrived;
    }
    void wake() override {}

    bool there() const { return !device_vanishes || line_.plugged(clock_.now_ns()); }

    bool device_vanishes = true;
    int times_opened = 0;
    std::vector<Bytes> sent;

  private:
    ManualClock& clock_;
    SimulatedLine& line_;
    bool open_ = false;
};

}  // namespace kambara::visca
