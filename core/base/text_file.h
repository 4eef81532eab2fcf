// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace kambara {

/// The whole file as text. Refuses what does not exist, is not a regular file, or is larger than
/// `limit_bytes`.
Result<std::string> read_text_file(const std::filesystem::path& path,
                                   std::size_t limit_bytes = std::size_t{64} << 20);

/// Writes beside `path` under a temporary name and then renames: whoever reads `path` sees the old
/// content or the new, never half of it, and a failure leaves the old content in place. A link
/// stays a link to the file written; what is no regular file (a pipe, a terminal, /dev/null) can't
/// be replaced and is written to.
Result<Done> write_text_file_atomically(const std::filesystem::path& path, std::string_view text);

}  // namespace kambara
