// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/base/result.h"
#include "core/matching/measure.h"

namespace kambara::cli {

/// The measure that --measure and --transform ask for. Refuses names that do not exist, and those
/// that this version does not have, saying which it is.
Result<Measure> chosen_measure(const std::string& measure, const std::string& transform);

}  // namespace kambara::cli
