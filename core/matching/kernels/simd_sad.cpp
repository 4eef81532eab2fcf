// SPDX-License-Identifier: GPL-3.0-or-later
// sum(abs(I - T)) over a block of positions, in 16-bit sums that are emptied into 32-bit ones
// before they can overflow. A step takes one image row and four template columns.
#include <algorithm>

#include "core/matching/kernels/simd.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/matching/kernels/simd_sad.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace kambara {
namespace HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR

void sad(const Planes& image, const PackedTemplate& templ, const Block& block, std::uint32_t* out) {
    plain_kernels().sad(image, templ, block, out);
}

#else

namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET == HWY_AVX3_DL || HWY_TARGET == HWY_AVX3

constexpr int most_rows = 8;
constexpr int vectors = 2;       // of 16-bit sums an output row
constexpr int in_vector = 32;    // positions
constexpr int group = 4;         // template columns a step
constexpr int most_in_sum = 64;  // groups of 4 x 255 that 16 bits hold
using Bytes = __m512i;
using Sums = __m512i;

HWY_INLINE Sums none() {
    return _mm512_setzero_si512();
}
HWY_INLINE Bytes template_group(const std::uint8_t* at) {
    std::int32_t four;
    std::memcpy(&four, at, sizeof(four));
    return _mm512_set1_epi32(four);
}
// Lane l of 128 bits holds the 16 bytes from 8 l on, in the order that the differences want.
HWY_INLINE Bytes image_group(const std::uint8_t* pixels) {
    return _mm512_permutexvar_epi64(_mm512_setr_epi64(0, 1, 1, 2, 2, 3, 3, 4),
                                    _mm512_loadu_si512(pixels));
}
HWY_INLINE Sums add_differences(Sums sums, Bytes image, Bytes templ) {
    return _mm512_add_epi16(sums, _mm512_dbsad_epu8(templ, image, 0x94));
}
HWY_INLINE void empty(Sums sums, std::uint32_t* out) {
    for (int half = 0; half < 2; ++half) {
        const __m256i words =
            half == 0 ? _mm512_castsi512_si256(sums) : _mm512_extracti64x4_epi64(sums, 1);
        std::uint32_t* to = out + 16 * half;
        _mm512_storeu_si512(to,
                            _mm512_add_epi32(_mm512_loadu_si512(to), _mm512_cvtepu16_epi32(words)));
    }
}

#elif HWY_TARGET == HWY_AVX2

constexpr int most_rows = 6;
constexpr int vectors = 2;
constexpr int in_vector = 16;
constexpr int group = 4;
constexpr int most_in_sum = 64;
using Bytes = __m256i;
using Sums = __m256i;

HWY_INLINE Sums none() {
    return _mm256_setzero_si256();
}
HWY_INLINE Bytes template_group(const std::uint8_t* at) {
    std::int32_t four;
    std::memcpy(&four, at, sizeof(four));
    return _mm256_set1_epi32(four);
}
HWY_INLINE Bytes image_group(const std::uint8_t* pixels) {
    const __m128i low = _mm_loadu_si128(reinterpret_cast<const __m128i*>(pixels));
    const __m128i high = _mm_loadu_si128(reinterpret_cast<const __m128i*>(pixels + 8));
    return _mm256_inserti128_si256(_mm256_castsi128_si256(low), high, 1);
}
HWY_INLINE Sums add_differences(Sums sums, Bytes image, Bytes templ) {
    return _mm256_add_epi16(sums, _mm256_mpsadbw_epu8(image, templ, 0));
}
HWY_INLINE void empty(Sums sums, std::uint32_t* out) {
    for (int half = 0; half < 2; ++half) {
        const __m128i words =
            half == 0 ? _mm256_castsi256_si128(sums) : _mm256_extracti128_si256(sums, 1);
        auto* to = reinterpret_cast<__m256i*>(out + 8 * half);
        _mm256_storeu_si256(to,
                            _mm256_add_epi32(_mm256_loadu_si256(to), _mm256_cvtepu16_epi32(words)));
    }
}

#elif HWY_TARGET == HWY_SSE4

