// SPDX-License-Identifier: GPL-3.0-or-later
// sum(abs(I - T)) over a block of positions, in 16-bit sums that are emptied into 32-bit ones
// before they can overflow. A step takes one image row and one group of
// template columns; it goes down the template, then to the next group.
#include <algorithm>
#include <array>

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
bool sad_counts_padding() {
    return plain_kernels().sad_counts_padding;
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

// The plain sum of eight differences is one quick instruction here, unlike the one that shifts.
constexpr int most_rows = 6;
constexpr int vectors = 2;
constexpr int in_vector = 4;
constexpr int group = 8;
constexpr int most_in_sum = -1;  // the sums have 64 bits and are never full
using Bytes = __m256i;
using Sums = __m256i;

HWY_INLINE Sums none() {
    return _mm256_setzero_si256();
}
HWY_INLINE Bytes template_group(const std::uint8_t* at) {
    std::int64_t eight;
    std::memcpy(&eight, at, sizeof(eight));
    return _mm256_set1_epi64x(eight);
}
// Each 64 bits hold the bytes from one position on, as many of eight as the row has left: the rest
// is 0, as the template's padding is, and makes no difference.
struct alignas(32) Order {
    std::array<std::uint8_t, 32> of_bytes;
};
constexpr Order order_of(int columns) {
    Order order{};
    for (int i = 0; i < 32; ++i) {
        order.of_bytes[static_cast<std::size_t>(i)] =
            i % 8 < columns ? static_cast<std::uint8_t>(i / 8 + i % 8) : std::uint8_t{0x80};
    }
    return order;
}
constexpr Order orders[9]{order_of(0), order_of(1), order_of(2), order_of(3), order_of(4),
                          order_of(5), order_of(6), order_of(7), order_of(8)};
HWY_INLINE Bytes image_group(const std::uint8_t* pixels, const Order& order) {
    const __m128i sixteen = _mm_loadu_si128(reinterpret_cast<const __m128i*>(pixels));
    Bytes bytes = _mm256_broadcastsi128_si256(sixteen);
    // Written out, so that the order stays in memory: the registers are all needed for the sums.
    asm("vpshufb %1, %0, %0" : "+x"(bytes) : "m"(order));
    return bytes;
}
HWY_INLINE const Order& order_for(std::size_t columns) {
    return orders[std::min<std::size_t>(columns, 8)];
}
constexpr bool counts_padding = false;
// At the end of a row, where there are no eight bytes more.
HWY_INLINE Bytes template_half(const std::uint8_t* at) {
    std::uint32_t four;
    std::memcpy(&four, at, sizeof(four));
    return _mm256_set1_epi64x(four);
}
HWY_INLINE Sums add_differences(Sums sums, Bytes image, Bytes templ) {
    return _mm256_add_epi64(sums, _mm256_sad_epu8(image, templ));
}
HWY_INLINE void empty(Sums sums, std::uint32_t* out) {
    const __m256i low =
        _mm256_permutevar8x32_epi32(sums, _mm256_setr_epi32(0, 2, 4, 6, 0, 0, 0, 0));
    auto* to = reinterpret_cast<__m128i*>(out);
    _mm_storeu_si128(to, _mm_add_epi32(_mm_loadu_si128(to), _mm256_castsi256_si128(low)));
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

#if HWY_TARGET != HWY_AVX2
constexpr bool counts_padding = true;
struct Order {};
constexpr Order any_order{};
HWY_INLINE const Order& order_for(std::size_t) {
    return any_order;
}
HWY_INLINE Bytes image_group(const std::uint8_t* pixels, const Order&) {
    return image_group(pixels);
}
// The padded rows hold whole groups only.
HWY_INLINE Bytes template_half(const std::uint8_t* at) {
    return template_group(at);
}
#endif

using RowSums = Sums[most_rows][vectors];

// Differences of one image row's group of columns, or half a group.
template <bool HALF, int FIRST, int LAST>
HWY_INLINE void add_group(const std::uint8_t* pixels, const std::uint8_t* of_first,
                          std::size_t width, const Order& order, RowSums& sums) {
    Bytes image[vectors];
    for (int v = 0; v < vectors; ++v) {
        image[v] = image_group(pixels + v * in_vector, order);
    }
    for (int r = FIRST; r <= LAST; ++r) {
        const std::uint8_t* from = of_first - static_cast<std::size_t>(r - FIRST) * width;
        const Bytes few = HALF ? template_half(from) : template_group(from);
        for (int v = 0; v < vectors; ++v) {
            sums[r][v] = add_differences(sums[r][v], image[v], few);
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

// Where a group of columns is at.
struct Descent {
    const std::uint8_t* pixels;  // of the image row
    std::ptrdiff_t image_stride;
    const std::uint8_t* of_templ;  // in the template row that the first output row sees
    std::size_t width;             // from template row to template row
    const Order* order;
    std::uint32_t* out;
    std::ptrdiff_t out_stride;
    int in_sum;  // groups that the sums hold already
};

template <bool HALF, int ROWS, int FIRST, int LAST>
HWY_INLINE void add_next(Descent& at, const std::uint8_t* of_first, RowSums& sums) {
    if (at.in_sum == most_in_sum) {
        empty_all<ROWS>(sums, at.out, at.out_stride);
        at.in_sum = 0;
    }
    ++at.in_sum;
    add_group<HALF, FIRST, LAST>(at.pixels, of_first, at.width, *at.order, sums);
    at.pixels += at.image_stride;
}

// The image rows under the first output rows only.
template <bool HALF, int ROWS, int LAST>
HWY_INLINE void add_rising(Descent& at, RowSums& sums) {
    if constexpr (LAST < ROWS - 1) {
        add_next<HALF, ROWS, 0, LAST>(at, at.of_templ, sums);
        at.of_templ += at.width;
        add_rising<HALF, ROWS, LAST + 1>(at, sums);
    }
}

// The image rows under the last output rows only.
template <bool HALF, int ROWS, int FIRST>
HWY_INLINE void add_falling(Descent& at, const std::uint8_t* last_row, RowSums& sums) {
    if constexpr (FIRST < ROWS) {
        add_next<HALF, ROWS, FIRST, ROWS - 1>(at, last_row, sums);
        add_falling<HALF, ROWS, FIRST + 1>(at, last_row, sums);
    }
}

// A group of columns down the template.
template <bool HALF, int ROWS>
HWY_INLINE void add_columns(Descent& at, int height, RowSums& sums) {
    add_rising<HALF, ROWS, 0>(at, sums);
    for (int j = ROWS - 1; j < height; ++j) {
        add_next<HALF, ROWS, 0, ROWS - 1>(at, at.of_templ, sums);
        at.of_templ += at.width;
    }
    add_falling<HALF, ROWS, 1>(at, at.of_templ - at.width, sums);
}

// ROWS output rows of one group of positions, added to `out`. ROWS is not above the template's
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
    const auto width = static_cast<std::size_t>(templ.padded_width);
    const auto used = static_cast<std::size_t>(templ.width);
    int in_sum = 0;
    for (int plane = 0; plane < templ.planes; ++plane) {
        for (std::size_t i = 0; i < width; i += group) {
            Descent at{first_pixel + plane * image.plane_stride + i,
                       image.stride,
                       templ.bytes.data() + templ.offset(plane, 0) + i,
                       width,
                       &order_for(used - i),
                       out,
                       out_stride,
                       in_sum};
            if (i + group <= width) {
                add_columns<false, ROWS>(at, templ.height, sums);
            } else {
                add_columns<true, ROWS>(at, templ.height, sums);
            }
            in_sum = at.in_sum;
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

bool sad_counts_padding() {
    return counts_padding;
}

#endif

}  // namespace HWY_NAMESPACE
}  // namespace kambara
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kambara {

HWY_EXPORT(sad);
HWY_EXPORT(sad_counts_padding);

void use_simd_sad(Kernels& kernels) {
    const std::size_t target = hwy::GetChosenTarget().GetIndex();
    kernels.sad = HWY_DISPATCH_TABLE(sad)[target];
    kernels.sad_counts_padding = HWY_DISPATCH_TABLE(sad_counts_padding)[target]();
}

}  // namespace kambara
#endif
