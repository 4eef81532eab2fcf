// SPDX-License-Identifier: GPL-3.0-or-later
// Sums of columns, and the step from integer sums to correlations.
#include <algorithm>

#include "core/matching/kernels/simd.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/matching/kernels/simd_finish.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace kambara {
namespace HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR

void roll_columns(const std::uint8_t* added, const std::uint8_t* removed, int count,
                  std::uint32_t* sums, std::uint32_t* squares) {
    plain_kernels().roll_columns(added, removed, count, sums, squares);
}
void take_off(const std::uint8_t* added, std::ptrdiff_t stride, int rows,
              const std::uint8_t* removed, int width, int count, std::uint32_t* sums,
              std::uint32_t* costs) {
    plain_kernels().take_off(added, stride, rows, removed, width, count, sums, costs);
}
void roll_and_sum(const std::uint8_t* added, const std::uint8_t* removed, int count,
                  std::uint32_t* column_sums, std::uint32_t* column_squares, std::uint32_t* sums,
                  std::uint32_t* squares) {
    plain_kernels().roll_and_sum(added, removed, count, column_sums, column_squares, sums, squares);
}
void correlate(const std::int32_t* dots, const std::uint32_t* sums, const std::uint32_t* squares,
               int width, int count, const Normalisation& norm, float* out) {
    plain_kernels().correlate(dots, sums, squares, width, count, norm, out);
}

float largest(const float* scores, int count) {
    return plain_kernels().largest(scores, count);
}
std::uint32_t smallest(const std::uint32_t* costs, int count) {
    return plain_kernels().smallest(costs, count);
}

#else

namespace hn = hwy::HWY_NAMESPACE;
using D32 = hn::ScalableTag<std::int32_t>;
using DU32 = hn::RebindToUnsigned<D32>;
using DF = hn::RebindToFloat<D32>;
using DBytes = hn::Rebind<std::uint8_t, D32>;
using D16 = hn::Rebind<std::int16_t, D32>;
using DHalf = hn::Half<D32>;
using DD = hn::Rebind<double, DHalf>;
using V32 = hn::Vec<D32>;
using VU32 = hn::Vec<DU32>;
using VF = hn::Vec<DF>;
using VD = hn::Vec<DD>;

// a^2 - r^2 = (a - r) (a + r), of factors that fit 16 bits.
HWY_INLINE V32 difference_of_squares(V32 difference, V32 sum) {
#if HWY_ARCH_X86
    const hn::Repartition<std::int16_t, D32> d16;
    V32 unused = hn::Zero(D32());
    return hn::ReorderWidenMulAccumulate(D32(), hn::BitCast(d16, difference), hn::BitCast(d16, sum),
                                         hn::Zero(D32()), unused);
#else
    return hn::Mul(difference, sum);
#endif
}

// A vector of columns rolled on.
struct Columns {
    VU32 sums;
    VU32 squares;
};
HWY_INLINE Columns roll(const std::uint8_t* added, const std::uint8_t* removed, std::uint32_t* sums,
                        std::uint32_t* squares) {
    const D32 d;
    const DU32 du;
    const DBytes bytes;
    const V32 a = added != nullptr ? hn::PromoteTo(d, hn::LoadU(bytes, added)) : hn::Zero(d);
    const V32 r = removed != nullptr ? hn::PromoteTo(d, hn::LoadU(bytes, removed)) : hn::Zero(d);
    const V32 difference = hn::Sub(a, r);
    const V32 of_squares = difference_of_squares(difference, hn::Add(a, r));
    const Columns rolled{hn::Add(hn::LoadU(du, sums), hn::BitCast(du, difference)),
                         hn::Add(hn::LoadU(du, squares), hn::BitCast(du, of_squares))};
    hn::StoreU(rolled.sums, du, sums);
    hn::StoreU(rolled.squares, du, squares);
    return rolled;
}

void roll_columns(const std::uint8_t* added, const std::uint8_t* removed, int count,
                  std::uint32_t* sums, std::uint32_t* squares) {
    for (int x = 0; x < count; x += static_cast<int>(hn::Lanes(D32()))) {
        roll(added != nullptr ? added + x : nullptr, removed != nullptr ? removed + x : nullptr,
             sums + x, squares + x);
    }
}

// Sums of a few pixels fit 16 bits.
template <int WIDTH>
HWY_INLINE hn::Vec<D16> sum_of_few(const std::uint8_t* pixels) {
    const D16 d;
    const hn::Rebind<std::uint8_t, D16> bytes;
    const auto first = hn::PromoteTo(d, hn::LoadU(bytes, pixels));
    if constexpr (WIDTH > 1) {
        return hn::Add(first, sum_of_few<WIDTH - 1>(pixels + 1));
    }
    return first;
}

