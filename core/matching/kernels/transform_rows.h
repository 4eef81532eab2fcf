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

    /// Weighted sums along a row: out[x] = sum of weights[|i|] row[x + i] over |i| <= radius.
    void (*smooth_along)(const std::uint8_t* row, const std::uint16_t* weights, int radius,
                         int count, std::uint16_t* out);
    /// The same across rows of such sums, which are 256 times too large, as the sums then are
    /// again.
    void (*smooth_across)(const std::uint16_t* const* rows, const std::uint16_t* weights,
                          int radius, int count, std::uint32_t* out);
};

const TransformRows& transform_rows();

}  // namespace kambara
