// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/matching/measure.h"

namespace kambara {

Result<Measure> parse_measure(std::string_view name) {
    if (name == "sad") {
        return Measure::sad;
    }
    if (name == "ncc") {
        return Measure::ncc;
    }
    if (name == "zncc") {
        return Measure::zncc;
    }
    return Error{"There is no measure \"" + std::string(name) + "\".", "Choose sad, ncc or zncc."};
}

std::string to_string(Measure measure) {
    switch (measure) {
        case Measure::sad:
            return "sad";
        case Measure::ncc:
            return "ncc";
        case Measure::zncc:
            break;
    }
    return "zncc";
}

bool better(Measure measure, double score, double than) {
    return measure == Measure::sad ? score < than : score > than;
}

}  // namespace kambara
