// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a message of the link: refused, or read and written again.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "core/vsystem/serialise.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    if (const auto command = kambara::command_from_json(text)) {
        const auto again = kambara::command_from_json(kambara::to_json(*command));
        if (!again) {
            std::abort();
        }
    }
    if (const auto snapshot = kambara::snapshot_from_json(text)) {
        const auto written = kambara::to_json(*snapshot);
        const auto again = kambara::snapshot_from_json(written);
        if (!again || kambara::to_json(*again) != written) {
            std::abort();
        }
    }
    (void)kambara::reply_from_json(text).ok();
    (void)kambara::event_from_json(text).ok();
    return 0;
}
