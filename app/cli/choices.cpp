// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/choices.h"

#include <algorithm>
#include <array>

namespace kambara::cli {

Result<Measure> chosen_measure(const std::string& measure, const std::string& transform) {
    constexpr std::array known{"none", "gauss", "rank3", "rank5", "sdog", "census", "gradient"};
    if (std::find(known.begin(), known.end(), transform) == known.end()) {
        return Error{"There is no transform \"" + transform + "\".", "Use --transform none."};
    }
    if (transform != "none") {
        return Error{"The transform " + transform + " is not in this version yet.",
                     "Use --transform none."};
    }
    if (measure == "hamming") {
        return Error{
            "The measure hamming compares binary transforms, which are not in this "
            "version yet.",
            "Use --measure sad, ncc or zncc."};
    }
    return parse_measure(measure);
}

}  // namespace kambara::cli