constexpr int most_rows = 6;
constexpr int vectors = 2;
constexpr int in_vector = 8;
constexpr int group = 4;
constexpr int most_in_sum = 64;
using Bytes = __m128i;
using Sums = __m128i;

HWY_INLINE Sums none() {
    return _mm_setzero_si128();
}
HWY_INLINE Bytes template_group(const std::uint8_t* at) {
    std::int32_t four;
    std::memcpy(&four, at, sizeof(four));
    return _mm_set1_epi32(four);
}
HWY_INLINE Bytes image_group(const std::uint8_t* pixels) {
    return _mm_loadu_si128(reinterpret_cast<const __m128i*>(pixels));
}
HWY_INLINE Sums add_differences(Sums sums, Bytes image, Bytes templ) {
    return _mm_add_epi16(sums, _mm_mpsadbw_epu8(image, templ, 0));
}
HWY_INLINE void empty(Sums sums, std::uint32_t* out) {
    for (int half = 0; half < 2; ++half) {
        const __m128i words = half == 0 ? sums : _mm_srli_si128(sums, 8);
        auto* to = reinterpret_cast<__m128i*>(out + 4 * half);
        _mm_storeu_si128(to, _mm_add_epi32(_mm_loadu_si128(to), _mm_cvtepu16_epi32(words)));
    }
}

#else

// Without an instruction for it: one template column a step.
constexpr int most_rows = 4;
constexpr int vectors = 2;
constexpr int in_vector = 8;
constexpr int group = 1;
constexpr int most_in_sum = 257;
using D16 = hn::FixedTag<std::uint16_t, 8>;
using Bytes = hn::Vec<D16>;
using Sums = hn::Vec<D16>;

HWY_INLINE Sums none() {
    return hn::Zero(D16());
}
HWY_INLINE Bytes template_group(const std::uint8_t* at) {
    return hn::Set(D16(), *at);
}
HWY_INLINE Bytes image_group(const std::uint8_t* pixels) {
    return hn::PromoteTo(D16(), hn::LoadU(hn::FixedTag<std::uint8_t, 8>(), pixels));
}
HWY_INLINE Sums add_differences(Sums sums, Bytes image, Bytes templ) {
    return hn::Add(sums, hn::Add(hn::SaturatedSub(image, templ), hn::SaturatedSub(templ, image)));
}
HWY_INLINE void empty(Sums sums, std::uint32_t* out) {
    std::uint16_t words[8];
    hn::StoreU(sums, D16(), words);
    for (int i = 0; i < 8; ++i) {
        out[i] += words[i];
    }
}

#endif

using RowSums = Sums[most_rows][vectors];

template <int FIRST, int LAST>
HWY_INLINE void add_row(const std::uint8_t* pixels, const PackedTemplate& templ,
                        std::size_t row_of_first, RowSums& sums) {
    const auto width = static_cast<std::size_t>(templ.padded_width);
    for (std::size_t i = 0; i < width; i += group) {
        Bytes image[vectors];
        for (int v = 0; v < vectors; ++v) {
            image[v] = image_group(pixels + i + static_cast<std::size_t>(v * in_vector));
        }
        for (int r = FIRST; r <= LAST; ++r) {
            const Bytes four = template_group(templ.bytes.data() + row_of_first -
                                              static_cast<std::size_t>(r - FIRST) * width + i);
            for (int v = 0; v < vectors; ++v) {
                sums[r][v] = add_differences(sums[r][v], image[v], four);
            }
        }
    }
}

template <int ROWS, int LAST>
HWY_INLINE void add_rising(int last, const std::uint8_t* pixels, const PackedTemplate& templ,
                           std::size_t row_of_first, RowSums& sums) {
    if constexpr (LAST < ROWS - 1) {
        if (last == LAST) {
            add_row<0, LAST>(pixels, templ, row_of_first, sums);
        } else {
            add_rising<ROWS, LAST + 1>(last, pixels, templ, row_of_first, sums);
        }
    }
}

