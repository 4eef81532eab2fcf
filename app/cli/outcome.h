// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "core/base/error.h"

namespace kambara::cli {

/// What a command comes to. The program prints `failure` on standard error and exits with 1, or
/// with 2 where the options do not go together; it writes `json` where --json asks for it, also
/// when the command failed.
struct Outcome {
    std::optional<Error> failure = {};
    std::string json = "{}";
    /// For people, on standard output; not printed when the JSON goes there.
    std::string summary = {};
    bool wrong_usage = false;
};

}  // namespace kambara::cli
