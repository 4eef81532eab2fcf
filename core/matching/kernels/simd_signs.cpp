// SPDX-License-Identifier: GPL-3.0-or-later
// Signs of differences of Gaussians, exactly: both Gaussians along a row in 16 bits, then both
// across nine such rows in 32 bits. The pixels are less 128, which both sums leave out again.
#include <algorithm>
#include <cstdlib>

#include "core/matching/kernels/simd.h"
#include "core/matching/kernels/transform_rows.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/matching/kernels/simd_signs.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace kambara {
namespace HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR || !HWY_ARCH_X86

void both_along(const std::uint8_t* row, const TwoGaussians& weights, int count, int,
                std::int16_t* HWY_RESTRICT out) {
    for (int x = 0; x < count; ++x) {
        int narrow = 0;
        int wide = 0;
        for (int i = -4; i <= 4; ++i) {
            const int pixel = row[x + i] - 128;
            narrow += std::abs(i) <= 2 ? weights.narrow[std::abs(i)] * pixel : 0;
            wide += weights.wide[std::abs(i)] * pixel;
        }
        out[2 * x] = static_cast<std::int16_t>(narrow);
        out[2 * x + 1] = static_cast<std::int16_t>(wide);
    }
}

void larger_across(const std::int16_t* const* nine, const TwoGaussians& weights, int count, int,
                   std::uint8_t* HWY_RESTRICT out) {
    for (int x = 0; x < count; ++x) {
        int difference = 0;
        for (int j = -4; j <= 4; ++j) {
            const std::int16_t* both = nine[j + 4] + 2 * x;
            difference += std::abs(j) <= 2 ? weights.narrow[std::abs(j)] * both[0] : 0;
            difference -= weights.wide[std::abs(j)] * both[1];
        }
        out[x] = difference > 0 ? 1 : 0;
    }
}

void gather_bits(const std::uint8_t* row, int count, std::uint8_t* out) {
    for (int x = 0; x < count; ++x) {
        int bits = 0;
        for (int i = std::min(7, count - 1 - x); i >= 0; --i) {
            bits = 2 * bits + row[x + i];
        }
        out[x] = static_cast<std::uint8_t>(bits);
    }
}

#else

namespace hn = hwy::HWY_NAMESPACE;
using D8 = hn::ScalableTag<std::uint8_t>;
using D16 = hn::Repartition<std::int16_t, D8>;
using D32 = hn::Repartition<std::int32_t, D8>;
using V16 = hn::Vec<D16>;
using V32 = hn::Vec<D32>;

// Pairs of weights, at most 255 together, times pairs of pixels less 128: 16 bits hold the sums.
HWY_INLINE V16 sums_of_pairs(V16 weights, hn::Vec<D8> pixels) {
#if HWY_TARGET == HWY_SSE4
    return V16{_mm_maddubs_epi16(weights.raw, pixels.raw)};
#elif HWY_TARGET == HWY_AVX2
    return V16{_mm256_maddubs_epi16(weights.raw, pixels.raw)};
#else
    return V16{_mm512_maddubs_epi16(weights.raw, pixels.raw)};
#endif
}

// sum + a[2 i] b[2 i] + a[2 i + 1] b[2 i + 1] in each lane.
HWY_INLINE V32 add_products(V32 sum, V16 a, V16 b) {
#if HWY_TARGET == HWY_AVX3_DL
    // Highway's target has the instruction but does not tell the compiler so.
    asm("vpdpwssd %2, %1, %0" : "+v"(sum.raw) : "v"(a.raw), "vm"(b.raw));
    return sum;
#else
    V32 unused = hn::Zero(D32());
    return hn::ReorderWidenMulAccumulate(D32(), a, b, sum, unused);
#endif
}

HWY_INLINE V16 in_all_lanes(std::uint32_t pair) {
    return hn::BitCast(D16(), hn::Set(hn::RebindToUnsigned<D32>(), pair));
}

template <std::size_t PAIRS>
HWY_INLINE V16 weighted(const hn::Vec<D8>* pixels, const V16 (&weights)[PAIRS]) {
    V16 sum = sums_of_pairs(weights[0], pixels[0]);
    for (std::size_t k = 1; k < PAIRS; ++k) {
        sum = hn::Add(sum, sums_of_pairs(weights[k], pixels[k]));
    }
    return sum;
}

