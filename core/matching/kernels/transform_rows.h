// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

namespace kambara {

/// Weights of two Gaussians in whole numbers, the middle one, then to one side: the sum over both
/// sides is 256, and no two neighbours make more than 255. Made once, for many rows.
struct TwoGaussians {
    TwoGaussians(const std::array<std::int16_t, 3>& of_narrow,
                 const std::array<std::int16_t, 5>& of_wide);

    std::array<std::int16_t, 3> narrow;
    std::array<std::int16_t, 5> wide;

    // As vectors multiply them, in 32 bits, which come to all lanes by a load alone.
    std::array<std::array<std::uint32_t, 3>, 2> narrow_pairs;  ///< along: bytes, from -2, from -3
    std::array<std::array<std::uint32_t, 5>, 2> wide_pairs;    ///< likewise, from -4, from -5
    /// Across, if the first row is an even one, or an odd one: -narrow and wide of the rows 0, 1
    /// and 2 away from the middle, each in its row's order; wide of the outer two.
    std::array<std::array<std::uint32_t, 4>, 2> across;
};

/// A row of a transform from the rows of the picture about it: rows[radius] is the one it lies in,
/// each pointing at the first pixel to be transformed, with `radius` pixels before it and after the
/// last.
struct TransformRows {
    void (*rank3)(const std::uint8_t* const* rows, int count, std::uint8_t* out);
    void (*rank5)(const std::uint8_t* const* rows, int count, std::uint8_t* out);
    void (*census)(const std::uint8_t* const* rows, int count,
                   std::uint8_t* out);  ///< 3 bytes each
    void (*gradient)(const std::uint8_t* const* rows, int count, std::uint8_t* out);

    /// Weighted sums along a row: sum of weights[|i|] row[x + i] over |i| <= 3, a quarter of it,
    /// rounded down. With weights that sum to 256: 64 times the grey level.
    void (*smooth_along)(const std::uint8_t* row, const std::int16_t* weights, int count,
                         std::int16_t* out);
    /// The same across 7 rows of such sums, and the whole as a grey level, rounded.
    void (*smooth_across)(const std::int16_t* const* seven, const std::int16_t* weights, int count,
                          std::uint8_t* out);

    /// Both Gaussians' sums along a row, radius 4, in an order that larger_across() knows: two
    /// numbers a pixel, for whole groups of kernel_columns pixels, the narrow one's first in even
    /// rows and second in odd ones. `readable` bytes from `row` on, at least count + 4, may be
    /// read, and what lies in the last of them need not mean anything.
    void (*both_along)(const std::uint8_t* row, const TwoGaussians& weights, int count,
                       int readable, bool odd, std::int16_t* out);
    /// 1 where, across 9 rows of such sums, the narrow Gaussian's is larger than the wide one's,
    /// else 0. Exact. One row or two of results that follow each other at once, from 9 rows or 10,
    /// of which the first may be an odd one. `writable` bytes from `out` on, at least the rows',
    /// may be overwritten.
    void (*larger_across)(const std::int16_t* const* ten, bool odd, const TwoGaussians& weights,
                          int count, int results, int writable, std::uint8_t* out);

    /// Of a row of 0 and 1, each with the seven after it (none after the last) as the bits of a
    /// byte, the nearest in the lowest. May be done in place. Fills whole groups of kernel_columns.
    void (*gather_bits)(const std::uint8_t* row, int count, std::uint8_t* out);

    /// Three channels of interleaved pixels apart.
    void (*split)(const std::uint8_t* pixels, int count, std::uint8_t* first, std::uint8_t* second,
                  std::uint8_t* third);
};

/// Those of best_kernels().
const TransformRows& transform_rows();

}  // namespace kambara
