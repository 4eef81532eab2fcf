// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/pad_reading.h"

namespace kambara {

/// A gamepad, or the place where one may be plugged in. Asked often, from any thread: it never
/// waits for the device.
class GamepadBase {
  public:
    virtual ~GamepadBase() = default;

    /// The latest there is. A time that stands still: whoever reads the device hangs. A device
    /// whose radio link has broken may be read on with its last values.
    virtual PadReading reading() const = 0;
};

}  // namespace kambara