template <int WIDTH>
void take_few_off(const std::uint8_t* added, std::ptrdiff_t stride, int rows,
                  const std::uint8_t* removed, int count, std::uint32_t* sums,
                  std::uint32_t* costs) {
    const D32 d;
    const DU32 du;
    const int lanes = static_cast<int>(hn::Lanes(d));
    for (int x = 0; x < count; x += lanes) {
        V32 change = hn::Zero(d);
        for (int y = 0; y < rows; ++y) {
            change = hn::Add(change, hn::PromoteTo(d, sum_of_few<WIDTH>(added + y * stride + x)));
        }
        if (removed != nullptr) {
            change = hn::Sub(change, hn::PromoteTo(d, sum_of_few<WIDTH>(removed + x)));
        }
        const VU32 sum = hn::Add(hn::LoadU(du, sums + x), hn::BitCast(du, change));
        hn::StoreU(sum, du, sums + x);
        if (costs != nullptr && count - x >= lanes) {
            hn::StoreU(hn::Sub(hn::LoadU(du, costs + x), sum), du, costs + x);
        } else if (costs != nullptr) {
            for (int i = x; i < count; ++i) {
                costs[i] -= sums[i];
            }
        }
    }
}

void take_off(const std::uint8_t* added, std::ptrdiff_t stride, int rows,
              const std::uint8_t* removed, int width, int count, std::uint32_t* sums,
              std::uint32_t* costs) {
    switch (width) {
        case 1:
            return take_few_off<1>(added, stride, rows, removed, count, sums, costs);
        case 2:
            return take_few_off<2>(added, stride, rows, removed, count, sums, costs);
        default:
            return take_few_off<3>(added, stride, rows, removed, count, sums, costs);
    }
}

// Sums from the first lane on: of two lanes, of four and so on.
HWY_INLINE VU32 prefix_of(VU32 v) {
#if HWY_TARGET == HWY_AVX3_DL || HWY_TARGET == HWY_AVX3
    const __m512i none = _mm512_setzero_si512();
    v = hn::Add(v, VU32{_mm512_alignr_epi32(v.raw, none, 15)});
    v = hn::Add(v, VU32{_mm512_alignr_epi32(v.raw, none, 14)});
    v = hn::Add(v, VU32{_mm512_alignr_epi32(v.raw, none, 12)});
    return hn::Add(v, VU32{_mm512_alignr_epi32(v.raw, none, 8)});
#else
    v = hn::Add(v, hn::ShiftLeftLanes<1>(v));
    v = hn::Add(v, hn::ShiftLeftLanes<2>(v));
#if HWY_TARGET == HWY_AVX2
    return hn::Add(v, hn::ConcatLowerLower(DU32(), hn::Broadcast<3>(v), hn::Zero(DU32())));
#else
    return v;
#endif
#endif
}

HWY_INLINE VU32 last_everywhere(VU32 v) {
#if HWY_TARGET == HWY_AVX3_DL || HWY_TARGET == HWY_AVX3
    return VU32{_mm512_permutexvar_epi32(_mm512_set1_epi32(15), v.raw)};
#elif HWY_TARGET == HWY_AVX2
    return VU32{_mm256_permutevar8x32_epi32(v.raw, _mm256_set1_epi32(7))};
#else
    return hn::Broadcast<3>(v);
#endif
}

// The prefix sums of one more vector, on top of those before.
HWY_INLINE VU32 sum_on(VU32 columns, VU32 before, std::uint32_t* out) {
    const VU32 sums = prefix_of(columns);
    hn::StoreU(hn::Add(sums, before), DU32(), out);
    return hn::Add(before, last_everywhere(sums));
}

void roll_and_sum(const std::uint8_t* added, const std::uint8_t* removed, int count,
                  std::uint32_t* column_sums, std::uint32_t* column_squares, std::uint32_t* sums,
                  std::uint32_t* squares) {
    const int lanes = static_cast<int>(hn::Lanes(D32()));
    VU32 sum = hn::Zero(DU32());
    VU32 square = hn::Zero(DU32());
    sums[0] = 0;
    squares[0] = 0;
    for (int x = 0; x < count; x += lanes) {
        const Columns columns = roll(added + x, removed != nullptr ? removed + x : nullptr,
                                     column_sums + x, column_squares + x);
        sum = sum_on(columns.sums, sum, sums + x + 1);
        square = sum_on(columns.squares, square, squares + x + 1);
    }
}

