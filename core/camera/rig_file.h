// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/camera/rig.h"

namespace kambara {

/// The rig file's format number (resources/README.md: rig file).
inline constexpr int rig_file_version = 1;

/// Reads the text of a rig file (YAML). Refuses, naming the key at fault, what is missing,
/// mistyped, not finite, or cannot be (a rotation that is none, an impossible lens, cameras in the
/// same place). Any bytes are safe to pass.
Result<Rig> rig_from_text(std::string_view text);

/// The text of a rig file: numbers with all digits, so that reading gives the same rig to 1e-12.
std::string rig_to_text(const Rig& rig);

/// As above, from and to a file. Writing is atomic: a failure leaves an old file as it was.
Result<Rig> read_rig_file(const std::filesystem::path& path);
Result<Done> write_rig_file(const std::filesystem::path& path, const Rig& rig);

}  // namespace kambara
