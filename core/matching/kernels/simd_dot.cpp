// SPDX-License-Identifier: GPL-3.0-or-later
// sum(I (T - 128)) over a block of positions. A step takes one image row and one group of template
// columns (four with the 8-bit dot product, two without); the pixels loaded serve all output rows
// that this image row lies under.
#include <algorithm>

#include "core/matching/kernels/simd.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/matching/kernels/simd_dot.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace kambara {
namespace HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR

void dot(const Planes& image, const PackedTemplate& templ, const Block& block, std::int32_t* out) {
    plain_kernels().dot(image, templ, block, out);
}

double multiply_add_at_best(int rounds) {
    return plain_kernels().multiply_add_at_best(rounds);
}

#else

namespace hn = hwy::HWY_NAMESPACE;
using D32 = hn::ScalableTag<std::int32_t>;
using V32 = hn::Vec<D32>;

constexpr int most_rows = 6;

#if HWY_TARGET == HWY_AVX3_DL

// Four columns a group: lane i of part s is the position s + 4 i.
constexpr int group = 4;
constexpr int parts = 4;

HWY_INLINE V32 template_group(const PackedTemplate& templ, std::size_t at) {
    std::int32_t four;
    std::memcpy(&four, templ.centred.data() + at, sizeof(four));
    return V32{_mm512_set1_epi32(four)};
}
HWY_INLINE V32 image_group(const std::uint8_t* pixels) {
    return V32{_mm512_loadu_si512(pixels)};
}
HWY_INLINE V32 add_products(V32 sum, V32 image, V32 templ) {
    // Highway's target has the instruction but does not tell the compiler so; written out, gcc also
    // leaves out the copies it makes around the intrinsic.
    asm("vpdpbusd %2, %1, %0" : "+v"(sum.raw) : "v"(image.raw), "v"(templ.raw));
    return sum;
}
HWY_INLINE void store_parts(const V32* sums, std::int32_t* out) {
    hn::StoreInterleaved4(sums[0], sums[1], sums[2], sums[3], D32(), out);
}

#else

// Two columns a group, pixels widened to 16 bits: lane i of part s is the position s + 2 i.
constexpr int group = 2;
constexpr int parts = 2;
using D16 = hn::Repartition<std::int16_t, D32>;
using D8 = hn::Rebind<std::uint8_t, D16>;

HWY_INLINE V32 template_group(const PackedTemplate& templ, std::size_t at) {
    std::int32_t two;
    std::memcpy(&two, templ.centred16.data() + at, sizeof(two));
    return hn::Set(D32(), two);
}
HWY_INLINE V32 image_group(const std::uint8_t* pixels) {
    return hn::BitCast(D32(), hn::PromoteTo(D16(), hn::LoadU(D8(), pixels)));
}
HWY_INLINE V32 add_products(V32 sum, V32 image, V32 templ) {
#if HWY_ARCH_X86
    V32 unused = hn::Zero(D32());
    return hn::ReorderWidenMulAccumulate(D32(), hn::BitCast(D16(), image),
                                         hn::BitCast(D16(), templ), sum, unused);
#else
    const V32 even = hn::Mul(hn::ShiftRight<16>(hn::ShiftLeft<16>(image)),
                             hn::ShiftRight<16>(hn::ShiftLeft<16>(templ)));
    const V32 odd = hn::Mul(hn::ShiftRight<16>(image), hn::ShiftRight<16>(templ));
    return hn::Add(sum, hn::Add(even, odd));
#endif
}
HWY_INLINE void store_parts(const V32* sums, std::int32_t* out) {
    hn::StoreInterleaved2(sums[0], sums[1], D32(), out);
}

#endif

// Products of one image row with the template rows of the output rows FIRST to LAST.
template <int FIRST, int LAST>
HWY_INLINE void add_row(const std::uint8_t* pixels, const PackedTemplate& templ,
                        std::size_t row_of_first, V32 (&sums)[most_rows][parts]) {
    const auto width = static_cast<std::size_t>(templ.padded_width);
    const auto used = static_cast<std::size_t>(templ.width);
    for (std::size_t i = 0; i < used; i += group) {
        // The parts of the image stay in registers and the factors pass by: sums, parts and one
        // factor are as many as the smallest register file has.
        V32 image[parts];
        for (int s = 0; s < parts; ++s) {
            image[s] = image_group(pixels + i + static_cast<std::size_t>(s));
        }
        for (int r = FIRST; r <= LAST; ++r) {
            const V32 factor = template_group(
                templ, row_of_first - static_cast<std::size_t>(r - FIRST) * width + i);
            for (int s = 0; s < parts; ++s) {
                sums[r][s] = add_products(sums[r][s], image[s], factor);
            }
        }
    }
}

// The image rows under the first output rows only: 0 to `last`.
template <int ROWS, int LAST>
HWY_INLINE void add_rising(int last, const std::uint8_t* pixels, const PackedTemplate& templ,
                           std::size_t row_of_first, V32 (&sums)[most_rows][parts]) {
    if constexpr (LAST < ROWS - 1) {
        if (last == LAST) {
            add_row<0, LAST>(pixels, templ, row_of_first, sums);
        } else {
            add_rising<ROWS, LAST + 1>(last, pixels, templ, row_of_first, sums);
        }
    }
}