// A vector of pixels makes four of results: of the pixels at even places, then of those at odd
// ones, the two sums of each side by side.
void both_along(const std::uint8_t* row, const TwoGaussians& weights, int count, int readable,
                std::int16_t* HWY_RESTRICT out) {
    const D8 d8;
    const D16 d16;
    constexpr int lanes = static_cast<int>(HWY_LANES(std::uint8_t));
    const auto zero_level = hn::Set(d8, 128);
    V16 narrow[2][3];
    V16 wide[2][5];
    for (std::size_t odd = 0; odd < 2; ++odd) {
        for (std::size_t k = 0; k < 3; ++k) {
            narrow[odd][k] = in_all_lanes(weights.narrow_pairs[odd][k]);
        }
        for (std::size_t k = 0; k < 5; ++k) {
            wide[odd][k] = in_all_lanes(weights.wide_pairs[odd][k]);
        }
    }
    std::uint8_t last[lanes + 8] = {};
    for (int x = 0; x < count; x += lanes) {
        const std::uint8_t* from = row + x - 4;
        if (readable - x < lanes + 4) {
            std::copy_n(from, count - x + 8, last);
            from = last;
        }
        hn::Vec<D8> pixels[5];
        for (int k = 0; k < 5; ++k) {
            pixels[k] = hn::Xor(hn::LoadU(d8, from + 2 * k), zero_level);
        }
        for (int odd = 0; odd < 2; ++odd, out += 2 * hn::Lanes(d16)) {
            const V16 less = weighted(pixels + 1, narrow[odd]);
            const V16 more = weighted(pixels, wide[odd]);
            hn::StoreU(hn::InterleaveLower(d16, less, more), d16, out);
            hn::StoreU(hn::InterleaveUpper(d16, less, more), d16, out + hn::Lanes(d16));
        }
    }
}

void larger_across(const std::int16_t* const* nine, const TwoGaussians& weights, int count,
                   int writable, std::uint8_t* HWY_RESTRICT out) {
    const D16 d16;
    const D32 d32;
    const hn::RebindToUnsigned<D16> bits;
    constexpr int lanes = static_cast<int>(HWY_LANES(std::uint8_t));
    V16 factors[5];
    for (std::size_t j = 0; j < 5; ++j) {
        factors[j] = in_all_lanes(weights.across[j]);
    }
    for (int x = 0; x < count; x += lanes) {
        V32 sums[4];
        for (int k = 0; k < 4; ++k) {
            sums[k] = hn::Zero(d32);
            for (int j = 0; j < 9; ++j) {
                const std::int16_t* both = nine[j] + 2 * x + k * static_cast<int>(hn::Lanes(d16));
                sums[k] = add_products(sums[k], factors[std::abs(j - 4)], hn::LoadU(d16, both));
            }
        }
        // The sign of more - less. Packing undoes the interleaving: both work within 128 bits.
        const auto even = hn::BitCast(bits, hn::ReorderDemote2To(d16, sums[0], sums[1]));
        const auto odd = hn::BitCast(bits, hn::ReorderDemote2To(d16, sums[2], sums[3]));
        const auto larger =
            hn::BitCast(D8(), hn::Or(hn::ShiftRight<15>(even),
                                     hn::And(hn::ShiftRight<7>(odd), hn::Set(bits, 0x100))));
        if (writable - x >= lanes) {
            hn::StoreU(larger, D8(), out + x);
        } else {
            std::uint8_t last[lanes];
            hn::StoreU(larger, D8(), last);
            std::copy_n(last, count - x, out + x);
        }
    }
}

#if HWY_TARGET == HWY_AVX3_DL

// Bits of `count` pixels, at most 64; 0 after the last.
HWY_INLINE std::uint64_t bits_of(const std::uint8_t* row, int count) {
    const __mmask64 there = count >= 64 ? ~0ULL : (1ULL << std::max(count, 0)) - 1;
    const __m512i pixels = _mm512_maskz_loadu_epi8(there, row);
    return _mm512_test_epi8_mask(pixels, pixels);
}

