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

#if HWY_TARGET == HWY_SCALAR || HWY_TARGET == HWY_EMU128 || !HWY_ARCH_X86

// The weight i places from the middle.
template <class Weights>
HWY_INLINE int weight_at(const Weights& weights, int i) {
    const auto from_middle = static_cast<std::size_t>(std::abs(i));
    return from_middle < weights.size() ? weights[from_middle] : 0;
}

void both_along(const std::uint8_t* row, const TwoGaussians& weights, int count, int, bool odd,
                std::int16_t* HWY_RESTRICT out) {
    for (int x = 0; x < count; ++x) {
        int narrow = 0;
        int wide = 0;
        for (int i = -4; i <= 4; ++i) {
            const int pixel = row[x + i] - 128;
            narrow += weight_at(weights.narrow, i) * pixel;
            wide += weight_at(weights.wide, i) * pixel;
        }
        out[2 * x] = static_cast<std::int16_t>(odd ? wide : narrow);
        out[2 * x + 1] = static_cast<std::int16_t>(odd ? narrow : wide);
    }
}

void larger_across(const std::int16_t* const* ten, bool odd, const TwoGaussians& weights, int count,
                   int results, int, std::uint8_t* HWY_RESTRICT out) {
    for (int y = 0; y < results; ++y, ++ten, odd = !odd, out += count) {
        for (int x = 0; x < count; ++x) {
            int difference = 0;
            for (int j = -4; j <= 4; ++j) {
                const std::int16_t* both = ten[j + 4] + 2 * x;
                const int narrow = j % 2 == 0 ? odd : !odd;  // its place
                difference += weight_at(weights.narrow, j) * both[narrow];
                difference -= weight_at(weights.wide, j) * both[1 - narrow];
            }
            out[x] = difference > 0 ? 1 : 0;
        }
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
                bool in_odd_row, std::int16_t* HWY_RESTRICT out) {
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
            const V16 first = in_odd_row ? more : less;
            const V16 other = in_odd_row ? less : more;
            hn::StoreU(hn::InterleaveLower(d16, first, other), d16, out);
            hn::StoreU(hn::InterleaveUpper(d16, first, other), d16, out + hn::Lanes(d16));
        }
    }
}

// Where there are registers enough, a compiler shall not load again what it could keep.
HWY_INLINE V16 load_once(const std::int16_t* from) {
    V16 loaded = hn::LoadU(D16(), from);
#if HWY_TARGET == HWY_AVX3_DL || HWY_TARGET == HWY_AVX3
    asm("" : "+v"(loaded.raw));
#endif
    return loaded;
}

// more - less across the rows from one vector on, of which the first is an odd one or not.
template <bool ODD>
HWY_INLINE V32 difference(const V16* nine, const V16* factors) {
    // Of the outer rows the wide sums alone count: those of an even row, which lie in the odd
    // places, and of an odd one are multiplied together.
    V32 sum = hn::Zero(D32());
    sum = add_products(sum, factors[3], hn::OddEven(nine[ODD ? 1 : 0], nine[ODD ? 0 : 1]));
    sum = add_products(sum, factors[3], hn::OddEven(nine[ODD ? 7 : 8], nine[ODD ? 8 : 7]));
    for (int j = 2; j <= 6; ++j) {
        sum = add_products(sum, factors[std::abs(j - 4)], nine[j]);
    }
    return sum;
}

// The signs of more - less. Packing undoes the interleaving: both work within 128 bits.
HWY_INLINE hn::Vec<D8> larger(const V32* more_less) {
    const D16 d16;
    const hn::RebindToUnsigned<D16> bits;
    const auto even = hn::BitCast(bits, hn::ReorderDemote2To(d16, more_less[0], more_less[1]));
    const auto odd = hn::BitCast(bits, hn::ReorderDemote2To(d16, more_less[2], more_less[3]));
    return hn::BitCast(D8(), hn::Or(hn::ShiftRight<15>(even),
                                    hn::And(hn::ShiftRight<7>(odd), hn::Set(bits, 0x100))));
}

HWY_INLINE void store_up_to(hn::Vec<D8> results, int count, int writable, std::uint8_t* out) {
    constexpr int lanes = static_cast<int>(HWY_LANES(std::uint8_t));
    if (writable >= lanes) {
        hn::StoreU(results, D8(), out);
    } else {
        std::uint8_t last[lanes];
        hn::StoreU(results, D8(), last);
        std::copy_n(last, std::min(count, lanes), out);
    }
}

// Two rows at once load nearly half as much. From the end on: what the first row's last vector
// writes beyond it is written over by the second row's first.
template <bool ODD, int RESULTS>
void larger_across_rows(const std::int16_t* const* ten, const TwoGaussians& weights, int count,
                        int writable, std::uint8_t* HWY_RESTRICT out) {
    constexpr int lanes = static_cast<int>(HWY_LANES(std::uint8_t));
    V16 factors[2][4];
    for (std::size_t odd = 0; odd < 2; ++odd) {
        for (std::size_t k = 0; k < 4; ++k) {
            factors[odd][k] = in_all_lanes(weights.across[odd][k]);
        }
    }
    for (int x = (count - 1) / lanes * lanes; x >= 0; x -= lanes) {
        V32 more_less[RESULTS][4];
        for (int k = 0; k < 4; ++k) {
            V16 rows[8 + RESULTS];
            for (int j = 0; j < 8 + RESULTS; ++j) {
                rows[j] = load_once(ten[j] + 2 * x + k * static_cast<int>(HWY_LANES(std::int16_t)));
            }
            more_less[0][k] = difference<ODD>(rows, factors[ODD]);
            if constexpr (RESULTS > 1) {
                more_less[1][k] = difference<!ODD>(rows + 1, factors[!ODD]);
            }
        }
        for (int y = 0; y < RESULTS; ++y) {
            store_up_to(larger(more_less[y]), count - x, writable - y * count - x,
                        out + y * count + x);
        }
    }
}

void larger_across(const std::int16_t* const* ten, bool odd, const TwoGaussians& weights, int count,
                   int results, int writable, std::uint8_t* HWY_RESTRICT out) {
    if (results == 1) {
        return odd ? larger_across_rows<true, 1>(ten, weights, count, writable, out)
                   : larger_across_rows<false, 1>(ten, weights, count, writable, out);
    }
    return odd ? larger_across_rows<true, 2>(ten, weights, count, writable, out)
               : larger_across_rows<false, 2>(ten, weights, count, writable, out);
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
    const auto pair = [](int low, int high) {
        return static_cast<std::uint32_t>((low & 0xFFFF) | high << 16);
    };
    for (std::size_t odd = 0; odd < 2; ++odd) {
        for (std::size_t k = 0; k < 3; ++k) {
            across[odd][k] =
                (k + odd) % 2 == 0 ? pair(-narrow[k], wide[k]) : pair(wide[k], -narrow[k]);
        }
        across[odd][3] = odd == 0 ? pair(wide[3], wide[4]) : pair(wide[4], wide[3]);
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
