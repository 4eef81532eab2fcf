// SPDX-License-Identifier: GPL-3.0-or-later
// What lies before, between and after the Fourier transforms of spectral_dot.h.
#include <cmath>

#include "core/matching/kernels/simd.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/matching/kernels/simd_spectrum.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace kambara {
namespace HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR || !HWY_HAVE_FLOAT64

void centred_values(const std::uint8_t* pixels, int count, double* out) {
    plain_kernels().centred_values(pixels, count, out);
}
void multiply_spectra(const double* a, const double* b, const SpectrumPart& part, bool add,
                      double* out) {
    plain_kernels().multiply_spectra(a, b, part, add, out);
}
void whole_numbers(const double* values, int count, double scale, double offset,
                   std::int32_t* out) {
    plain_kernels().whole_numbers(values, count, scale, offset, out);
}

#else

namespace hn = hwy::HWY_NAMESPACE;
using DD = hn::ScalableTag<double>;
using D32 = hn::Rebind<std::int32_t, DD>;
using DBytes = hn::Rebind<std::uint8_t, DD>;
using VD = hn::Vec<DD>;

void centred_values(const std::uint8_t* pixels, int count, double* out) {
    const DD dd;
    const D32 d;
    const int lanes = static_cast<int>(hn::Lanes(dd));
    int x = 0;
    for (; x + lanes <= count; x += lanes) {
        const auto values = hn::PromoteTo(d, hn::LoadU(DBytes(), pixels + x));
        hn::StoreU(hn::PromoteTo(dd, hn::Sub(values, hn::Set(d, 128))), dd, out + x);
    }
    for (; x < count; ++x) {
        out[x] = pixels[x] - 128;
    }
}

template <bool ADD>
HWY_INLINE void multiply_all(const double* a, const double* b, const SpectrumPart& part,
                             double* out) {
    const DD dd;
    const std::ptrdiff_t stride = 2 * part.stride;
    for (int y = 0; y < part.rows; ++y, a += stride, b += stride, out += stride) {
        for (int i = 0; i < 2 * part.columns; i += static_cast<int>(hn::Lanes(dd))) {
            const VD left = hn::LoadU(dd, a + i);
            const VD right = hn::LoadU(dd, b + i);
            const VD by_real = hn::Mul(left, hn::InterleaveLower(dd, right, right));
            const VD by_imaginary =
                hn::Mul(hn::Shuffle01(left), hn::InterleaveUpper(dd, right, right));
            VD product =
                hn::OddEven(hn::Add(by_real, by_imaginary), hn::Sub(by_real, by_imaginary));
            if constexpr (ADD) {
                product = hn::Add(product, hn::LoadU(dd, out + i));
            }
            hn::StoreU(product, dd, out + i);
        }
    }
}

void multiply_spectra(const double* a, const double* b, const SpectrumPart& part, bool add,
                      double* out) {
    if (add) {
        multiply_all<true>(a, b, part, out);
    } else {
        multiply_all<false>(a, b, part, out);
    }
}

void whole_numbers(const double* values, int count, double scale, double offset,
                   std::int32_t* out) {
    const DD dd;
    const D32 d;
    const int lanes = static_cast<int>(hn::Lanes(dd));
    const VD by = hn::Set(dd, scale);
    const VD plus = hn::Set(dd, offset);
    int x = 0;
    for (; x + lanes <= count; x += lanes) {
        const VD value = hn::MulAdd(hn::LoadU(dd, values + x), by, plus);
        hn::StoreU(hn::DemoteTo(d, hn::Round(value)), d, out + x);
    }
    for (; x < count; ++x) {
        out[x] = static_cast<std::int32_t>(std::nearbyint(values[x] * scale + offset));
    }
}

#endif

}  // namespace HWY_NAMESPACE
}  // namespace kambara
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kambara {

HWY_EXPORT(centred_values);
HWY_EXPORT(multiply_spectra);
HWY_EXPORT(whole_numbers);

void use_simd_spectrum(Kernels& kernels) {
    const std::size_t target = hwy::GetChosenTarget().GetIndex();
    kernels.centred_values = HWY_DISPATCH_TABLE(centred_values)[target];
    kernels.multiply_spectra = HWY_DISPATCH_TABLE(multiply_spectra)[target];
    kernels.whole_numbers = HWY_DISPATCH_TABLE(whole_numbers)[target];
}

}  // namespace kambara
#endif
