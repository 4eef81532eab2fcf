// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/App.hpp>

#include "app/cli/pan_tilt_command.h"
#include "app/cli/simulate_evi_command.h"

namespace kambara::cli {

/// The commands about heads, with their options; both are returned for what every command has.
CLI::App* add_pan_tilt(CLI::App& app, PanTiltOptions& options);
CLI::App* add_simulate_evi(CLI::App& app, SimulateEviOptions& options);

}  // namespace kambara::cli
