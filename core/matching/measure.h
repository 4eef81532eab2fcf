// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"

namespace kambara {

/// How alike a template and a piece of a picture are (correspondence: similarity measures).
enum class Measure {
    sad,  ///< sum of absolute differences; smallest is best; a map keeps it as a float, exact up to
          ///< 2^24
    ncc,  ///< sum(I T) / sqrt(sum(I^2) sum(T^2)), in [0, 1]; largest is best (1999, equation 2)
    zncc,  ///< the same after each side's mean is removed, in [-1, 1]; 0 over a flat patch
};

/// Reads `sad`, `ncc` or `zncc`.
Result<Measure> parse_measure(std::string_view name);
std::string to_string(Measure measure);

/// True where the first score is the better match.
bool better(Measure measure, double score, double than);

}  // namespace kambara
