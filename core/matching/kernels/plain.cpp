// SPDX-License-Identifier: GPL-3.0-or-later
// The definitions, loop by loop: what every other implementation must equal.
#include <hwy/targets.h>
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>

#include "core/matching/kernels/simd.h"

namespace kambara {
namespace {

const std::uint8_t* image_row(const Planes& image, int plane, int y) {
    return image.pixels + plane * image.plane_stride + y * image.stride;
}

// Calls term(image byte, index into the template) over the template at each position.
template <class Sum, class Term>
void at_each_position(const Planes& image, const PackedTemplate& templ, const Block& block,
                      int column_step, Sum* out, const Term& term) {
    for (int y = 0; y < block.rows; ++y) {
        for (int x = 0; x < block.columns; ++x) {
            Sum sum = 0;
            for (int plane = 0; plane < templ.planes; ++plane) {
                for (int j = 0; j < templ.height; ++j) {
                    const std::uint8_t* row = image_row(image, plane, y + j) + x;
                    const std::size_t first = templ.offset(plane, j);
                    for (int i = 0; i < templ.padded_width; ++i) {
                        sum = static_cast<Sum>(
                            sum + term(row[i * column_step], first + static_cast<std::size_t>(i)));
                    }
                }
            }
            out[y * block.stride + x] = sum;
        }
    }
}

void dot(const Planes& image, const PackedTemplate& templ, const Block& block, std::int32_t* out) {
    at_each_position(image, templ, block, 1, out, [&](std::uint8_t pixel, std::size_t i) {
        return pixel * static_cast<std::int32_t>(templ.centred[i]);
    });
}

void sad(const Planes& image, const PackedTemplate& templ, const Block& block, std::uint32_t* out) {
    at_each_position(image, templ, block, 1, out, [&](std::uint8_t pixel, std::size_t i) {
        return static_cast<std::uint32_t>(std::abs(pixel - static_cast<int>(templ.bytes[i])));
    });
}

void hamming(const Planes& image, const PackedTemplate& templ, const Block& block,
             std::uint32_t* out) {
    at_each_position(image, templ, block, templ.column_step, out,
                     [&](std::uint8_t pixel, std::size_t i) {
                         const auto differing =
                             static_cast<std::uint8_t>((pixel ^ templ.bytes[i]) & templ.masks[i]);
                         return static_cast<std::uint32_t>(std::popcount(differing));
                     });
}

void roll_columns(const std::uint8_t* added, const std::uint8_t* removed, int count,
                  std::uint32_t* sums, std::uint32_t* squares) {
    for (int x = 0; x < count; ++x) {
        const std::uint32_t a = added != nullptr ? added[x] : 0U;
        const std::uint32_t r = removed != nullptr ? removed[x] : 0U;
        sums[x] += a - r;
        squares[x] += a * a - r * r;
    }
}

void take_off(const std::uint8_t* added, std::ptrdiff_t stride, int rows,
              const std::uint8_t* removed, int width, int count, std::uint32_t* sums,
              std::uint32_t* costs) {
    for (int x = 0; x < count; ++x) {
        for (int i = x; i < x + width; ++i) {
            for (int y = 0; y < rows; ++y) {
                sums[x] += added[y * stride + i];
            }
            sums[x] -= removed != nullptr ? removed[i] : 0U;
        }
        if (costs != nullptr) {
            costs[x] -= sums[x];
        }
    }
}

void roll_and_sum(const std::uint8_t* added, const std::uint8_t* removed, int count,
                  std::uint32_t* column_sums, std::uint32_t* column_squares, std::uint32_t* sums,
                  std::uint32_t* squares) {
    roll_columns(added, removed, count, column_sums, column_squares);
    sums[0] = 0;
    squares[0] = 0;
    for (int x = 0; x < count; ++x) {
        sums[x + 1] = sums[x] + column_sums[x];
        squares[x + 1] = squares[x] + column_squares[x];
    }
}

void correlate(const std::int32_t* dots, const std::uint32_t* sums, const std::uint32_t* squares,
               int width, int count, const Normalisation& norm, float* out) {
    const auto template_factor = static_cast<float>(norm.template_squares);
    for (int x = 0; x < count; ++x) {
        const double S = sums[x + width] - sums[x];
        const double Q = squares[x + width] - squares[x];
        const double numerator =
            norm.zero_mean ? norm.count * dots[x] - S * norm.template_sum : dots[x] + 128.0 * S;
        const double variance = norm.zero_mean ? norm.count * Q - S * S : Q;
        const float product = static_cast<float>(variance) * template_factor;
        const float score = static_cast<float>(numerator) / std::sqrt(product);
        out[x] = product > 0.0F ? std::fmin(std::fmax(score, -1.0F), 1.0F) : 0.0F;
    }
}

double multiply_add_at_best(int rounds) {
    volatile int factor = 3;
    const int by = factor;
    int sums[8] = {};
    for (int i = 0; i < rounds; ++i) {
        for (int& sum : sums) {
            sum = sum * by + i;
        }
    }
    factor = sums[0] ^ sums[1] ^ sums[2] ^ sums[3] ^ sums[4] ^ sums[5] ^ sums[6] ^ sums[7];
    return 8.0 * rounds;
}

void centred_values(const std::uint8_t* pixels, int count, double* out) {
    for (int x = 0; x < count; ++x) {
        out[x] = pixels[x] - 128;
    }
}

void multiply_spectra(const double* a, const double* b, const SpectrumPart& part, bool add,
                      double* out) {
    for (int y = 0; y < part.rows; ++y) {
        const std::ptrdiff_t row = 2 * y * part.stride;
        for (std::ptrdiff_t i = row; i < row + 2 * part.columns; i += 2) {
            const double real = a[i] * b[i] - a[i + 1] * b[i + 1];
            const double imaginary = a[i] * b[i + 1] + a[i + 1] * b[i];
            out[i] = add ? out[i] + real : real;
            out[i + 1] = add ? out[i + 1] + imaginary : imaginary;
        }
    }
}

void whole_numbers(const double* values, int count, double scale, double offset,
                   std::int32_t* out) {
    for (int x = 0; x < count; ++x) {
        out[x] = static_cast<std::int32_t>(std::nearbyint(values[x] * scale + offset));
    }
}

float largest(const float* scores, int count) {
    return *std::max_element(scores, scores + count);
}

std::uint32_t smallest(const std::uint32_t* costs, int count) {
    return *std::min_element(costs, costs + count);
}

// Plain loops there, too: those that every processor of this kind runs.
TransformRows plain_transforms() {
    hwy::ChosenTarget any;
    any.Update(HWY_STATIC_TARGET);
    TransformRows rows{};
    use_simd_transforms(any.GetIndex(), rows);
    use_simd_signs(any.GetIndex(), rows);
    return rows;
}

}  // namespace

const Kernels& plain_kernels() {
    static const Kernels kernels{"scalar",
                                 dot,
                                 sad,
                                 true,
                                 hamming,
                                 roll_columns,
                                 take_off,
                                 roll_and_sum,
                                 correlate,
                                 multiply_add_at_best,
                                 largest,
                                 smallest,
                                 centred_values,
                                 multiply_spectra,
                                 whole_numbers,
                                 plain_transforms()};
    return kernels;
}

void PackedTemplate::centre() {
    centred.assign(bytes.size(), 0);
    centred16.assign(bytes.size(), 0);
    for (std::size_t i = 0; i + kernel_template_slack < bytes.size(); ++i) {
        if (static_cast<int>(i % static_cast<std::size_t>(padded_width)) < width) {
            centred16[i] = static_cast<std::int16_t>(bytes[i] - 128);
            centred[i] = static_cast<std::int8_t>(bytes[i] - 128);
        }
    }
}

}  // namespace kambara
