// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "app/cli/outcome.h"

namespace kambara::cli {

struct TargetOptions {
    std::string target;  ///< a file or a short form
    std::string paper = "auto";
    std::filesystem::path out;
};

/// Prints a target at its true size, a page a plane, as a PDF file. JSON: out, paper, paper_mm
/// (upright), pages[{width_mm, height_mm (of the page as it is turned), sheet_mm, sheet_at_mm}].
Outcome run_target(const TargetOptions& options);

}  // namespace kambara::cli
