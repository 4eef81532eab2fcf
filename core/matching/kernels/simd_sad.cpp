// SPDX-License-Identifier: GPL-3.0-or-later
// sum(abs(I - T)) over a block of positions, in 16-bit sums that are emptied into 32-bit ones
// before they can overflow. A step takes one image row and one group of
// template columns; it goes down the template, then to the next group.
#include <algorithm>
#include <array>
#include <vector>

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
using FourBytes = std::uint8_t[4];
// Written out, since a compiler that keeps what the next step could load again passes it on through
// other registers, which takes longer.
HWY_INLINE Bytes template_group(const std::uint8_t* at) {
    Bytes four;
    asm("vpbroadcastd %1, %0" : "=v"(four) : "m"(*reinterpret_cast<const FourBytes*>(at)));
    return four;
}
// Each 128 bits give the sums of their first eight positions: a second vector begins eight later.
constexpr int second = 8;
HWY_INLINE Bytes image_group(const std::uint8_t* pixels) {
    return _mm512_loadu_si512(pixels);
}
HWY_INLINE Sums add_differences(Sums sums, Bytes image, Bytes templ) {
    return _mm512_add_epi16(sums, _mm512_dbsad_epu8(templ, image, 0x94));
}

#elif HWY_TARGET == HWY_AVX2

// The plain sum of eight differences is one quick instruction here, unlike the one that shifts.
constexpr int most_rows = 6;
constexpr int vectors = 2;
constexpr int in_vector = 4;
constexpr int group = 8;
constexpr int most_in_sum = 0;  // the sums have 64 bits and are never full
using Bytes = __m256i;
using Sums = __m256i;
using EightBytes = std::uint8_t[8];
using SixteenBytes = std::uint8_t[16];

HWY_INLINE Sums none() {
    return _mm256_setzero_si256();
}
// Written out, here and below, and kept in order: the sums fill the registers, and a compiler that
// loads early or keeps what it could load again moves sums to memory and back.
HWY_INLINE Bytes template_group(const std::uint8_t* at) {
    Bytes eight;
    asm volatile("vpbroadcastq %1, %0"
                 : "=x"(eight)
                 : "m"(*reinterpret_cast<const EightBytes*>(at)));
    return eight;
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
    Bytes bytes;
    asm volatile(
        "vbroadcasti128 %1, %0\n\t"
        "vpshufb %2, %0, %0"
        : "=&x"(bytes)
        : "m"(*reinterpret_cast<const SixteenBytes*>(pixels)), "m"(order));
    return bytes;
}
HWY_INLINE const Order& order_for(int columns) {
    return orders[std::min(columns, 8)];
}
constexpr bool counts_padding = false;
HWY_INLINE Sums add_differences(Sums sums, Bytes image, Bytes templ) {
    Sums differences;
    asm volatile(
        "vpsadbw %3, %2, %1\n\t"
        "vpaddq %1, %0, %0"
        : "+x"(sums), "=&x"(differences)
        : "x"(image), "x"(templ));
    return sums;
}
using Stored = std::uint64_t;
constexpr int second = in_vector;

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

#endif

#if HWY_TARGET != HWY_AVX2
constexpr bool counts_padding = true;
#if HWY_TARGET != HWY_AVX3_DL && HWY_TARGET != HWY_AVX3
constexpr int second = in_vector;
#endif
using Stored = std::uint16_t;
struct Order {};
constexpr Order any_order{};
HWY_INLINE const Order& order_for(int) {
    return any_order;
}
HWY_INLINE Bytes image_group(const std::uint8_t* pixels, const Order&) {
    return image_group(pixels);
}
#endif

static_assert(vectors == 2);
using RowSums = Sums[most_rows][vectors];

// The template by groups of columns, each from its first row to its last: down a group, every
// output row's bytes are a fixed way from the first's. Where a last group is wider than the
// template's row, it ends in zeros.
struct Groups {
    std::vector<std::uint8_t> bytes;
    std::ptrdiff_t in_row = 0;

    void take(const PackedTemplate& templ) {
        in_row = (templ.padded_width + group - 1) / group;
        bytes.assign(static_cast<std::size_t>(in_row * group * templ.height * templ.planes), 0);
        std::uint8_t* to = bytes.data();
        for (int plane = 0; plane < templ.planes; ++plane) {
            for (int i = 0; i < templ.padded_width; i += group) {
                const std::uint8_t* from = templ.bytes.data() + templ.offset(plane, 0) + i;
                const auto count =
                    static_cast<std::size_t>(std::min(group, templ.padded_width - i));
                for (int j = 0; j < templ.height; ++j, from += templ.padded_width, to += group) {
                    if (count == group) {
                        std::memcpy(to, from, group);  // of a size known beforehand: no call
                    } else {
                        std::memcpy(to, from, count);
                    }
                }
            }
        }
    }
};

