// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/clock.h"
#include "core/base/result.h"
#include "hardware/visca/evi_simulator.h"
#include "hardware/visca/faulty_line.h"

namespace kambara::visca {

/// Where a simulated camera is to be reached.
struct EviServerOptions {
    std::string pty;              ///< a name to give to a pseudo-terminal; empty: none
    std::optional<int> udp_port;  ///< 0: any that is free
    std::optional<int> tcp_port;
    bool everywhere = false;  ///< from other machines, too
    int baud = 9600;          ///< of the pseudo-terminal's line; 0: as fast as it goes
    EviSimulator::Options camera;
    LineFaults faults;
    bool power_goes_too = false;  ///< when the plug is out
};

/// One simulated EVI-D30 on a pseudo-terminal, on UDP (with Sony's header or without, as it is
/// asked) and on TCP, for any VISCA client and several at once. While the plug is out, the
/// pseudo-terminal is gone and TCP connections are cut.
class EviServer {
  public:
    /// Opens all that is asked for, or none. `clock` outlives it.
    static Result<std::unique_ptr<EviServer>> open(const EviServerOptions& options, Clock& clock);
    virtual ~EviServer() = default;

    /// "on the pseudo-terminal /tmp/evi" and so on.
    virtual std::vector<std::string> places() const = 0;
    virtual int udp_port() const = 0;
    virtual int tcp_port() const = 0;

    /// Serves until a stop is requested (looked at ten times a second). `report` is told of plugs
    /// and, where `packets` is set, of every packet.
    virtual void run(std::stop_token stop, const std::function<void(const std::string&)>& report,
                     bool packets) = 0;
};

}  // namespace kambara::visca
