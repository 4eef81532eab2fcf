// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "app/cli/outcome.h"
#include "hardware/visca/evi_server.h"

namespace kambara::cli {

struct SimulateEviOptions {
    visca::EviServerOptions server;
    bool packets = false;           ///< tell every packet
    std::optional<double> seconds;  ///< until interrupted, where not given
};

/// A simulated EVI-D30 for any VISCA client (PTZ-6), until interrupted. JSON: where it was to be
/// reached.
Outcome run_simulate_evi(const SimulateEviOptions& options);

}  // namespace kambara::cli
