// SPDX-License-Identifier: GPL-3.0-or-later
#include "hardware/simulated/tile_texture.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>

namespace kambara {
namespace {

std::size_t index(int side, int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(side) +
           static_cast<std::size_t>(x);
}

// The next whole number below; std::floor is a call where the processor's own is not to be had.
int whole(float value) {
    const int towards_zero = static_cast<int>(value);
    return towards_zero - (value < static_cast<float>(towards_zero) ? 1 : 0);
}

// Adds noise of one size: random values on a periodic lattice, joined by cubic B-splines, whose
// spectrum falls fast beyond the lattice's own frequency.
void add_octave(std::vector<float>& grey, int side, int cells, std::mt19937& random) {
    std::normal_distribution<float> value(0.0F, 1.0F);
    std::vector<float> lattice(static_cast<std::size_t>(cells) * static_cast<std::size_t>(cells));
    std::generate(lattice.begin(), lattice.end(), [&] { return value(random); });
    const auto weights = [](float t, float* w) {
        w[0] = (1 - t) * (1 - t) * (1 - t) / 6;
        w[1] = (3 * t * t * t - 6 * t * t + 4) / 6;
        w[2] = (-3 * t * t * t + 3 * t * t + 3 * t + 1) / 6;
        w[3] = t * t * t / 6;
    };
    for (int y = 0; y < side; ++y) {
        const float fy =
            static_cast<float>(y) * static_cast<float>(cells) / static_cast<float>(side);
        float wy[4];
        weights(fy - std::floor(fy), wy);
        for (int x = 0; x < side; ++x) {
            const float fx =
                static_cast<float>(x) * static_cast<float>(cells) / static_cast<float>(side);
            float wx[4];
            weights(fx - std::floor(fx), wx);
            float sum = 0;
            for (int j = 0; j < 4; ++j) {
                for (int i = 0; i < 4; ++i) {
                    const int cx = (static_cast<int>(fx) + i) % cells;
                    const int cy = (static_cast<int>(fy) + j) % cells;
                    sum += wx[i] * wy[j] * lattice[index(cells, cx, cy)];
                }
            }
            grey[index(side, x, y)] += sum;
        }
    }
}

}  // namespace

TileTexture::TileTexture(const Options& options, std::uint32_t seed) : texel_mm_(options.texel_mm) {
    int side = 1;
    while (side * options.texel_mm < options.period_mm) {
        side *= 2;
    }
    texel_mm_ = options.period_mm / side;
    std::mt19937 random(seed);
    Level finest{side, std::vector<float>(index(side, 0, side), 0.0F)};
    for (double size = options.finest_mm; size <= options.coarsest_mm; size *= 2.0) {
        add_octave(finest.grey, side, std::max(4, static_cast<int>(options.period_mm / size)),
                   random);
    }
    double sum = 0.0;
    double squares = 0.0;
    for (const float value : finest.grey) {
        sum += value;
        squares += static_cast<double>(value) * value;
    }
    const auto n = static_cast<double>(finest.grey.size());
    const double mean = sum / n;
    const double scale =
        options.contrast_grey / std::sqrt(std::max(1e-12, squares / n - mean * mean));
    for (float& value : finest.grey) {
        value =
            static_cast<float>(std::clamp(options.mean_grey + scale * (value - mean), 5.0, 250.0));
    }
    levels_.push_back(std::move(finest));
    while (levels_.back().side > 1) {
        const Level& fine = levels_.back();
        Level coarse{fine.side / 2, {}};
        coarse.grey.resize(index(coarse.side, 0, coarse.side));
        for (int y = 0; y < coarse.side; ++y) {
            for (int x = 0; x < coarse.side; ++x) {
                coarse.grey[index(coarse.side, x, y)] =
                    0.25F * (fine.grey[index(fine.side, 2 * x, 2 * y)] +
                             fine.grey[index(fine.side, 2 * x + 1, 2 * y)] +
                             fine.grey[index(fine.side, 2 * x, 2 * y + 1)] +
                             fine.grey[index(fine.side, 2 * x + 1, 2 * y + 1)]);
            }
        }
        levels_.push_back(std::move(coarse));
    }
}

float TileTexture::at(double u_mm, double v_mm, double footprint_mm) const {
    std::size_t which = 0;
    double texels_per_mm = 1.0 / texel_mm_;
    while (which + 1 < levels_.size() && footprint_mm * texels_per_mm > 1.0) {
        ++which;
        texels_per_mm *= 0.5;
    }
    return between(levels_[which], static_cast<float>(u_mm * texels_per_mm),
                   static_cast<float>(v_mm * texels_per_mm));
}

float TileTexture::at(float u_mm, float v_mm) const {
    const auto texels = static_cast<float>(1.0 / texel_mm_);
    return between(levels_.front(), u_mm * texels, v_mm * texels);
}

float TileTexture::between(const Level& level, float u_texels, float v_texels) {
    const float u = u_texels - 0.5F;
    const float v = v_texels - 0.5F;
    const int iu = whole(u);
    const int iv = whole(v);
    const int mask = level.side - 1;  // sides are powers of two
    const int x0 = iu & mask;
    const int y0 = iv & mask;
    const int x1 = (x0 + 1) & mask;
    const int y1 = (y0 + 1) & mask;
    const float a = u - static_cast<float>(iu);
    const float b = v - static_cast<float>(iv);
    const float* g = level.grey.data();
    return (1 - b) * ((1 - a) * g[index(level.side, x0, y0)] + a * g[index(level.side, x1, y0)]) +
           b * ((1 - a) * g[index(level.side, x0, y1)] + a * g[index(level.side, x1, y1)]);
}

}  // namespace kambara
