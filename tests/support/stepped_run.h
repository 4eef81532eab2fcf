// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "app/sources/sources.h"
#include "core/vsystem/vision_system.h"

namespace kambara::testing_support {

/// The system on these sources, as `track` runs it: every pair, and paused at first. A test fails
/// where it can't be opened, and gets null. The clock outlives it.
std::unique_ptr<VsystemInterface> opened_in_step(VisionSystemParts parts, Clock& clock);

/// Carries the commands out, lets the pictures flow, and returns when the source is over. `each`
/// sees every snapshot from before the commands on, one at a time. A test fails where a command is
/// refused, or where nothing came for two minutes.
void run_to_end(VsystemInterface& system, const std::vector<Command>& commands,
                const std::function<void(const Snapshot&)>& each);

}  // namespace kambara::testing_support
