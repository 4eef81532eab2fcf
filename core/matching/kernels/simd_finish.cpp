// SPDX-License-Identifier: GPL-3.0-or-later
// Sums of columns and windows, and the step from integer sums to correlations.
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
void window_sums(const std::uint32_t* in, int width, int count, std::uint32_t* scratch,
                 std::uint32_t* out) {
    plain_kernels().window_sums(in, width, count, scratch, out);
}
void correlate(const std::int32_t* dots, const std::uint32_t* sums, const std::uint32_t* squares,
               int count, const Normalisation& norm, float* out) {
    plain_kernels().correlate(dots, sums, squares, count, norm, out);
}

#else

namespace hn = hwy::HWY_NAMESPACE;
using D32 = hn::ScalableTag<std::int32_t>;
using DU32 = hn::RebindToUnsigned<D32>;
using DF = hn::RebindToFloat<D32>;
using DBytes = hn::Rebind<std::uint8_t, D32>;
using DHalf = hn::Half<D32>;
using DD = hn::Rebind<double, DHalf>;
using V32 = hn::Vec<D32>;
using VU32 = hn::Vec<DU32>;
using VF = hn::Vec<DF>;
using VD = hn::Vec<DD>;

void roll_columns(const std::uint8_t* added, const std::uint8_t* removed, int count,
                  std::uint32_t* sums, std::uint32_t* squares) {
    const D32 d;
    const DU32 du;
    const DBytes bytes;
    for (int x = 0; x < count; x += static_cast<int>(hn::Lanes(d))) {
        const V32 a =
            added != nullptr ? hn::PromoteTo(d, hn::LoadU(bytes, added + x)) : hn::Zero(d);
        const V32 r =
            removed != nullptr ? hn::PromoteTo(d, hn::LoadU(bytes, removed + x)) : hn::Zero(d);
        const V32 difference = hn::Sub(a, r);
        const V32 of_squares = hn::Mul(difference, hn::Add(a, r));  // a^2 - r^2
        hn::StoreU(hn::Add(hn::LoadU(du, sums + x), hn::BitCast(du, difference)), du, sums + x);
        hn::StoreU(hn::Add(hn::LoadU(du, squares + x), hn::BitCast(du, of_squares)), du,
                   squares + x);
    }
}

// By doubling: sums over 1, 2, 4, ... columns, put together by the bits of the width.
void window_sums(const std::uint32_t* in, int width, int count, std::uint32_t* scratch,
                 std::uint32_t* out) {
    const DU32 d;
    const int lanes = static_cast<int>(hn::Lanes(d));
    const std::uint32_t* of_span = in;  // sums over `span` columns
    int covered = 0;
    for (int span = 1; span <= width; span *= 2) {
        if (span > 1) {
            const int half = span / 2;
            const int needed = count + width - covered;
            for (int x = 0; x < needed; x += lanes) {
                const VU32 sum =
                    hn::Add(hn::LoadU(d, of_span + x), hn::LoadU(d, of_span + x + half));
                hn::StoreU(sum, d, scratch + x);
            }
            of_span = scratch;
        }
        if ((width & span) != 0) {
            const std::uint32_t* from = of_span + covered;
            for (int x = 0; x < count; x += lanes) {
                const VU32 part = hn::LoadU(d, from + x);
                hn::StoreU(covered == 0 ? part : hn::Add(part, hn::LoadU(d, out + x)), d, out + x);
            }
            covered += span;
        }
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

// Up to this many pixels, N C - S sum(T) and N Q - S^2 fit into 32 bits.
constexpr double most_in_32_bits = 363.0;

void correlate_small(const std::int32_t* dots, const std::uint32_t* sums,
                     const std::uint32_t* squares, int count, const Normalisation& norm,
                     float* out) {
    const D32 d;
    const DU32 du;
    const DF df;
    const V32 n = hn::Set(d, static_cast<std::int32_t>(norm.count));
    const V32 of_template = hn::Set(d, static_cast<std::int32_t>(norm.template_sum));
    const VF template_factor = hn::Set(df, static_cast<float>(norm.template_squares));
    for (int x = 0; x < count; x += static_cast<int>(hn::Lanes(d))) {
        const V32 dot = hn::LoadU(d, dots + x);
        const VU32 sum = hn::LoadU(du, sums + x);
        const VU32 square = hn::LoadU(du, squares + x);
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
        hn::StoreU(score_of(numerator, variance, template_factor), df, out + x);
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

void correlate_large(const std::int32_t* dots, const std::uint32_t* sums,
                     const std::uint32_t* squares, int count, const Normalisation& norm,
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
    alignas(64) float numerators[hn::MaxLanes(DF())];
    alignas(64) float variances[hn::MaxLanes(DF())];
    for (int x = 0; x < count; x += lanes) {
        for (int h = 0; h < lanes; h += lanes_half) {
            const VD dot = hn::PromoteTo(dd, hn::LoadU(half, dots + x + h));
            const VD sum = double_of(hn::LoadU(unsigned_half, sums + x + h));
            const VD square = double_of(hn::LoadU(unsigned_half, squares + x + h));
            VD numerator;
            VD variance;
            if (norm.zero_mean) {
                numerator = hn::Sub(hn::Mul(n, dot), hn::Mul(sum, of_template));
                variance = hn::Sub(hn::Mul(n, square), hn::Mul(sum, sum));
            } else {
                numerator = hn::Add(dot, hn::Mul(hn::Set(dd, 128.0), sum));
                variance = square;
            }
            hn::StoreU(hn::DemoteTo(float_half, numerator), float_half, numerators + h);
            hn::StoreU(hn::DemoteTo(float_half, variance), float_half, variances + h);
        }
        hn::StoreU(score_of(hn::Load(df, numerators), hn::Load(df, variances), template_factor), df,
                   out + x);
    }
}

void correlate(const std::int32_t* dots, const std::uint32_t* sums, const std::uint32_t* squares,
               int count, const Normalisation& norm, float* out) {
    if (norm.count <= most_in_32_bits) {
        correlate_small(dots, sums, squares, count, norm, out);
    } else {
        correlate_large(dots, sums, squares, count, norm, out);
    }
}

#endif

}  // namespace HWY_NAMESPACE
}  // namespace kambara
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kambara {

HWY_EXPORT(roll_columns);
HWY_EXPORT(window_sums);
HWY_EXPORT(correlate);

void use_simd_finish(Kernels& kernels) {
    const std::size_t target = hwy::GetChosenTarget().GetIndex();
    kernels.roll_columns = HWY_DISPATCH_TABLE(roll_columns)[target];
    kernels.window_sums = HWY_DISPATCH_TABLE(window_sums)[target];
    kernels.correlate = HWY_DISPATCH_TABLE(correlate)[target];
}

}  // namespace kambara
#endif
