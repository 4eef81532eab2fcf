// SPDX-License-Identifier: GPL-3.0-or-later
#include "hardware/simulated/blur.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace kambara {

void blur(std::vector<float>& grey, int width, int height, double sigma_px) {
    const int reach = std::max(1, static_cast<int>(std::ceil(3.0 * sigma_px)));
    std::vector<float> weights;
    float sum = 0.0F;
    for (int i = 0; i <= reach; ++i) {
        const double t = i / sigma_px;
        weights.push_back(static_cast<float>(std::exp(-0.5 * t * t)));
        sum += i == 0 ? weights.back() : 2.0F * weights.back();
    }
    const auto n = static_cast<std::size_t>(width);
    std::vector<float> along(grey.size());
    std::vector<float> padded(n + 2 * static_cast<std::size_t>(reach));
    for (int y = 0; y < height; ++y) {
        const float* row = grey.data() + static_cast<std::size_t>(y) * n;
        std::fill_n(padded.begin(), reach, row[0]);
        std::copy_n(row, n, padded.begin() + reach);
        std::fill_n(padded.end() - reach, reach, row[n - 1]);
        float* to = along.data() + static_cast<std::size_t>(y) * n;
        const float* middle = padded.data() + reach;
        for (int i = -reach; i <= reach; ++i) {
            const float weight = weights[static_cast<std::size_t>(std::abs(i))] / sum;
            for (int x = 0; x < width; ++x) {
                to[x] += weight * middle[x + i];
            }
        }
    }
    std::fill(grey.begin(), grey.end(), 0.0F);
    for (int y = 0; y < height; ++y) {
        float* to = grey.data() + static_cast<std::size_t>(y) * n;
        for (int j = -reach; j <= reach; ++j) {
            const int from = std::clamp(y + j, 0, height - 1);
            const float weight = weights[static_cast<std::size_t>(std::abs(j))] / sum;
            const float* row = along.data() + static_cast<std::size_t>(from) * n;
            for (int x = 0; x < width; ++x) {
                to[x] += weight * row[x];
            }
        }
    }
}

}  // namespace kambara
