// SPDX-License-Identifier: GPL-3.0-or-later
#include "hardware/simulated/tones.h"

#include <algorithm>
#include <cmath>

namespace kambara {
namespace {

const Colour weed(0.62F, 1.0F, 0.80F);
const Colour sand(0.74F, 1.0F, 1.18F);
const Colour stone(0.96F, 1.0F, 1.02F);

// Discs of 40 mm, one in each 75 mm of the target.
constexpr float cell_mm = 75.0F;
constexpr float disc_radius_mm = 20.0F;
const Colour disc_tones[] = {
    {0.35F, 0.45F, 1.55F},  // red
    {1.70F, 0.80F, 0.35F},  // blue
    {0.25F, 1.15F, 1.40F},  // yellow
    {0.45F, 1.15F, 0.40F},  // green
};

float risen(float value, float from, float to) {
    const float t = std::clamp((value - from) / (to - from), 0.0F, 1.0F);
    return t * t * (3.0F - 2.0F * t);
}

}  // namespace

Colour seabed_tone(float tone) {
    const float of_weed = 1.0F - risen(tone, 50.0F, 85.0F);
    const float of_stone = risen(tone, 150.0F, 185.0F);
    return of_weed * weed + of_stone * stone + (1.0F - of_weed - of_stone) * sand;
}

Colour target_tone(float across_mm, float down_mm) {
    const float i = std::floor(across_mm / cell_mm);
    const float j = std::floor(down_mm / cell_mm);
    const float x = across_mm - (i + 0.5F) * cell_mm;
    const float y = down_mm - (j + 0.5F) * cell_mm;
    if (x * x + y * y > disc_radius_mm * disc_radius_mm) {
        return Colour::Ones();
    }
    return disc_tones[static_cast<unsigned>(static_cast<int>(i) + 2 * static_cast<int>(j)) % 4U];
}

}  // namespace kambara
