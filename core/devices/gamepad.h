// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/pad_reading.h"

namespace kambara {

/// A gamepad, or the place where one may be plugged in. Asked often, from any thread: it never
/// waits for the device.
class GamepadBase {
  public:
    virtual ~GamepadBase() = default;

    /// The latest there is. One whose time stands still comes from a device that hangs.
    virtual PadReading reading() const = 0;
};

}  // namespace kambara