// Correctly rounded, which a plain conversion of unsigned numbers is not on every processor.
HWY_INLINE VF float_of(VU32 value) {
    const D32 d;
    const DF df;
    const VF high = hn::ConvertTo(df, hn::BitCast(d, hn::ShiftRight<16>(value)));
    const VF low = hn::ConvertTo(df, hn::BitCast(d, hn::And(value, hn::Set(DU32(), 0xFFFFU))));
    return hn::MulAdd(high, hn::Set(df, 65536.0F), low);
}

HWY_INLINE VF score_of(VF numerator, VF variance, VF template_factor) {
    const DF df;
    const VF product = hn::Mul(variance, template_factor);
    const VF score = hn::Div(numerator, hn::Sqrt(product));
    const VF clamped = hn::Min(hn::Max(score, hn::Set(df, -1.0F)), hn::Set(df, 1.0F));
    return hn::IfThenElseZero(hn::Gt(product, hn::Zero(df)), clamped);
}

// The last vector may be a part of one.
HWY_INLINE void store_scores(VF scores, int count, float* out) {
    const DF d;
    if (count >= static_cast<int>(hn::Lanes(d))) {
        hn::StoreU(scores, d, out);
    } else {
        float last[HWY_LANES(float)];
        hn::StoreU(scores, d, last);
        std::copy_n(last, count, out);
    }
}

// Up to this many pixels, N C - S sum(T) and N Q - S^2 fit into 32 bits.
constexpr double most_in_32_bits = 363.0;

void correlate_small(const std::int32_t* dots, const std::uint32_t* sums,
                     const std::uint32_t* squares, int width, int count, const Normalisation& norm,
                     float* out) {
    const D32 d;
    const DU32 du;
    const DF df;
    const V32 n = hn::Set(d, static_cast<std::int32_t>(norm.count));
    const V32 of_template = hn::Set(d, static_cast<std::int32_t>(norm.template_sum));
    const VF template_factor = hn::Set(df, static_cast<float>(norm.template_squares));
    for (int x = 0; x < count; x += static_cast<int>(hn::Lanes(d))) {
        const V32 dot = hn::LoadU(d, dots + x);
        const VU32 sum = hn::Sub(hn::LoadU(du, sums + x + width), hn::LoadU(du, sums + x));
        const VU32 square = hn::Sub(hn::LoadU(du, squares + x + width), hn::LoadU(du, squares + x));
        const V32 signed_sum = hn::BitCast(d, sum);
        VF numerator;
        VF variance;
        if (norm.zero_mean) {
            numerator =
                hn::ConvertTo(df, hn::Sub(hn::Mul(n, dot), hn::Mul(signed_sum, of_template)));
            variance = float_of(hn::Sub(hn::BitCast(du, hn::Mul(n, hn::BitCast(d, square))),
                                        hn::BitCast(du, hn::Mul(signed_sum, signed_sum))));
        } else {
            numerator = float_of(hn::Add(hn::BitCast(du, dot), hn::ShiftLeft<7>(sum)));
            variance = float_of(square);
        }
        store_scores(score_of(numerator, variance, template_factor), count - x, out + x);
    }
}

// Exact: every product stays below 2^53.
HWY_INLINE VD double_of(hn::Vec<hn::RebindToUnsigned<DHalf> > value) {
    const DHalf half;
    const hn::RebindToUnsigned<DHalf> unsigned_half;
    const DD dd;
    const VD high = hn::PromoteTo(dd, hn::BitCast(half, hn::ShiftRight<16>(value)));
    const VD low =
        hn::PromoteTo(dd, hn::BitCast(half, hn::And(value, hn::Set(unsigned_half, 0xFFFFU))));
    return hn::Add(hn::Mul(high, hn::Set(dd, 65536.0)), low);
}

// With half the pixels that 32 bits hold squares of, the squares' sums are not negative as signed
// numbers either, and convert at once.
template <bool HALF_FULL>
HWY_INLINE VD double_of_squares(hn::Vec<hn::RebindToUnsigned<DHalf> > value) {
    if constexpr (HALF_FULL) {
        return hn::PromoteTo(DD(), hn::BitCast(DHalf(), value));
    } else {
        return double_of(value);
    }
}

constexpr double most_in_31_bits = 33025.0;

