// SPDX-License-Identifier: GPL-3.0-or-later
// Number of differing bits over a block of positions, in 8-bit sums that are emptied into 32-bit
// ones before they can overflow.
#include <algorithm>

#include "core/matching/kernels/simd.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/matching/kernels/simd_hamming.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace kambara {
namespace HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR

void hamming(const Planes& image, const PackedTemplate& templ, const Block& block,
             std::uint32_t* out) {
    plain_kernels().hamming(image, templ, block, out);
}

#else

namespace hn = hwy::HWY_NAMESPACE;
using D8 = hn::CappedTag<std::uint8_t, kernel_columns>;
using V8 = hn::Vec<D8>;

constexpr int most_in_sum = 31;  // bytes of 8 bits that 8 bits hold

HWY_INLINE void empty(V8 sums, std::uint32_t* out) {
    const D8 d8;
    alignas(64) std::uint8_t bytes[kernel_columns];
    hn::Store(sums, d8, bytes);
    const hn::ScalableTag<std::uint32_t> d32;
    const hn::Rebind<std::uint8_t, decltype(d32)> quarter;
    for (std::size_t i = 0; i < hn::Lanes(d8); i += hn::Lanes(d32)) {
        const auto wide = hn::PromoteTo(d32, hn::LoadU(quarter, bytes + i));
        hn::StoreU(hn::Add(hn::LoadU(d32, out + i), wide), d32, out + i);
    }
}

// One output row of VECTORS vectors of columns, added to `out`.
template <int VECTORS>
HWY_NOINLINE void hamming_row(const Planes& image, const PackedTemplate& templ,
                              const std::uint8_t* first_pixel, std::uint32_t* out) {
    const D8 d;
    const std::size_t lanes = hn::Lanes(d);
    V8 sums[VECTORS];
    for (int v = 0; v < VECTORS; ++v) {
        sums[v] = hn::Zero(d);
    }
    int in_sum = 0;
    for (int plane = 0; plane < templ.planes; ++plane) {
        for (int j = 0; j < templ.height; ++j) {
            const std::uint8_t* pixels =
                first_pixel + plane * image.plane_stride + j * image.stride;
            const std::uint8_t* bytes = templ.bytes.data() + templ.offset(plane, j);
            const std::uint8_t* masks = templ.masks.data() + templ.offset(plane, j);
            for (int i = 0; i < templ.padded_width; ++i, pixels += templ.column_step) {
                const V8 byte = hn::Set(d, bytes[i]);
                const V8 mask = hn::Set(d, masks[i]);
                for (int v = 0; v < VECTORS; ++v) {
                    const V8 seen = hn::LoadU(d, pixels + static_cast<std::size_t>(v) * lanes);
                    sums[v] =
                        hn::Add(sums[v], hn::PopulationCount(hn::And(hn::Xor(seen, byte), mask)));
                }
                if (++in_sum == most_in_sum) {
                    in_sum = 0;
                    for (int v = 0; v < VECTORS; ++v) {
                        empty(sums[v], out + static_cast<std::size_t>(v) * lanes);
                        sums[v] = hn::Zero(d);
                    }
                }
            }
        }
    }
    for (int v = 0; v < VECTORS; ++v) {
        empty(sums[v], out + static_cast<std::size_t>(v) * lanes);
    }
}

void hamming(const Planes& image, const PackedTemplate& templ, const Block& block,
             std::uint32_t* out) {
    const int lanes = static_cast<int>(hn::Lanes(D8()));
    for (int y = 0; y < block.rows; ++y) {
        std::uint32_t* row = out + y * block.stride;
        std::fill_n(row, whole_groups(block.columns), 0U);
        const std::uint8_t* pixels = image.pixels + y * image.stride;
        for (int x = 0; x < block.columns;) {
            switch (std::min(4, (block.columns - x + lanes - 1) / lanes)) {
                case 4:
                    hamming_row<4>(image, templ, pixels + x, row + x);
                    x += 4 * lanes;
                    break;
                case 3:
                    hamming_row<3>(image, templ, pixels + x, row + x);
                    x += 3 * lanes;
                    break;
                case 2:
                    hamming_row<2>(image, templ, pixels + x, row + x);
                    x += 2 * lanes;
                    break;
                default:
                    hamming_row<1>(image, templ, pixels + x, row + x);
                    x += lanes;
                    break;
            }
        }
    }
}

#endif

}  // namespace HWY_NAMESPACE
}  // namespace kambara
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kambara {

HWY_EXPORT(hamming);

void use_simd_hamming(Kernels& kernels) {
    kernels.hamming = HWY_DISPATCH_TABLE(hamming)[hwy::GetChosenTarget().GetIndex()];
}

}  // namespace kambara
#endif