// The row becomes one string of bits, of which each byte of the result is a piece.
void gather_bits(const std::uint8_t* row, int count, std::uint8_t* out) {
    // To each 64 bits the two bytes of the string that its eight results reach into, then eight
    // bits from each of the first eight on.
    alignas(64) std::uint8_t two_bytes[64];
    for (int i = 0; i < 64; ++i) {
        two_bytes[i] = static_cast<std::uint8_t>(i / 8 + (i % 8 == 1 ? 1 : 0));
    }
    const __m512i order = _mm512_load_si512(two_bytes);
    const __m512i shifts = _mm512_set1_epi64(0x0706050403020100);
    std::uint64_t bits = bits_of(row, count);
    for (int x = 0; x < count; x += 64) {
        const std::uint64_t next = bits_of(row + x + 64, count - x - 64);
        const __m128i both =
            _mm_set_epi64x(static_cast<std::int64_t>(next), static_cast<std::int64_t>(bits));
        const __m512i string = _mm512_permutexvar_epi8(order, _mm512_castsi128_si512(both));
        const __m512i gathered = _mm512_multishift_epi64_epi8(shifts, string);
        _mm512_storeu_si512(out + x, gathered);
        bits = next;
    }
}

#else

void gather_bits(const std::uint8_t* row, int count, std::uint8_t* out) {
    const D8 d;
    constexpr int lanes = static_cast<int>(HWY_LANES(std::uint8_t));
    for (int x = 0; x < count; x += lanes) {
        const std::uint8_t* from = row + x;
        std::uint8_t last[lanes + 7] = {};
        if (count - x < lanes + 7) {
            std::copy_n(from, count - x, last);
            from = last;
        }
        auto bits = hn::LoadU(d, from + 7);
        for (int i = 6; i >= 0; --i) {
            bits = hn::Add(hn::Add(bits, bits), hn::LoadU(d, from + i));
        }
        hn::StoreU(bits, d, out + x);
    }
}

#endif

#endif

}  // namespace HWY_NAMESPACE
}  // namespace kambara
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kambara {
namespace {

std::uint32_t twice(int low_byte, int high_byte) {
    return static_cast<std::uint32_t>(low_byte | high_byte << 8) * 0x10001U;
}

// Pairs of neighbours, the first pair beginning at `first`: where that is outside, with 0.
template <std::size_t SIDE, std::size_t PAIRS>
void set_pairs(const std::array<std::int16_t, SIDE>& weights, int first,
               std::array<std::uint32_t, PAIRS>& pairs) {
    const auto at = [&](int i) {
        const auto distance = static_cast<std::size_t>(std::abs(i));
        return distance < SIDE ? weights[distance] : 0;
    };
    for (std::uint32_t& pair : pairs) {
        pair = twice(at(first), at(first + 1));
        first += 2;
    }
}

}  // namespace

TwoGaussians::TwoGaussians(const std::array<std::int16_t, 3>& of_narrow,
                           const std::array<std::int16_t, 5>& of_wide)
    : narrow(of_narrow), wide(of_wide) {
    for (int odd = 0; odd < 2; ++odd) {
        set_pairs(narrow, -2 - odd, narrow_pairs[static_cast<std::size_t>(odd)]);
        set_pairs(wide, -4 - odd, wide_pairs[static_cast<std::size_t>(odd)]);
    }
    for (std::size_t j = 0; j < 5; ++j) {
        const int less = j < 3 ? -narrow[j] : 0;
        across[j] = static_cast<std::uint32_t>((less & 0xFFFF) | wide[j] << 16);
    }
}

HWY_EXPORT(both_along);
HWY_EXPORT(larger_across);
HWY_EXPORT(gather_bits);

void use_simd_signs(std::size_t target, TransformRows& rows) {
    rows.both_along = HWY_DISPATCH_TABLE(both_along)[target];
    rows.larger_across = HWY_DISPATCH_TABLE(larger_across)[target];
    rows.gather_bits = HWY_DISPATCH_TABLE(gather_bits)[target];
}

}  // namespace kambara
#endif
