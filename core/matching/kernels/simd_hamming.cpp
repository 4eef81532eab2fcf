// SPDX-License-Identifier: GPL-3.0-or-later
// Number of differing bits over a block of positions, in 8-bit sums that are emptied into 32-bit
// ones before they can overflow. A step takes one image row and one byte of the template's row; it
// goes down the template, then to the next byte. The pixels loaded serve all output rows that this
// image row lies under.
#include <algorithm>
#include <bit>
#include <vector>

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
using D32 = hn::Repartition<std::uint32_t, D8>;
using V8 = hn::Vec<D8>;

constexpr int lanes = static_cast<int>(HWY_LANES(std::uint8_t));
constexpr int most_in_sum = 255;
#if HWY_TARGET == HWY_AVX3_DL || HWY_TARGET == HWY_AVX3
constexpr int most_rows = 4;
constexpr int most_vectors = 3;
#else
constexpr int most_rows = 2;  // fewer registers, some of them taken by the count of bits
constexpr int most_vectors = 2;
#endif

// A byte of the template and its mask, each four times: as 32 bits they come to all lanes by a load
// alone.
struct Step {
    std::uint32_t byte;
    std::uint32_t mask;
};

// The template by columns of bytes, each from its first row to its last.
struct Steps {
    std::vector<Step> steps;  // [plane][byte of the row][row]
    int most_bits = 0;        // that a step can add to a sum; 0 if one sum holds them all

    void take(const PackedTemplate& templ) {
        steps.clear();
        steps.reserve(templ.offset(templ.planes, 0));
        most_bits = 0;
        int in_all = 0;
        for (int plane = 0; plane < templ.planes; ++plane) {
            for (int i = 0; i < templ.padded_width; ++i) {
                for (int j = 0; j < templ.height; ++j) {
                    const std::size_t at = templ.offset(plane, j) + static_cast<std::size_t>(i);
                    const int bits = std::popcount(templ.masks[at]);
                    steps.push_back({templ.bytes[at] * 0x01010101U, templ.masks[at] * 0x01010101U});
                    most_bits = std::max(most_bits, bits);
                    in_all += bits;
                }
            }
        }
        most_bits = in_all <= most_in_sum ? 0 : most_bits;
    }
};

// Written out, since a compiler that keeps what the next step could load again passes it on through
// other registers, which takes longer.
HWY_INLINE V8 in_all_lanes(const std::uint32_t& word) {
#if HWY_TARGET == HWY_AVX3_DL || HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX2
    V8 all;
    asm("vpbroadcastd %1, %0" : "=v"(all.raw) : "m"(word));
    return all;
#else
    return hn::BitCast(D8(), hn::Set(D32(), word));
#endif
}

HWY_INLINE V8 add_differing(V8 sum, V8 seen, V8 byte, V8 mask) {
#if HWY_TARGET == HWY_AVX3_DL || HWY_TARGET == HWY_AVX3
    const V8 differing{_mm512_ternarylogic_epi32(seen.raw, byte.raw, mask.raw, 0x28)};
#else
    const V8 differing = hn::And(hn::Xor(seen, byte), mask);
#endif
    return hn::Add(sum, hn::PopulationCount(differing));
}

// A row of sums to `out`, added to what is there or not.
HWY_INLINE void widen(const std::uint8_t* sums, int count, bool add, std::uint32_t* out) {
    const D32 d;
    const hn::Rebind<std::uint8_t, D32> quarter;
    constexpr int in_vector = static_cast<int>(HWY_LANES(std::uint32_t));
    int i = 0;
    for (; i + in_vector <= count; i += in_vector) {
        const auto wide = hn::PromoteTo(d, hn::LoadU(quarter, sums + i));
        hn::StoreU(add ? hn::Add(hn::LoadU(d, out + i), wide) : wide, d, out + i);
    }
    for (; i < count; ++i) {
        out[i] = sums[i] + (add ? out[i] : 0U);
    }
}

// Where a column of bytes is at, and where its sums go.
struct Descent {
    const std::uint8_t* pixels;  // of the image row
    std::ptrdiff_t image_stride;
    const Step* step;  // of the template row that the first output row sees
    int columns;
    std::uint32_t* out;
    std::ptrdiff_t out_stride;
    int in_sum;    // bits that the sums may hold already
    bool emptied;  // at least once
};

