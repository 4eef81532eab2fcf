// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/calibration/target.h"

namespace kambara {

/// Reads the text of a target file (YAML; resources/README.md: target file). Refuses, naming the
/// key at fault, what is missing, mistyped or cannot be. Any bytes are safe to pass.
Result<Target> target_from_text(std::string_view text);

/// The text of a target file that reads back as the same target.
std::string target_to_text(const Target& target);

/// As above, from and to a file; writing is atomic.
Result<Target> read_target_file(const std::filesystem::path& path);
Result<Done> write_target_file(const std::filesystem::path& path, const Target& target);

}  // namespace kambara
