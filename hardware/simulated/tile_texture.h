// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

namespace kambara {

/// A pattern without preferred direction that repeats after `period_mm`: random grey of several
/// sizes between the finest and the coarsest, smooth below the finest. A pyramid of means serves
/// samples that cover an area.
class TileTexture {
  public:
    struct Options {
        double period_mm = 512.0;
        double texel_mm = 2.0;
        double finest_mm = 10.0;
        double coarsest_mm = 80.0;
        double mean_grey = 128.0;
        double contrast_grey = 45.0;  ///< standard deviation
    };

    TileTexture(const Options& options, std::uint32_t seed);

    /// The grey level at (u, v), mean over about `footprint_mm` across.
    float at(double u_mm, double v_mm, double footprint_mm) const;

    /// The grey level of the pattern itself at (u, v).
    float at(float u_mm, float v_mm) const;

  private:
    struct Level {
        int side = 0;
        std::vector<float> grey;
    };

    static float between(const Level& level, float u_texels, float v_texels);

    double texel_mm_;
    std::vector<Level> levels_;  // each half as wide as the one before
};

}  // namespace kambara
