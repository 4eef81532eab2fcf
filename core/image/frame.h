// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "core/image/image.h"

namespace kambara {

/// One picture as a grabber delivered it.
struct Frame {
    ImagePtr picture;            ///< never null in a valid frame
    std::int64_t time_ns = 0;    ///< when it was exposed, on the source's clock
    std::int64_t index = 0;      ///< counted from the source's first frame, which is 0
    std::uint32_t sequence = 0;  ///< the device's own counter; wraps around
    bool valid = true;           ///< false: torn, partial or otherwise not to be used
};

/// The two pictures of one instant.
struct StereoFrame {
    Frame left;
    Frame right;  ///< without a picture where there is no right camera
};

}  // namespace kambara