// The image rows under the last output rows only: `first` to ROWS - 1.
template <int ROWS, int FIRST>
HWY_INLINE void add_falling(int first, const std::uint8_t* pixels, const PackedTemplate& templ,
                            std::size_t row_of_first, V32 (&sums)[most_rows][parts]) {
    if constexpr (FIRST < ROWS) {
        if (first == FIRST) {
            add_row<FIRST, ROWS - 1>(pixels, templ, row_of_first, sums);
        } else {
            add_falling<ROWS, FIRST + 1>(first, pixels, templ, row_of_first, sums);
        }
    }
}

// ROWS output rows of one group of columns. ROWS is not larger than the template's height.
template <int ROWS>
HWY_NOINLINE void dot_rows(const Planes& image, const PackedTemplate& templ,
                           const std::uint8_t* first_pixel, std::int32_t* out,
                           std::ptrdiff_t out_stride) {
    V32 sums[most_rows][parts];
    for (int r = 0; r < ROWS; ++r) {
        for (int s = 0; s < parts; ++s) {
            sums[r][s] = hn::Zero(D32());
        }
    }
    for (int plane = 0; plane < templ.planes; ++plane) {
        const std::uint8_t* pixels = first_pixel + plane * image.plane_stride;
        int j = 0;
        for (; j < ROWS - 1; ++j, pixels += image.stride) {
            add_rising<ROWS, 0>(j, pixels, templ, templ.offset(plane, j), sums);
        }
        for (; j < templ.height; ++j, pixels += image.stride) {
            add_row<0, ROWS - 1>(pixels, templ, templ.offset(plane, j), sums);
        }
        for (; j < templ.height + ROWS - 1; ++j, pixels += image.stride) {
            add_falling<ROWS, 1>(j - templ.height + 1, pixels, templ,
                                 templ.offset(plane, templ.height - 1), sums);
        }
    }
    for (int r = 0; r < ROWS; ++r) {
        store_parts(sums[r], out + r * out_stride);
    }
}

void dot(const Planes& image, const PackedTemplate& templ, const Block& block, std::int32_t* out) {
    const int columns = parts * static_cast<int>(hn::Lanes(D32()));
    for (int y = 0; y < block.rows;) {
        const int rows = std::min({most_rows, block.rows - y, templ.height});
        for (int x = 0; x < block.columns; x += columns) {
            const std::uint8_t* pixels = image.pixels + y * image.stride + x;
            std::int32_t* to = out + y * block.stride + x;
            switch (rows) {
                case 6:
                    dot_rows<6>(image, templ, pixels, to, block.stride);
                    break;
                case 5:
                    dot_rows<5>(image, templ, pixels, to, block.stride);
                    break;
                case 4:
                    dot_rows<4>(image, templ, pixels, to, block.stride);
                    break;
                case 3:
                    dot_rows<3>(image, templ, pixels, to, block.stride);
                    break;
                case 2:
                    dot_rows<2>(image, templ, pixels, to, block.stride);
                    break;
                default:
                    dot_rows<1>(image, templ, pixels, to, block.stride);
                    break;
            }
        }
        y += rows;
    }
}

double multiply_add_at_best(int rounds) {
    constexpr int chains = 10;
    const V32 templ = hn::Set(D32(), 0x04030201);
    const auto start = [](int seed) HWY_ATTR { return hn::Set(D32(), 0x01020304 + seed); };
    V32 a = start(0), b = start(1), c = start(2), d = start(3), e = start(4);
    V32 f = start(5), g = start(6), h = start(7), j = start(8), k = start(9);
    // Products of the sums themselves, or they would be made once for all rounds.
    const auto next = [&](V32& sum) HWY_ATTR { sum = add_products(sum, sum, templ); };
    for (int i = 0; i < rounds; ++i) {
        next(a), next(b), next(c), next(d), next(e);
        next(f), next(g), next(h), next(j), next(k);
    }
    const V32 total = hn::Add(hn::Add(hn::Add(a, b), hn::Add(c, d)),
                              hn::Add(hn::Add(hn::Add(e, f), hn::Add(g, h)), hn::Add(j, k)));
    volatile std::int32_t used = hn::GetLane(total);
    static_cast<void>(used);
    return static_cast<double>(rounds) * chains * group * static_cast<double>(hn::Lanes(D32()));
}

#endif

}  // namespace HWY_NAMESPACE
}  // namespace kambara
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kambara {

HWY_EXPORT(dot);
HWY_EXPORT(multiply_add_at_best);

void use_simd_dot(Kernels& kernels) {
    const std::size_t target = hwy::GetChosenTarget().GetIndex();
    kernels.dot = HWY_DISPATCH_TABLE(dot)[target];
    kernels.multiply_add_at_best = HWY_DISPATCH_TABLE(multiply_add_at_best)[target];
}

}  // namespace kambara
#endif
