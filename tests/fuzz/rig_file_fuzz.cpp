// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a rig file: refused with a reason, or read; and what is read can be written and read
// again to the same text.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "core/camera/rig_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto rig =
        kambara::rig_from_text(std::string_view(reinterpret_cast<const char*>(data), size));
    if (!rig) {
        if (rig.error().cause.empty() || rig.error().remedy.empty()) {
            std::abort();
        }
        return 0;
    }
    const auto text = kambara::rig_to_text(*rig);
    const auto again = kambara::rig_from_text(text);
    if (!again || kambara::rig_to_text(*again) != text) {
        std::abort();
    }
    return 0;
}
