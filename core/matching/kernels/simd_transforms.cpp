// SPDX-License-Identifier: GPL-3.0-or-later
// Plain loops, compiled once for each kind of vector unit: the compiler makes vector code of them.
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/matching/kernels/simd.h"
#include "core/matching/kernels/transform_rows.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/matching/kernels/simd_transforms.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace kambara {
namespace HWY_NAMESPACE {

template <int RADIUS>
HWY_INLINE void rank_row(const std::uint8_t* const* rows, int count,
                         std::uint8_t* HWY_RESTRICT out) {
    const std::uint8_t* centre = rows[RADIUS];
    std::fill_n(out, count, std::uint8_t{0});
    for (int j = 0; j <= 2 * RADIUS; ++j) {
        for (int i = -RADIUS; i <= RADIUS; ++i) {
            if (j == RADIUS && i == 0) {
                continue;
            }
            const std::uint8_t* neighbour = rows[j] + i;
            for (int x = 0; x < count; ++x) {
                out[x] = static_cast<std::uint8_t>(out[x] + (neighbour[x] < centre[x] ? 1 : 0));
            }
        }
    }
}

void rank3(const std::uint8_t* const* rows, int count, std::uint8_t* HWY_RESTRICT out) {
    const std::uint8_t* HWY_RESTRICT above = rows[0];
    const std::uint8_t* HWY_RESTRICT centre = rows[1];
    const std::uint8_t* HWY_RESTRICT below = rows[2];
    for (int x = 0; x < count; ++x) {
        const std::uint8_t c = centre[x];
        std::uint8_t darker = 0;
        darker = static_cast<std::uint8_t>(darker + (above[x - 1] < c ? 1 : 0));
        darker = static_cast<std::uint8_t>(darker + (above[x] < c ? 1 : 0));
        darker = static_cast<std::uint8_t>(darker + (above[x + 1] < c ? 1 : 0));
        darker = static_cast<std::uint8_t>(darker + (centre[x - 1] < c ? 1 : 0));
        darker = static_cast<std::uint8_t>(darker + (centre[x + 1] < c ? 1 : 0));
        darker = static_cast<std::uint8_t>(darker + (below[x - 1] < c ? 1 : 0));
        darker = static_cast<std::uint8_t>(darker + (below[x] < c ? 1 : 0));
        darker = static_cast<std::uint8_t>(darker + (below[x + 1] < c ? 1 : 0));
        out[x] = darker;
    }
}

void rank5(const std::uint8_t* const* rows, int count, std::uint8_t* HWY_RESTRICT out) {
    rank_row<2>(rows, count, out);
}

// The neighbours in reading order, eight to a byte, the first in the lowest bit.
void census(const std::uint8_t* const* rows, int count, std::uint8_t* HWY_RESTRICT out) {
    constexpr int block = 256;
    std::uint8_t bits[3][block];
    for (int start = 0; start < count; start += block) {
        const int n = std::min(block, count - start);
        const std::uint8_t* centre = rows[2] + start;
        int k = 0;
        for (int j = 0; j < 5; ++j) {
            for (int i = -2; i <= 2; ++i) {
                if (j == 2 && i == 0) {
                    continue;
                }
                const std::uint8_t* neighbour = rows[j] + i + start;
                std::uint8_t* HWY_RESTRICT to = bits[k / 8];
                const auto bit = static_cast<std::uint8_t>(1U << (k % 8));
                if (k % 8 == 0) {
                    for (int x = 0; x < n; ++x) {
                        to[x] = neighbour[x] < centre[x] ? bit : std::uint8_t{0};
                    }
                } else {
                    for (int x = 0; x < n; ++x) {
                        to[x] = static_cast<std::uint8_t>(
                            to[x] | (neighbour[x] < centre[x] ? bit : std::uint8_t{0}));
                    }
                }
                ++k;
            }
        }
        for (int x = 0; x < n; ++x) {
            out[3 * (start + x)] = bits[0][x];
            out[3 * (start + x) + 1] = bits[1][x];
            out[3 * (start + x) + 2] = bits[2][x];
        }
    }
}

void gradient(const std::uint8_t* const* rows, int count, std::uint8_t* HWY_RESTRICT out) {
    const std::uint8_t* HWY_RESTRICT a = rows[0];
    const std::uint8_t* HWY_RESTRICT b = rows[1];
    const std::uint8_t* HWY_RESTRICT c = rows[2];
    for (int x = 0; x < count; ++x) {
        const int across = a[x + 1] + 2 * b[x + 1] + c[x + 1] - a[x - 1] - 2 * b[x - 1] - c[x - 1];
        const int down = c[x - 1] + 2 * c[x] + c[x + 1] - a[x - 1] - 2 * a[x] - a[x + 1];
        // The square root is correctly rounded, so the same on every processor.
        const float size = 0.25F * std::sqrt(static_cast<float>(across * across + down * down));
        out[x] = static_cast<std::uint8_t>(std::min(255, static_cast<int>(size)));
    }
}

void smooth_along(const std::uint8_t* row, const std::uint16_t* weights, int radius, int count,
                  std::uint16_t* HWY_RESTRICT out) {
    for (int x = 0; x < count; ++x) {
        out[x] = static_cast<std::uint16_t>(weights[0] * row[x]);
    }
    for (int i = 1; i <= radius; ++i) {
        const std::uint16_t weight = weights[i];
        for (int x = 0; x < count; ++x) {
            const auto both = static_cast<std::uint16_t>(row[x - i] + row[x + i]);
            out[x] = static_cast<std::uint16_t>(out[x] + static_cast<std::uint16_t>(weight * both));
        }
    }
}

void smooth_across(const std::uint16_t* const* rows, const std::uint16_t* weights, int radius,
                   int count, std::uint32_t* HWY_RESTRICT out) {
    const std::uint16_t* centre = rows[radius];
    for (int x = 0; x < count; ++x) {
        out[x] = static_cast<std::uint32_t>(weights[0]) * centre[x];
    }
    for (int j = 1; j <= radius; ++j) {
        const std::uint16_t* above = rows[radius - j];
        const std::uint16_t* below = rows[radius + j];
        const std::uint32_t weight = weights[j];
        for (int x = 0; x < count; ++x) {
            out[x] += weight * (static_cast<std::uint32_t>(above[x]) + below[x]);
        }
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace kambara
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kambara {
namespace {

HWY_EXPORT(rank3);
HWY_EXPORT(rank5);
HWY_EXPORT(census);
HWY_EXPORT(gradient);
HWY_EXPORT(smooth_along);
HWY_EXPORT(smooth_across);

TransformRows best_rows() {
    static_cast<void>(best_kernels());  // which sets the target
    const std::size_t target = hwy::GetChosenTarget().GetIndex();
    return {HWY_DISPATCH_TABLE(rank3)[target],        HWY_DISPATCH_TABLE(rank5)[target],
            HWY_DISPATCH_TABLE(census)[target],       HWY_DISPATCH_TABLE(gradient)[target],
            HWY_DISPATCH_TABLE(smooth_along)[target], HWY_DISPATCH_TABLE(smooth_across)[target]};
}

}  // namespace

const TransformRows& transform_rows() {
    static const TransformRows rows = best_rows();
    return rows;
}

}  // namespace kambara
#endif
