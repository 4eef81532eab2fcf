// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/cli/outcome.h"

namespace kambara::cli {

struct DetectOptions {
    std::filesystem::path image;
    std::string target;
    std::optional<std::filesystem::path> stages;  ///< folder for a picture of every stage
};

/// Finds a target in a picture. The JSON is the contract's: found, reason, corners; for boxes also
/// what was left out and why. Pictures of the stages are written as far as detection came.
Outcome run_detect(const DetectOptions& options);

}  // namespace kambara::cli
