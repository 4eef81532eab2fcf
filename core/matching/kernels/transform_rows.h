// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace kambara {

/// A row of a transform from the rows of the picture about it: rows[radius] is the one it lies in,
/// each pointing at the first pixel to be transformed, with `radius` pixels before it and after the
/// last. Chosen for this processor.
struct TransformRows {
    void (*rank3)(const std::uint8_t* const* rows, int count, std::uint8_t* out);
    void (*rank5)(const std::uint8_t* const* rows, int count, std::uint8_t* out);
    void (*census)(const std::uint8_t* const* rows, int count,
                   std::uint8_t* out);  ///< 3 bytes each
    void (*gradient)(const std::uint8_t* const* rows, int count, std::uint8_t* out);

    /// Weighted sums along a row: sum of weights[|i|] row[x + i] over |i| <= radius, a quarter of
    /// it, rounded down. With weights that sum to 256: 64 times the grey level. Radius 2, 3 or 4.
    void (*smooth_along)(const std::uint8_t* row, const std::int16_t* weights, int radius,
                         int count, std::int16_t* out);
    /// The same across 7 rows of such sums, and the whole as a grey level, rounded.
    void (*smooth_across)(const std::int16_t* const* seven, const std::int16_t* weights, int count,
                          std::uint8_t* out);
    /// 1 where the sums across 5 rows are larger than those across 9 others, else 0.
    void (*larger_across)(const std::int16_t* const* five, const std::int16_t* five_weights,
                          const std::int16_t* const* nine, const std::int16_t* nine_weights,
                          int count, std::uint8_t* out);
    /// Three channels of interleaved pixels apart.
    void (*split)(const std::uint8_t* pixels, int count, std::uint8_t* first, std::uint8_t* second,
                  std::uint8_t* third);
};

const TransformRows& transform_rows();

}  // namespace kambara
