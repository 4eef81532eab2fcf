// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "ui/shell/system_link.h"

namespace kambara {

/// Opens what the window asks for: `sim:PROFILE` live with its head and its pan-tilt pictures,
/// anything else as a recording, held after its first pair and played in real time. `clock`
/// outlives what is opened.
ui::SystemOpener system_opener(Clock& clock);

}  // namespace kambara
