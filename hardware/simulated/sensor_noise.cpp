// SPDX-License-Identifier: GPL-3.0-or-later
#include "hardware/simulated/sensor_noise.h"

#include <algorithm>
#include <cstddef>
#include <random>

namespace kambara {
namespace {

constexpr std::size_t table_size = std::size_t{1} << 19;
constexpr std::size_t widest_row = 3 * 4096;

// splitmix64's finaliser: every bit of the input stirs every bit of the output.
std::uint64_t stirred(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15ULL;
    x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9ULL;
    x = (x ^ (x >> 27U)) * 0x94d049bb133111ebULL;
    return x ^ (x >> 31U);
}

}  // namespace

SensorNoise::SensorNoise(double sigma_grey, std::uint32_t seed)
    : seed_(seed), table_(table_size + widest_row) {
    std::mt19937 random(seed * 2654435761U + 12345U);
    std::normal_distribution<float> noise(0.0F, 1.0F);
    const auto sigma = static_cast<float>(sigma_grey);
    std::generate(table_.begin(), table_.end(), [&] { return sigma * noise(random); });
}

Image SensorNoise::digitised(const float* levels, int width, int height, int channels,
                             std::uint32_t camera, std::int64_t frame) const {
    Image picture(width, height, channels);
    const std::uint64_t of_frame = stirred(stirred((std::uint64_t{seed_} << 32U) | camera) ^
                                           static_cast<std::uint64_t>(frame));
    const std::size_t n = picture.row_bytes();
    for (int y = 0; y < height; ++y) {
        const float* noise =
            table_.data() + stirred(of_frame + static_cast<std::uint64_t>(y)) % table_size;
        const float* in = levels + static_cast<std::size_t>(y) * n;
        std::uint8_t* out = picture.row(y);
        for (std::size_t x = 0; x < n; ++x) {
            const float value = std::min(255.0F, std::max(0.0F, in[x] + noise[x] + 0.5F));
            out[x] = static_cast<std::uint8_t>(static_cast<int>(value));
        }
    }
    return picture;
}

}  // namespace kambara
