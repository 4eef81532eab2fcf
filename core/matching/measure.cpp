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
    if (name == "hamming") {
        return Measure::hamming;
    }
    return Error{"There is no measure \"" + std::string(name) + "\".",
                 "Choose sad, ncc, zncc or hamming."};
}

std::string to_string(Measure measure) {
    switch (measure) {
        case Measure::sad:
            return "sad";
        case Measure::ncc:
            return "ncc";
        case Measure::hamming:
            return "hamming";
        case Measure::zncc:
            break;
    }
    return "zncc";
}

bool better(Measure measure, double score, double than) {
    return is_cost(measure) ? score < than : score > than;
}

}  // namespace kambara