// Loops over the output rows and vectors are written as recursions: their sums then never leave the
// registers.
template <int ROWS, int VECTORS>
using AreaSums = V8[ROWS][VECTORS];

template <int ROWS, int VECTORS, int I = 0>
HWY_INLINE void clear(AreaSums<ROWS, VECTORS>& sums) {
    if constexpr (I < ROWS * VECTORS) {
        sums[I / VECTORS][I % VECTORS] = hn::Zero(D8());
        clear<ROWS, VECTORS, I + 1>(sums);
    }
}

template <int ROWS, int VECTORS, int I = 0>
HWY_INLINE void store(const AreaSums<ROWS, VECTORS>& sums, std::uint8_t* out) {
    if constexpr (I < ROWS * VECTORS) {
        hn::Store(sums[I / VECTORS][I % VECTORS], D8(), out + I * lanes);
        store<ROWS, VECTORS, I + 1>(sums, out);
    }
}

template <int ROWS, int VECTORS>
HWY_NOINLINE void widen_all(const std::uint8_t* sums, const Descent& at) {
    constexpr int in_row = VECTORS * lanes;
    for (int r = 0; r < ROWS; ++r) {
        widen(sums + r * in_row, at.columns < in_row ? at.columns : in_row, at.emptied,
              at.out + r * at.out_stride);
    }
}

template <int ROWS, int VECTORS>
HWY_INLINE void empty_all(Descent& at, const AreaSums<ROWS, VECTORS>& sums) {
    alignas(64) std::uint8_t bytes[ROWS * VECTORS * lanes];
    store<ROWS, VECTORS>(sums, bytes);
    widen_all<ROWS, VECTORS>(bytes, at);
    at.emptied = true;
}

template <int VECTORS, int V = 0>
HWY_INLINE void load(const std::uint8_t* pixels, V8 (&seen)[VECTORS]) {
    if constexpr (V < VECTORS) {
        seen[V] = hn::LoadU(D8(), pixels + V * lanes);
        load<VECTORS, V + 1>(pixels, seen);
    }
}

template <int VECTORS, int V = 0>
HWY_INLINE void add_to_vectors(const V8 (&seen)[VECTORS], V8 byte, V8 mask, V8 (&sums)[VECTORS]) {
    if constexpr (V < VECTORS) {
        sums[V] = add_differing(sums[V], seen[V], byte, mask);
        add_to_vectors<VECTORS, V + 1>(seen, byte, mask, sums);
    }
}

// What one image row's bytes add to the output rows R to LAST.
template <int R, int LAST, int ROWS, int VECTORS>
HWY_INLINE void add_to_rows(const V8 (&seen)[VECTORS], const Step* step,
                            AreaSums<ROWS, VECTORS>& sums) {
    if constexpr (R <= LAST) {
        const V8 byte = in_all_lanes(step->byte);
        const V8 mask = in_all_lanes(step->mask);
        add_to_vectors<VECTORS>(seen, byte, mask, sums[R]);
        add_to_rows<R + 1, LAST, ROWS, VECTORS>(seen, step - 1, sums);
    }
}

template <int FIRST, int LAST, int ROWS, int VECTORS>
HWY_INLINE void add_next(Descent& at, const Step* of_first, AreaSums<ROWS, VECTORS>& sums) {
    V8 seen[VECTORS];
    load<VECTORS>(at.pixels, seen);
    add_to_rows<FIRST, LAST, ROWS, VECTORS>(seen, of_first, sums);
    at.pixels += at.image_stride;
}

// The image rows under the first output rows only.
template <int LAST, int ROWS, int VECTORS>
HWY_INLINE void add_rising(Descent& at, AreaSums<ROWS, VECTORS>& sums) {
    if constexpr (LAST < ROWS - 1) {
        add_next<0, LAST, ROWS, VECTORS>(at, at.step++, sums);
        add_rising<LAST + 1, ROWS, VECTORS>(at, sums);
    }
}

// The image rows under the last output rows only, the first of which sees the template's last row.
template <int FIRST, int ROWS, int VECTORS>
HWY_INLINE void add_falling(Descent& at, AreaSums<ROWS, VECTORS>& sums) {
    if constexpr (FIRST < ROWS) {
        add_next<FIRST, ROWS - 1, ROWS, VECTORS>(at, at.step - 1, sums);
        add_falling<FIRST + 1, ROWS, VECTORS>(at, sums);
    }
}

