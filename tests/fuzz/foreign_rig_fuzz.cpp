// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as other programs' calibrations. The first byte chooses the reader; a line of dashes
// parts two files.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "core/camera/foreign_formats.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) {
        return 0;
    }
    const std::string_view text(reinterpret_cast<const char*>(data) + 1, size - 1);
    constexpr std::string_view parting = "\n----\n";
    const auto at = text.find(parting);
    const std::string_view first = text.substr(0, at);
    const std::string_view second =
        at == std::string_view::npos ? std::string_view() : text.substr(at + parting.size());
    const kambara::PictureSize size_px{640, 480};
    const auto read = [&]() -> kambara::Result<kambara::Rig> {
        switch (data[0]) {
            case 'k':
                return kambara::rig_from_kitti(first, size_px);
            case 'o':
                return kambara::rig_from_opencv(first, second, size_px);
            case 'r':
                return kambara::rig_from_ros(first, second);
            default:
                return kambara::rig_from_kalibr(first);
        }
    };
    const auto rig = read();
    if (!rig && rig.error().cause.empty()) {
        std::abort();
    }
    return 0;
}
