// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

namespace kambara::ui {

/// The sentences of core/calibration that the window translates, with %1, %2, ... where numbers and
/// names stand, in ascending order; the German ones are in translations/.
std::span<const char* const> calibration_phrases();
/// Likewise those of the experiments: core/stereo, core/pointing, the views of a head.
std::span<const char* const> experiment_phrases();

}  // namespace kambara::ui