// Before a column of bytes: what its first and last rows add to any sum, ROWS - 1 steps, is spoken
// for.
template <int ROWS, int VECTORS>
HWY_INLINE void begin_column(int most_bits, Descent& at, AreaSums<ROWS, VECTORS>& sums) {
    if (at.in_sum + ROWS * most_bits > most_in_sum) {
        empty_all<ROWS, VECTORS>(at, sums);
        clear<ROWS, VECTORS>(sums);
        at.in_sum = 0;
    }
    at.in_sum += (ROWS - 1) * most_bits;
}

// So many of the next steps as the sums have room for, at least one.
template <int ROWS, int VECTORS>
HWY_INLINE int make_room(int steps, int most_bits, Descent& at, AreaSums<ROWS, VECTORS>& sums) {
    if (most_bits == 0) {
        return steps;
    }
    if (at.in_sum + most_bits > most_in_sum) {
        empty_all<ROWS, VECTORS>(at, sums);
        clear<ROWS, VECTORS>(sums);
        at.in_sum = (ROWS - 1) * most_bits;
    }
    const int room = (most_in_sum - at.in_sum) / most_bits;
    const int now = steps < room ? steps : room;
    at.in_sum += now * most_bits;
    return now;
}

// ROWS output rows of VECTORS vectors of positions. ROWS is not above the template's height.
template <int ROWS, int VECTORS>
HWY_NOINLINE void hamming_area(const Planes& image, const PackedTemplate& templ, const Steps& steps,
                               const std::uint8_t* first_pixel, int columns, std::uint32_t* out,
                               std::ptrdiff_t out_stride) {
    AreaSums<ROWS, VECTORS> sums;
    clear<ROWS, VECTORS>(sums);
    Descent at{first_pixel, image.stride, steps.steps.data(), columns, out, out_stride, 0, false};
    for (int plane = 0; plane < templ.planes; ++plane) {
        for (int i = 0; i < templ.padded_width; ++i) {
            at.pixels = first_pixel + plane * image.plane_stride + i * templ.column_step;
            begin_column<ROWS, VECTORS>(steps.most_bits, at, sums);
            add_rising<0, ROWS, VECTORS>(at, sums);
            for (int left = templ.height - ROWS + 1; left > 0;) {
                const int now = make_room<ROWS, VECTORS>(left, steps.most_bits, at, sums);
                for (int k = 0; k < now; ++k) {
                    add_next<0, ROWS - 1, ROWS, VECTORS>(at, at.step++, sums);
                }
                left -= now;
            }
            add_falling<1, ROWS, VECTORS>(at, sums);
        }
    }
    empty_all<ROWS, VECTORS>(at, sums);
}

// ROWS output rows of all columns.
template <int ROWS, int VECTORS = most_vectors>
void hamming_rows(const Planes& image, const PackedTemplate& templ, const Steps& steps,
                  const std::uint8_t* first_pixel, int columns, std::uint32_t* out,
                  std::ptrdiff_t out_stride) {
    constexpr int wide = VECTORS * lanes;
    for (; columns > wide - lanes; first_pixel += wide, out += wide, columns -= wide) {
        hamming_area<ROWS, VECTORS>(image, templ, steps, first_pixel, columns, out, out_stride);
    }
    if constexpr (VECTORS > 1) {
        hamming_rows<ROWS, VECTORS - 1>(image, templ, steps, first_pixel, columns, out, out_stride);
    }
}

void hamming(const Planes& image, const PackedTemplate& templ, const Block& block,
             std::uint32_t* out) {
    static thread_local Steps steps;
    steps.take(templ);
    for (int y = 0; y < block.rows;) {
        const std::uint8_t* pixels = image.pixels + y * image.stride;
        std::uint32_t* to = out + y * block.stride;
        if (std::min(block.rows - y, templ.height) >= most_rows) {
            hamming_rows<most_rows>(image, templ, steps, pixels, block.columns, to, block.stride);
            y += most_rows;
        } else {
            hamming_rows<1>(image, templ, steps, pixels, block.columns, to, block.stride);
            ++y;
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
