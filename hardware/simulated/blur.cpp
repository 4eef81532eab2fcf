// SPDX-License-Identifier: GPL-3.0-or-later
#include "hardware/simulated/blur.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace kambara {
namespace {

// One half of a Gaussian, from its middle outwards.
std::vector<float> weights_of(double sigma_px) {
    const int reach = std::max(1, static_cast<int>(std::ceil(3.0 * sigma_px)));
    std::vector<float> weights;
    float sum = 0.0F;
    for (int i = 0; i <= reach; ++i) {
        const double t = i / sigma_px;
        weights.push_back(static_cast<float>(std::exp(-0.5 * t * t)));
        sum += i == 0 ? weights.back() : 2.0F * weights.back();
    }
    for (float& weight : weights) {
        weight /= sum;
    }
    return weights;
}

// Rows of `width` pixels of `channels` interleaved numbers.
void blur_rows(float* levels, int width, int channels, const std::vector<double>& sigmas_px) {
    const auto n = static_cast<std::size_t>(width * channels);
    const int height = static_cast<int>(sigmas_px.size());
    std::vector<std::vector<float>> weights;
    weights.reserve(sigmas_px.size());
    for (const double sigma_px : sigmas_px) {
        weights.push_back(weights_of(sigma_px));
    }
    std::vector<float> along(n * sigmas_px.size());
    std::vector<float> padded;
    for (int y = 0; y < height; ++y) {
        const std::vector<float>& half = weights[static_cast<std::size_t>(y)];
        const int reach = static_cast<int>(half.size()) - 1;
        const std::size_t margin = half.size() - 1;
        const float* row = levels + static_cast<std::size_t>(y) * n;
        padded.resize(n + 2 * margin * static_cast<std::size_t>(channels));
        float* middle = padded.data() + margin * static_cast<std::size_t>(channels);
        for (int i = 1; i <= reach; ++i) {
            std::copy_n(row, channels, middle - i * channels);
            std::copy_n(row + n - channels, channels,
                        middle + n + static_cast<std::ptrdiff_t>(i - 1) * channels);
        }
        std::copy_n(row, n, middle);
        float* to = along.data() + static_cast<std::size_t>(y) * n;
        for (int i = -reach; i <= reach; ++i) {
            const float weight = half[static_cast<std::size_t>(std::abs(i))];
            const float* from = middle + i * channels;
            for (std::size_t x = 0; x < n; ++x) {
                to[x] += weight * from[x];
            }
        }
    }
    std::fill_n(levels, along.size(), 0.0F);
    for (int y = 0; y < height; ++y) {
        const std::vector<float>& half = weights[static_cast<std::size_t>(y)];
        const int reach = static_cast<int>(half.size()) - 1;
        float* to = levels + static_cast<std::size_t>(y) * n;
        for (int j = -reach; j <= reach; ++j) {
            const int from = std::clamp(y + j, 0, height - 1);
            const float weight = half[static_cast<std::size_t>(std::abs(j))];
            const float* row = along.data() + static_cast<std::size_t>(from) * n;
            for (std::size_t x = 0; x < n; ++x) {
                to[x] += weight * row[x];
            }
        }
    }
}

}  // namespace

void blur(float* levels, int width, const std::vector<double>& sigmas_px) {
    blur_rows(levels, width, 1, sigmas_px);
}

void blur(Colour* levels, int width, const std::vector<double>& sigmas_px) {
    static_assert(sizeof(Colour) == 3 * sizeof(float));
    blur_rows(levels->data(), width, 3, sigmas_px);
}

}  // namespace kambara
