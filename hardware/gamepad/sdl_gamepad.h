// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "core/base/clock.h"
#include "core/base/result.h"
#include "core/devices/gamepad.h"

namespace kambara {

/// The first gamepad there is, now or later; pulled out, the next one. `clock`, which outlives it,
/// gives the readings their times. Refuses where SDL finds no way to gamepads at all.
Result<std::unique_ptr<GamepadBase>> open_sdl_gamepad(const Clock& clock);

}  // namespace kambara
