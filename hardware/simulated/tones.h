// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "hardware/simulated/water.h"

namespace kambara {

/// What a seabed's grey level is multiplied by for its blue, green and red: sand, stones and weed,
/// as a tone from 0 to 255 says. Green is 1, so that grey pictures show the green.
Colour seabed_tone(float tone);

/// The same on the moving target: as printed, white, with coloured discs.
Colour target_tone(float across_mm, float down_mm);

}  // namespace kambara