// Loops over the output rows are written as recursions: their sums then never leave the registers.
template <int ROWS, int R = 0>
HWY_INLINE void clear(RowSums& sums) {
    if constexpr (R < ROWS) {
        sums[R][0] = none();
        sums[R][1] = none();
        clear<ROWS, R + 1>(sums);
    }
}

template <int ROWS, int I = 0>
HWY_INLINE void store(const RowSums& sums, Stored* out) {
    if constexpr (I < ROWS * vectors) {
        std::memcpy(out + I * in_vector, &sums[I / vectors][I % vectors], sizeof(Sums));
        store<ROWS, I + 1>(sums, out);
    }
}

// Differences of one image row's group of columns, for the output rows R to LAST.
template <int R, int LAST>
HWY_INLINE void add_to_rows(Bytes left, Bytes right, const std::uint8_t* of_templ, RowSums& sums) {
    if constexpr (R <= LAST) {
        const Bytes few = template_group(of_templ);
        sums[R][0] = add_differences(sums[R][0], left, few);
        sums[R][1] = add_differences(sums[R][1], right, few);
        add_to_rows<R + 1, LAST>(left, right, of_templ - group, sums);
    }
}

// Where a group of columns is at.
struct Descent {
    const std::uint8_t* pixels;  // of the image row
    std::ptrdiff_t image_stride;
    const std::uint8_t* of_templ;  // in the template row that the first output row sees
    const Order* order;
    int columns;  // of positions that there are
    std::uint32_t* out;
    std::ptrdiff_t out_stride;
    int in_sum;    // groups that the sums hold already
    bool emptied;  // at least once
};

#if HWY_TARGET == HWY_AVX3_DL || HWY_TARGET == HWY_AVX3

HWY_INLINE void widen_row(const Stored* sums, int columns, bool add, std::uint32_t* to) {
    const __m512i first = _mm512_load_si512(sums);
    const __m512i other = _mm512_load_si512(sums + in_vector);
    for (int half = 0; half < 2; ++half, columns -= in_vector, to += in_vector) {
        // The two vectors' eighths in turn.
        const __m512i order = half == 0 ? _mm512_setr_epi64(0, 1, 8, 9, 2, 3, 10, 11)
                                        : _mm512_setr_epi64(4, 5, 12, 13, 6, 7, 14, 15);
        const __m512i words = _mm512_permutex2var_epi64(first, order, other);
        const __m512i wide[] = {_mm512_cvtepu16_epi32(_mm512_castsi512_si256(words)),
                                _mm512_cvtepu16_epi32(_mm512_extracti64x4_epi64(words, 1))};
        for (int i = 0; i < 2; ++i) {
            const int count = columns - 16 * i;
            const auto there =
                static_cast<__mmask16>(count >= 16 ? 0xFFFF : (count > 0 ? (1 << count) - 1 : 0));
            const __m512i before =
                add ? _mm512_maskz_loadu_epi32(there, to + 16 * i) : _mm512_setzero_si512();
            _mm512_mask_storeu_epi32(to + 16 * i, there, _mm512_add_epi32(wide[i], before));
        }
    }
}

#else

HWY_INLINE void widen_row(const Stored* HWY_RESTRICT sums, int columns, bool add,
                          std::uint32_t* HWY_RESTRICT to) {
    for (int x = 0; x < columns; ++x) {
        to[x] = static_cast<std::uint32_t>(sums[x]) + (add ? to[x] : 0U);
    }
}

#endif

// Sums to `out`, added to what is there or not. Not a part of the loops that make them, which need
// all registers.
template <int ROWS>
HWY_NOINLINE void widen(const Stored* sums, const Descent& at) {
    constexpr int most = vectors * in_vector;
    const int columns = at.columns < most ? at.columns : most;
    for (int r = 0; r < ROWS; ++r, sums += most) {
        std::uint32_t* to = at.out + r * at.out_stride;
        at.emptied ? widen_row(sums, columns, true, to) : widen_row(sums, columns, false, to);
    }
}

#if HWY_TARGET == HWY_AVX2

// Few positions at a time: all eight of a row at once, unless the row ends among them.
template <int ROWS, int R = 0>
HWY_INLINE void narrow(const RowSums& sums, const Descent& at) {
    if constexpr (R < ROWS) {
        const __m256 both = _mm256_shuffle_ps(_mm256_castsi256_ps(sums[R][0]),
                                              _mm256_castsi256_ps(sums[R][1]), 0x88);
        _mm256_storeu_si256(reinterpret_cast<__m256i*>(at.out + R * at.out_stride),
                            _mm256_permute4x64_epi64(_mm256_castps_si256(both), 0xD8));
        narrow<ROWS, R + 1>(sums, at);
    }
}
constexpr bool narrows = true;

#else

template <int ROWS>
HWY_INLINE void narrow(const RowSums&, const Descent&) {}
constexpr bool narrows = false;

#endif

