// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/vsystem/snapshot.h"

namespace kambara::cli {

/// The rows that `track` writes, one a frame (resources/README.md: track table). Positions are in
/// the left camera's frame, of the point that was the template's centre; what is not known is left
/// empty.
std::string track_table_header();
std::string track_table_row(const Snapshot& snapshot);  ///< of the steered target

/// Likewise with several targets: a row for each, with its number in one more column.
std::string targets_table_header();
std::string targets_table_rows(const Snapshot& snapshot);

}  // namespace kambara::cli
