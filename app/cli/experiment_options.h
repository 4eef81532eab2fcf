// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/range_test_command.h"

namespace CLI {
class App;
}

namespace kambara::cli {

/// The subcommand `range-test` and its options.
CLI::App* add_range_test(CLI::App& app, RangeTestOptions& options);

}  // namespace kambara::cli
