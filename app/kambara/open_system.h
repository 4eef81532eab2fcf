// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/base/clock.h"
#include "ui/shell/system_link.h"

namespace kambara {

/// Opens what the window asks for: `sim:PROFILE` live with its head and its pan-tilt pictures,
/// anything else as a recording, held after its first pair and played in real time. `clock`
/// outlives what is opened. A real head named by `pan_tilt` (empty: none) is opened with the first
/// source that steers one, and kept for the next ones.
ui::SystemOpener system_opener(Clock& clock, const std::string& pan_tilt = {});

}  // namespace kambara
