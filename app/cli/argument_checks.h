// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace kambara::cli {

/// Checks of an option's number that say what is asked for.
CLI::Validator not_negative();
CLI::Validator above_zero();
/// X,Y,W,H in whole pixels; `auto` too where that is allowed.
CLI::Validator a_rectangle(bool or_auto);

/// What would destroy an input or another output: the paths given to options that write a file
/// (--out, --csv, --json, --report, --map) name no file that the command reads, and none twice.
/// Empty where all is well.
std::string clash_of_files(const CLI::App& command);

}  // namespace kambara::cli
