// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"

namespace kambara {

/// How alike a template and a piece of a picture are (correspondence: similarity measures).
enum class Measure {
    sad,      ///< sum of absolute differences; smallest is best
    ncc,      ///< sum(I T) / sqrt(sum(I^2) sum(T^2)), in [0, 1]; largest is best (1999, equation 2)
    zncc,     ///< the same after each side's mean is removed, in [-1, 1]; 0 over a flat patch
    hamming,  ///< number of differing bits of binary transforms; smallest is best
};

/// A smaller score of these is the better one, and maps hold their exact integers.
constexpr bool is_cost(Measure measure) {
    return measure == Measure::sad || measure == Measure::hamming;
}

/// Reads `sad`, `ncc`, `zncc` or `hamming`.
Result<Measure> parse_measure(std::string_view name);
std::string to_string(Measure measure);

/// True where the first score is the better match.
bool better(Measure measure, double score, double than);

}  // namespace kambara
