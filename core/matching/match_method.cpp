// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/matching/match_method.h"

#include <string>

namespace kambara {

Result<MatchMethod> parse_method(std::string_view measure, std::string_view transform) {
    const auto by = parse_measure(measure);
    if (!by) {
        return by.error();
    }
    const auto after = parse_transform(transform);
    if (!after) {
        return after.error();
    }
    const bool bits = *after == Transform::census || is_binary(*after);
    if (*by == Measure::hamming && !bits) {
        return Error{"The measure hamming counts differing bits, and the transform " +
                         std::string(transform) + " does not give any.",
                     "Use the transform census or sdog with it, or another measure."};
    }
    if (*by != Measure::hamming && *after == Transform::census) {
        return Error{"The transform census gives bits, which the measure " + std::string(measure) +
                         " can't compare.",
                     "Use the measure hamming with it."};
    }
    return MatchMethod{*by, *after, 1};
}

}  // namespace kambara