template <int ROWS, int FIRST>
HWY_INLINE void add_falling(int first, const std::uint8_t* pixels, const PackedTemplate& templ,
                            std::size_t row_of_first, RowSums& sums) {
    if constexpr (FIRST < ROWS) {
        if (first == FIRST) {
            add_row<FIRST, ROWS - 1>(pixels, templ, row_of_first, sums);
        } else {
            add_falling<ROWS, FIRST + 1>(first, pixels, templ, row_of_first, sums);
        }
    }
}

template <int ROWS>
HWY_INLINE void empty_all(RowSums& sums, std::uint32_t* out, std::ptrdiff_t out_stride) {
    for (int r = 0; r < ROWS; ++r) {
        for (int v = 0; v < vectors; ++v) {
            empty(sums[r][v], out + r * out_stride + v * in_vector);
            sums[r][v] = none();
        }
    }
}

// ROWS output rows of one group of columns, added to `out`. ROWS is not above the template's
// height.
template <int ROWS>
HWY_NOINLINE void sad_rows(const Planes& image, const PackedTemplate& templ,
                           const std::uint8_t* first_pixel, std::uint32_t* out,
                           std::ptrdiff_t out_stride) {
    RowSums sums;
    for (int r = 0; r < ROWS; ++r) {
        for (int v = 0; v < vectors; ++v) {
            sums[r][v] = none();
        }
    }
    const int steps_a_row = templ.padded_width / group;
    int in_sum = 0;
    for (int plane = 0; plane < templ.planes; ++plane) {
        const std::uint8_t* pixels = first_pixel + plane * image.plane_stride;
        for (int j = 0; j < templ.height + ROWS - 1; ++j, pixels += image.stride) {
            if (in_sum + steps_a_row > most_in_sum) {
                empty_all<ROWS>(sums, out, out_stride);
                in_sum = 0;
            }
            in_sum += steps_a_row;
            if (j < ROWS - 1) {
                add_rising<ROWS, 0>(j, pixels, templ, templ.offset(plane, j), sums);
            } else if (j < templ.height) {
                add_row<0, ROWS - 1>(pixels, templ, templ.offset(plane, j), sums);
            } else {
                add_falling<ROWS, 1>(j - templ.height + 1, pixels, templ,
                                     templ.offset(plane, templ.height - 1), sums);
            }
        }
    }
    empty_all<ROWS>(sums, out, out_stride);
}

void sad(const Planes& image, const PackedTemplate& templ, const Block& block, std::uint32_t* out) {
    constexpr int columns = vectors * in_vector;
    for (int y = 0; y < block.rows;) {
        const int rows = std::min({most_rows, block.rows - y, templ.height});
        for (int r = 0; r < rows; ++r) {
            std::fill_n(out + (y + r) * block.stride, whole_groups(block.columns), 0U);
        }
        for (int x = 0; x < block.columns; x += columns) {
            const std::uint8_t* pixels = image.pixels + y * image.stride + x;
            std::uint32_t* to = out + y * block.stride + x;
            switch (rows) {
                case 8:
                    sad_rows<std::min(8, most_rows)>(image, templ, pixels, to, block.stride);
                    break;
                case 7:
                    sad_rows<std::min(7, most_rows)>(image, templ, pixels, to, block.stride);
                    break;
                case 6:
                    sad_rows<std::min(6, most_rows)>(image, templ, pixels, to, block.stride);
                    break;
                case 5:
                    sad_rows<std::min(5, most_rows)>(image, templ, pixels, to, block.stride);
                    break;
                case 4:
                    sad_rows<4>(image, templ, pixels, to, block.stride);
                    break;
                case 3:
                    sad_rows<3>(image, templ, pixels, to, block.stride);
                    break;
                case 2:
                    sad_rows<2>(image, templ, pixels, to, block.stride);
                    break;
                default:
                    sad_rows<1>(image, templ, pixels, to, block.stride);
                    break;
            }
        }
        y += rows;
    }
}

#endif

}  // namespace HWY_NAMESPACE
}  // namespace kambara
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kambara {

HWY_EXPORT(sad);

void use_simd_sad(Kernels& kernels) {
    kernels.sad = HWY_DISPATCH_TABLE(sad)[hwy::GetChosenTarget().GetIndex()];
}

}  // namespace kambara
#endif