template <int ROWS>
HWY_INLINE void empty_all(Descent& at, RowSums& sums) {
    if (narrows && at.columns >= vectors * in_vector) {
        return narrow<ROWS>(sums, at);
    }
    alignas(64) Stored stored[ROWS * vectors * in_vector];
    store<ROWS>(sums, stored);
    widen<ROWS>(stored, at);
    clear<ROWS>(sums);
    at.emptied = true;
}

// Before a group's first row: what its first and last rows add to any sum, ROWS - 1 groups, is
// spoken for.
template <int ROWS>
HWY_INLINE void begin_group(Descent& at, RowSums& sums) {
    if (most_in_sum > 0 && at.in_sum + ROWS > most_in_sum) {
        empty_all<ROWS>(at, sums);
        at.in_sum = 0;
    }
    at.in_sum += ROWS - 1;
}

// So many of the next steps as the sums have room for, at least one.
template <int ROWS>
HWY_INLINE int make_room(int steps, Descent& at, RowSums& sums) {
    if (most_in_sum == 0) {
        return steps;
    }
    if (at.in_sum == most_in_sum) {
        empty_all<ROWS>(at, sums);
        at.in_sum = ROWS - 1;
    }
    const int room = most_in_sum - at.in_sum;
    const int now = steps < room ? steps : room;
    at.in_sum += now;
    return now;
}

template <int FIRST, int LAST>
HWY_INLINE void add_next(Descent& at, const std::uint8_t* of_first, RowSums& sums) {
    const Bytes left = image_group(at.pixels, *at.order);
    const Bytes right = image_group(at.pixels + second, *at.order);
    add_to_rows<FIRST, LAST>(left, right, of_first, sums);
    at.pixels += at.image_stride;
}

// The image rows under the first output rows only.
template <int ROWS, int LAST>
HWY_INLINE void add_rising(Descent& at, RowSums& sums) {
    if constexpr (LAST < ROWS - 1) {
        add_next<0, LAST>(at, at.of_templ, sums);
        at.of_templ += group;
        add_rising<ROWS, LAST + 1>(at, sums);
    }
}

// The image rows under the last output rows only.
template <int ROWS, int FIRST>
HWY_INLINE void add_falling(Descent& at, const std::uint8_t* last_row, RowSums& sums) {
    if constexpr (FIRST < ROWS) {
        add_next<FIRST, ROWS - 1>(at, last_row, sums);
        add_falling<ROWS, FIRST + 1>(at, last_row, sums);
    }
}

// ROWS output rows of one group of positions. ROWS is not above the template's height.
template <int ROWS>
HWY_NOINLINE void sad_rows(const Planes& image, const PackedTemplate& templ, const Groups& groups,
                           const std::uint8_t* first_pixel, int columns, std::uint32_t* out,
                           std::ptrdiff_t out_stride) {
    RowSums sums;
    clear<ROWS>(sums);
    Descent at{first_pixel, image.stride, groups.bytes.data(), nullptr, columns, out, out_stride,
               0,           false};
    for (int plane = 0; plane < templ.planes; ++plane) {
        for (std::ptrdiff_t g = 0; g < groups.in_row; ++g) {
            at.pixels = first_pixel + plane * image.plane_stride + g * group;
            at.order = &order_for(templ.width - static_cast<int>(g) * group);
            begin_group<ROWS>(at, sums);
            add_rising<ROWS, 0>(at, sums);
            for (int left = templ.height - ROWS + 1; left > 0;) {
                const int now = make_room<ROWS>(left, at, sums);
                for (int k = 0; k < now; ++k) {
                    add_next<0, ROWS - 1>(at, at.of_templ, sums);
                    at.of_templ += group;
                }
                left -= now;
            }
            add_falling<ROWS, 1>(at, at.of_templ - group, sums);
        }
    }
    empty_all<ROWS>(at, sums);
}

template <int ROWS>
void sad_few_rows(int rows, const Planes& image, const PackedTemplate& templ, const Groups& groups,
                  const std::uint8_t* pixels, int columns, std::uint32_t* out,
                  std::ptrdiff_t out_stride) {
    if constexpr (ROWS > 1) {
        if (rows < ROWS) {
            sad_few_rows<ROWS - 1>(rows, image, templ, groups, pixels, columns, out, out_stride);
            return;
        }
    }
    sad_rows<ROWS>(image, templ, groups, pixels, columns, out, out_stride);
}

void sad(const Planes& image, const PackedTemplate& templ, const Block& block, std::uint32_t* out) {
    constexpr int columns = vectors * in_vector;
    static thread_local Groups groups;
    groups.take(templ);
    for (int y = 0; y < block.rows;) {
        const int rows = std::min({most_rows, block.rows - y, templ.height});
        for (int x = 0; x < block.columns; x += columns) {
            const std::uint8_t* pixels = image.pixels + y * image.stride + x;
            std::uint32_t* to = out + y * block.stride + x;
            sad_few_rows<most_rows>(rows, image, templ, groups, pixels, block.columns - x, to,
                                    block.stride);
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
