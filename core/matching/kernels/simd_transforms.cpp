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

HWY_INLINE std::uint8_t rank3_at(const std::uint8_t* const* rows, int x) {
    int darker = 0;
    for (int j = 0; j < 3; ++j) {
        for (int i = -1; i <= 1; ++i) {
            darker += rows[j][x + i] < rows[1][x] ? 1 : 0;
        }
    }
    return static_cast<std::uint8_t>(darker);
}

void rank3(const std::uint8_t* const* rows, int count, std::uint8_t* HWY_RESTRICT out) {
    int x = 0;
#if HWY_TARGET != HWY_SCALAR
    namespace hn = hwy::HWY_NAMESPACE;
    const hn::ScalableTag<std::uint8_t> d;
    const int lanes = static_cast<int>(hn::Lanes(d));
    const auto one = hn::Set(d, 1);
    while (count >= lanes && x < count) {
        // The last vector ends with the row, and does a part of the one before again.
        const int at = std::min(x, count - lanes);
        const auto centre = hn::LoadU(d, rows[1] + at);
        auto darker = hn::Zero(d);
        for (int k = 0; k < 9; ++k) {
            const auto neighbour = hn::LoadU(d, rows[k / 3] + at + k % 3 - 1);
            darker = hn::Add(darker, hn::Min(hn::SaturatedSub(centre, neighbour), one));
        }
        hn::StoreU(darker, d, out + at);
        x += lanes;
    }
#endif
    for (; x < count; ++x) {
        out[x] = rank3_at(rows, x);
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

void smooth_along(const std::uint8_t* row, const std::int16_t* weights, int count,
                  std::int16_t* HWY_RESTRICT out) {
    std::uint16_t w[4];
    for (int i = 0; i <= 3; ++i) {
        w[i] = static_cast<std::uint16_t>(weights[i]);
    }
    for (int x = 0; x < count; ++x) {
        auto sum = static_cast<std::uint16_t>(w[0] * row[x]);
        for (int i = 1; i <= 3; ++i) {
            const auto both = static_cast<std::uint16_t>(row[x - i] + row[x + i]);
            sum = static_cast<std::uint16_t>(sum + static_cast<std::uint16_t>(w[i] * both));
        }
        out[x] = static_cast<std::int16_t>(sum >> 2U);
    }
}

// One position of what smooth_across does.
HWY_INLINE std::uint8_t smooth_at(const std::int16_t* const* seven, const std::int16_t* weights,
                                  int x) {
    int sum = weights[0] * seven[3][x];
    for (int j = 1; j <= 3; ++j) {
        sum += weights[j] * (seven[3 - j][x] + seven[3 + j][x]);
    }
    return static_cast<std::uint8_t>((sum + 8192) >> 14);
}

void smooth_across(const std::int16_t* const* seven, const std::int16_t* weights, int count,
                   std::uint8_t* HWY_RESTRICT out) {
    int x = 0;
#if HWY_ARCH_X86 && HWY_TARGET != HWY_SCALAR
    // Four terms: symmetric rows are added first, then pairs of terms multiplied and added at once.
    namespace hn = hwy::HWY_NAMESPACE;
    const hn::ScalableTag<std::int16_t> d;
    const hn::RepartitionToWide<decltype(d)> d32;
    const hn::Rebind<std::uint8_t, decltype(d)> bytes;
    using V = hn::Vec<decltype(d)>;
    using V32 = hn::Vec<decltype(d32)>;
    const int lanes = static_cast<int>(hn::Lanes(d));
    V factors[2];
    for (int k = 0; k < 2; ++k) {
        std::int32_t pair;
        std::memcpy(&pair, weights + 2 * k, sizeof(pair));
        factors[k] = hn::BitCast(d, hn::Set(d32, pair));
    }
    const V32 half = hn::Set(d32, 8192);
    for (; x + lanes <= count; x += lanes) {
        const V terms[4] = {hn::LoadU(d, seven[3] + x),
                            hn::Add(hn::LoadU(d, seven[2] + x), hn::LoadU(d, seven[4] + x)),
                            hn::Add(hn::LoadU(d, seven[1] + x), hn::LoadU(d, seven[5] + x)),
                            hn::Add(hn::LoadU(d, seven[0] + x), hn::LoadU(d, seven[6] + x))};
        V32 low = half;
        V32 high = half;
        V32 unused = hn::Zero(d32);
        for (int k = 0; k < 2; ++k) {
            const V a = terms[2 * k];
            const V b = terms[2 * k + 1];
            low = hn::ReorderWidenMulAccumulate(d32, hn::InterleaveLower(d, a, b), factors[k], low,
                                                unused);
            high = hn::ReorderWidenMulAccumulate(d32, hn::InterleaveUpper(d, a, b), factors[k],
                                                 high, unused);
        }
        // Packing undoes the interleaving: both work within 128 bits.
        const V grey = hn::ReorderDemote2To(d, hn::ShiftRight<14>(low), hn::ShiftRight<14>(high));
        hn::StoreU(hn::DemoteTo(bytes, grey), bytes, out + x);
    }
#endif
    for (; x < count; ++x) {
        out[x] = smooth_at(seven, weights, x);
    }
}

#if HWY_TARGET != HWY_SCALAR
template <class D>
HWY_INLINE int split_by(D d, const std::uint8_t* pixels, int x, int count, std::uint8_t* first,
                        std::uint8_t* second, std::uint8_t* third) {
    namespace hn = hwy::HWY_NAMESPACE;
    const int lanes = static_cast<int>(hn::Lanes(d));
    for (; x + lanes <= count; x += lanes) {
        hn::Vec<D> a;
        hn::Vec<D> b;
        hn::Vec<D> c;
        hn::LoadInterleaved3(d, pixels + 3 * x, a, b, c);
        hn::StoreU(a, d, first + x);
        hn::StoreU(b, d, second + x);
        hn::StoreU(c, d, third + x);
    }
    return x;
}
#endif

void split(const std::uint8_t* pixels, int count, std::uint8_t* HWY_RESTRICT first,
           std::uint8_t* HWY_RESTRICT second, std::uint8_t* HWY_RESTRICT third) {
    int x = 0;
#if HWY_TARGET != HWY_SCALAR
    namespace hn = hwy::HWY_NAMESPACE;
    x = split_by(hn::ScalableTag<std::uint8_t>(), pixels, x, count, first, second, third);
    // What is left of narrow windows is much of them.
    x = split_by(hn::FixedTag<std::uint8_t, 16>(), pixels, x, count, first, second, third);
#endif
    for (; x < count; ++x) {
        first[x] = pixels[3 * x];
        second[x] = pixels[3 * x + 1];
        third[x] = pixels[3 * x + 2];
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace kambara
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kambara {

HWY_EXPORT(rank3);
HWY_EXPORT(rank5);
HWY_EXPORT(census);
HWY_EXPORT(gradient);
HWY_EXPORT(smooth_along);
HWY_EXPORT(smooth_across);
HWY_EXPORT(split);

void use_simd_transforms(std::size_t target, TransformRows& rows) {
    rows.rank3 = HWY_DISPATCH_TABLE(rank3)[target];
    rows.rank5 = HWY_DISPATCH_TABLE(rank5)[target];
    rows.census = HWY_DISPATCH_TABLE(census)[target];
    rows.gradient = HWY_DISPATCH_TABLE(gradient)[target];
    rows.smooth_along = HWY_DISPATCH_TABLE(smooth_along)[target];
    rows.smooth_across = HWY_DISPATCH_TABLE(smooth_across)[target];
    rows.split = HWY_DISPATCH_TABLE(split)[target];
}

}  // namespace kambara
#endif
