// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace kambara::cli {

/// Name and version, as files carry them.
extern const char* const program_name;

/// The date and time in UTC, such as 2026-01-31T12:00:00Z.
std::string now_iso8601();

}  // namespace kambara::cli
