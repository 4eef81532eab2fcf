// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as the short forms of the command line: rectangles, targets, simulated profiles.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "core/calibration/target.h"
#include "core/image/rectangle.h"
#include "hardware/simulated/simulated_profile.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    if (const auto rectangle = kambara::parse_rectangle(text)) {
        const auto again = kambara::parse_rectangle(kambara::to_string(*rectangle));
        if (!again || *again != *rectangle) {
            std::abort();
        }
    }
    if (const auto target = kambara::parse_target(text)) {
        if (!kambara::parse_target(kambara::to_string(*target))) {
            std::abort();
        }
    }
    (void)kambara::simulated_profile(text).ok();
    return 0;
}
