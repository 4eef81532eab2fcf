// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/calibrate_head_command.h"
#include "app/cli/calibrate_zoom_command.h"
#include "app/cli/level_command.h"
#include "app/cli/range_test_command.h"

namespace CLI {
class App;
}

namespace kambara::cli {

/// The subcommand `range-test` and its options.
CLI::App* add_range_test(CLI::App& app, RangeTestOptions& options);

/// The subcommand `level` and its options.
CLI::App* add_level(CLI::App& app, LevelOptions& options);

/// The subcommand `calibrate-head` and its options.
CLI::App* add_calibrate_head(CLI::App& app, CalibrateHeadOptions& options);

/// The subcommand `calibrate-zoom` and its options.
CLI::App* add_calibrate_zoom(CLI::App& app, CalibrateZoomOptions& options);

}  // namespace kambara::cli
