// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "core/base/result.h"
#include "core/matching/measure.h"
#include "core/matching/transform.h"

namespace kambara {

/// How two pieces of pictures are compared.
struct MatchMethod {
    Measure measure = Measure::zncc;
    Transform transform = Transform::none;
    int step = 1;  ///< every step-th template pixel of every step-th row counts (sparse search)

    bool operator==(const MatchMethod&) const = default;
};

/// A method by the names of its parts. Counting differing bits needs a transform of bits (census,
/// sdog), and the bits of census can only be counted.
Result<MatchMethod> parse_method(std::string_view measure, std::string_view transform);

}  // namespace kambara