template <bool HALF_FULL>
void correlate_large(const std::int32_t* dots, const std::uint32_t* sums,
                     const std::uint32_t* squares, int width, int count, const Normalisation& norm,
                     float* out) {
    const DHalf half;
    const hn::RebindToUnsigned<DHalf> unsigned_half;
    const DD dd;
    const hn::Rebind<float, DHalf> float_half;
    const DF df;
    const VD n = hn::Set(dd, norm.count);
    const VD of_template = hn::Set(dd, norm.template_sum);
    const VF template_factor = hn::Set(df, static_cast<float>(norm.template_squares));
    const int lanes = static_cast<int>(hn::Lanes(df));
    const int lanes_half = static_cast<int>(hn::Lanes(half));
    using VHalf = hn::Vec<hn::Rebind<float, DHalf> >;
    for (int x = 0; x < count; x += lanes) {
        VHalf numerators[2];
        VHalf variances[2];
        for (int i = 0; i < 2; ++i) {
            const int h = i * lanes_half;
            const VD dot = hn::PromoteTo(dd, hn::LoadU(half, dots + x + h));
            const VD sum =
                double_of_squares<true>(hn::Sub(hn::LoadU(unsigned_half, sums + x + h + width),
                                                hn::LoadU(unsigned_half, sums + x + h)));
            const VD square = double_of_squares<HALF_FULL>(
                hn::Sub(hn::LoadU(unsigned_half, squares + x + h + width),
                        hn::LoadU(unsigned_half, squares + x + h)));
            VD numerator;
            VD variance;
            if (norm.zero_mean) {
                numerator = hn::Sub(hn::Mul(n, dot), hn::Mul(sum, of_template));
                variance = hn::Sub(hn::Mul(n, square), hn::Mul(sum, sum));
            } else {
                numerator = hn::Add(dot, hn::Mul(hn::Set(dd, 128.0), sum));
                variance = square;
            }
            numerators[i] = hn::DemoteTo(float_half, numerator);
            variances[i] = hn::DemoteTo(float_half, variance);
        }
        store_scores(score_of(hn::Combine(df, numerators[1], numerators[0]),
                              hn::Combine(df, variances[1], variances[0]), template_factor),
                     count - x, out + x);
    }
}

void correlate(const std::int32_t* dots, const std::uint32_t* sums, const std::uint32_t* squares,
               int width, int count, const Normalisation& norm, float* out) {
    if (norm.count <= most_in_32_bits) {
        correlate_small(dots, sums, squares, width, count, norm, out);
    } else if (norm.count <= most_in_31_bits) {
        correlate_large<true>(dots, sums, squares, width, count, norm, out);
    } else {
        correlate_large<false>(dots, sums, squares, width, count, norm, out);
    }
}

float largest(const float* scores, int count) {
    const DF d;
    const int lanes = static_cast<int>(hn::Lanes(d));
    float best = scores[0];
    if (count >= lanes) {
        VF most = hn::LoadU(d, scores);
        for (int x = lanes; x + lanes <= count; x += lanes) {
            most = hn::Max(most, hn::LoadU(d, scores + x));
        }
        most = hn::Max(most, hn::LoadU(d, scores + count - lanes));
        best = hn::GetLane(hn::MaxOfLanes(d, most));
    } else {
        for (int x = 1; x < count; ++x) {
            best = scores[x] > best ? scores[x] : best;
        }
    }
    return best;
}

std::uint32_t smallest(const std::uint32_t* costs, int count) {
    const DU32 d;
    const int lanes = static_cast<int>(hn::Lanes(d));
    std::uint32_t best = costs[0];
    if (count >= lanes) {
        VU32 least = hn::LoadU(d, costs);
        for (int x = lanes; x + lanes <= count; x += lanes) {
            least = hn::Min(least, hn::LoadU(d, costs + x));
        }
        least = hn::Min(least, hn::LoadU(d, costs + count - lanes));
        best = hn::GetLane(hn::MinOfLanes(d, least));
    } else {
        for (int x = 1; x < count; ++x) {
            best = costs[x] < best ? costs[x] : best;
        }
    }
    return best;
}

#endif

}  // namespace HWY_NAMESPACE
}  // namespace kambara
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kambara {

HWY_EXPORT(roll_columns);
HWY_EXPORT(take_off);
HWY_EXPORT(roll_and_sum);
HWY_EXPORT(correlate);
HWY_EXPORT(largest);
HWY_EXPORT(smallest);

void use_simd_finish(Kernels& kernels) {
    const std::size_t target = hwy::GetChosenTarget().GetIndex();
    kernels.roll_columns = HWY_DISPATCH_TABLE(roll_columns)[target];
    kernels.take_off = HWY_DISPATCH_TABLE(take_off)[target];
    kernels.roll_and_sum = HWY_DISPATCH_TABLE(roll_and_sum)[target];
    kernels.largest = HWY_DISPATCH_TABLE(largest)[target];
    kernels.smallest = HWY_DISPATCH_TABLE(smallest)[target];
    kernels.correlate = HWY_DISPATCH_TABLE(correlate)[target];
}

}  // namespace kambara
#endif
