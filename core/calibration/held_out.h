// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/calibration/bundle.h"
#include "core/calibration/calibration_report.h"

namespace kambara {

/// Adjusts the bundle to every second view, triangulates the corners of the others from its first
/// and second camera, and compares the target's lengths with the drawing's; then the other way
/// round. The bundle must be adjusted already. Empty where fewer than six views show the target to
/// both cameras.
std::optional<HeldOutCheck> held_out_check(const Bundle& bundle, const std::stop_token& stop = {});

}  // namespace kambara
