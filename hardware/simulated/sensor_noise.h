// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/image/image.h"

namespace kambara {

/// Gaussian noise of a sensor, from one long table read at places that a hash chooses: the same
/// seed, camera and frame give the same noise, in any order.
class SensorNoise {
  public:
    SensorNoise(double sigma_grey, std::uint32_t seed);

    /// The grey levels as the sensor would deliver them: noise added, rounded, clipped.
    /// The channels' levels are interleaved.
    Image digitised(const float* levels, int width, int height, int channels, std::uint32_t camera,
                    std::int64_t frame) const;

  private:
    std::uint32_t seed_;
    std::vector<float> table_;
};

}  // namespace kambara
