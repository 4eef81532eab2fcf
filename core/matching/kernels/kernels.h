// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/matching/kernels/transform_rows.h"

namespace kambara {

/// Bytes that may be read, and need not mean anything, after the last pixel of each row of a plane
/// that goes to a kernel, and after the template's last byte.
inline constexpr std::size_t kernel_row_slack = 192;
inline constexpr std::size_t kernel_template_slack = 16;

/// Kernels work on whole groups of this many columns.
inline constexpr int kernel_columns = 64;

/// `count` rounded up to whole groups of columns.
constexpr int whole_groups(int count) {
    return (count + kernel_columns - 1) / kernel_columns * kernel_columns;
}

/// `count` rounded up to whole vectors of 32-bit numbers, the widest there are.
constexpr int whole_vectors(int count) {
    constexpr int lanes = 16;
    return (count + lanes - 1) / lanes * lanes;
}

/// One or more planes of bytes.
struct Planes {
    const std::uint8_t* pixels = nullptr;
    std::ptrdiff_t stride = 0;        ///< bytes from row to row
    std::ptrdiff_t plane_stride = 0;  ///< bytes from plane to plane
};

/// A template as the kernels read it: rows padded with zeros to whole groups of four bytes, and
/// kernel_template_slack bytes after the last.
struct PackedTemplate {
    int width = 0;  ///< bytes of a row
    int height = 0;
    int planes = 1;
    int padded_width = 0;  ///< the next multiple of four; of Hamming templates the width itself
    int column_step = 1;   ///< Hamming: image bytes from one template byte to the next

    std::vector<std::uint8_t> bytes;      ///< [plane][row][padded_width]
    std::vector<std::uint8_t> masks;      ///< Hamming: the bits that count
    std::vector<std::int8_t> centred;     ///< less 128; 0 in the padding
    std::vector<std::int16_t> centred16;  ///< the same, wider

    std::size_t offset(int plane, int y) const {
        return (static_cast<std::size_t>(plane) * static_cast<std::size_t>(height) +
                static_cast<std::size_t>(y)) *
               static_cast<std::size_t>(padded_width);
    }
    void centre();  ///< makes the centred copies from `bytes`
};

/// A block of positions, the first over the planes' first pixel.
struct Block {
    int columns = 0;
    int rows = 0;
    std::ptrdiff_t stride = 0;  ///< elements of the result from row to row
};

/// Factors of the last step from integer sums to a correlation.
struct Normalisation {
    bool zero_mean = true;
    double count = 0.0;             ///< N: pixels of the template, planes included
    double template_sum = 0.0;      ///< sum(T - 128); not used without zero_mean
    double template_squares = 0.0;  ///< zero_mean: N sum(T^2) - sum(T)^2; else sum(T^2)
};

/// A few columns of spectra that have the same strides.
struct SpectrumPart {
    int rows = 0;
    int columns = 0;            ///< a multiple of four
    std::ptrdiff_t stride = 0;  ///< complex numbers from row to row
};

/// The inner loops, once for each kind of vector unit. All give the same integers, and correlations
/// that differ in no bit, since they are made by correctly rounded operations only.
struct Kernels {
    std::string name;

    /// sum(I (T - 128)) at each position. At most 65,793 template pixels: 32 bits hold them. Fills
    /// whole groups of columns, unlike the others here.
    void (*dot)(const Planes&, const PackedTemplate&, const Block&, std::int32_t* out) = nullptr;

    /// sum(abs(I - T)) at each position. At most 2^24 pixels.
    void (*sad)(const Planes&, const PackedTemplate&, const Block&, std::uint32_t* out) = nullptr;
    bool sad_counts_padding = true;  ///< the template's padding is in that sum, as T = 0

    /// Number of bits under the masks that differ, at each position.
    void (*hamming)(const Planes&, const PackedTemplate&, const Block&,
                    std::uint32_t* out) = nullptr;

    /// Adds a row of pixels to the sums of columns and takes one away: of values and of squares.
    /// Either row may be null. Whole vectors of columns.
    void (*roll_columns)(const std::uint8_t* added, const std::uint8_t* removed, int count,
                         std::uint32_t* sums, std::uint32_t* squares) = nullptr;

    /// sums[x] += added[x] + ... + added[x + width - 1] of each of `rows` rows, less the same of
    /// the one row `removed`, which may be null: whole vectors of columns. Width 1, 2 or 3. With
    /// costs, costs[x] -= sums[x].
    void (*take_off)(const std::uint8_t* added, std::ptrdiff_t stride, int rows,
                     const std::uint8_t* removed, int width, int count, std::uint32_t* sums,
                     std::uint32_t* costs) = nullptr;

    /// As roll_columns, and then their prefix sums: out[0] = 0, out[x + 1] = out[x] + column[x],
    /// modulo 2^32. `added` is not null.
    void (*roll_and_sum)(const std::uint8_t* added, const std::uint8_t* removed, int count,
                         std::uint32_t* column_sums, std::uint32_t* column_squares,
                         std::uint32_t* sums, std::uint32_t* squares) = nullptr;

    /// A row of correlations from dot products and the prefix sums of columns of values and squares
    /// under a template of `width` columns. A flat patch, or a flat template, gives 0. What is
    /// read is there for whole vectors of columns.
    void (*correlate)(const std::int32_t* dot, const std::uint32_t* sums,
                      const std::uint32_t* squares, int width, int count, const Normalisation&,
                      float* out) = nullptr;

    /// As many independent multiply-adds as the unit can do, from registers only, in so many
    /// rounds: what `dot` is measured by. Returns how many of them it did.
    double (*multiply_add_at_best)(int rounds) = nullptr;

    /// The largest of `count` scores, and the smallest of `count` costs. At least one.
    float (*largest)(const float* scores, int count) = nullptr;
    std::uint32_t (*smallest)(const std::uint32_t* costs, int count) = nullptr;

    /// A row of I - 128, for a transform.
    void (*centred_values)(const std::uint8_t* pixels, int count, double* out) = nullptr;

    /// Products of complex numbers, real part first, in place of `out` or added to it.
    void (*multiply_spectra)(const double* a, const double* b, const SpectrumPart&, bool add,
                             double* out) = nullptr;

    /// The whole numbers nearest to scale * value + offset.
    void (*whole_numbers)(const double* values, int count, double scale, double offset,
                          std::int32_t* out) = nullptr;

    TransformRows transforms;
};

/// The best implementation this processor can run; KAMBARA_KERNELS=scalar, sse4, avx2, avx512bw (no
/// 8-bit dot product) or avx512 in the environment chooses another one that it can run. Chosen
/// once.
const Kernels& best_kernels();

/// All that this processor can run, the plain one first and the best last.
const std::vector<Kernels>& runnable_kernels();

/// Plain loops, one position after the other: what the others are held to.
const Kernels& plain_kernels();

}  // namespace kambara
