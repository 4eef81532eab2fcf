// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

namespace kambara {

/// What a gamepad's sticks and triggers were at, as the device tells it: no dead zone, no curve.
struct PadReading {
    bool present = false;
    int device = -1;           ///< another number for each one that is plugged in
    std::string name;          ///< the device's own; two of a kind have the same
    std::int64_t time_ns = 0;  ///< when it was read, on the system's clock
    double right = 0.0;        ///< of the left stick, -1 to 1
    double up = 0.0;           ///< likewise
    double zoom_in = 0.0;      ///< of the right trigger, 0 to 1
    double zoom_out = 0.0;     ///< of the left one
    bool halt = false;         ///< the right one of the four buttons is pressed
    bool operator==(const PadReading&) const = default;
};

}  // namespace kambara
