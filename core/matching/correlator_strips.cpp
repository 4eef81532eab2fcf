// SPDX-License-Identifier: GPL-3.0-or-later
// The scores of a strip of rows, one way for each kind of measure and template.
#include <algorithm>
#include <cmath>

#include "core/matching/correlator.h"

namespace kambara {
// Column sums over the template's height for the positions' row, and their prefix sums: rolled on
// from the row before, or made anew for the first.
void Correlator::roll_to(int row, int columns) {
    const int count = whole_vectors(columns);
    const auto pixels = [&](int plane, int y) {
        return planes_.pixels + plane * planes_.plane_stride + y * planes_.stride;
    };
    if (row == 0) {
        std::fill_n(column_sums_.begin(), count, 0U);
        std::fill_n(column_squares_.begin(), count, 0U);
    }
    for (int plane = 0; plane < channels_; ++plane) {
        const std::uint8_t* removed = row == 0 ? nullptr : pixels(plane, row - 1);
        for (int y = row == 0 ? 0 : height_ - 1; y < height_; ++y) {
            if (plane < channels_ - 1 || y < height_ - 1) {
                kernels_->roll_columns(pixels(plane, row + y), removed, count, column_sums_.data(),
                                       column_squares_.data());
            } else {
                kernels_->roll_and_sum(pixels(plane, row + y), removed, count, column_sums_.data(),
                                       column_squares_.data(), sums_.data(), squares_.data());
            }
        }
    }
}

// Takes the template's padding off a row of costs, where it was compared with 0, by sums of the
// pixels under it: rolled on likewise.
void Correlator::take_padding_off(int row, int padding, int columns, std::uint32_t* costs) {
    const auto pixels = [&](int plane, int y) {
        return planes_.pixels + plane * planes_.plane_stride + y * planes_.stride + width_;
    };
    if (row == 0) {
        std::fill_n(column_sums_.begin(), whole_vectors(columns), 0U);
    }
    for (int plane = 0; plane < channels_; ++plane) {
        std::uint32_t* last = plane == channels_ - 1 ? costs : nullptr;
        if (row == 0) {
            kernels_->take_off(pixels(plane, 0), planes_.stride, height_, nullptr, padding, columns,
                               column_sums_.data(), last);
        } else {
            kernels_->take_off(pixels(plane, row + height_ - 1), 0, 1, pixels(plane, row - 1),
                               padding, columns, column_sums_.data(), last);
        }
    }
}

void Correlator::score_bits(const Block& block, int row, std::uint32_t* costs) {
    kernels_->hamming(planes_from(row), packed_, block, costs);
}

// Kernels may count what is not under the template as compared with 0: it is taken off again.
void Correlator::score_sads(const Block& block, int row, std::uint32_t* costs) {
    kernels_->sad(planes_from(row), packed_, block, costs);
    const int padding = kernels_->sad_counts_padding ? packed_.padded_width - width_ : 0;
    if (masked_) {
        const Block strip{block.columns, block.rows, whole_groups(block.columns)};
        kernels_->dot(planes_from(row), outside_, strip, dots_.data());
        for (int y = 0; y < block.rows; ++y) {
            for (int x = 0; x < block.columns; ++x) {
                costs[y * block.stride + x] -= static_cast<std::uint32_t>(
                    dots_[static_cast<std::size_t>(y * strip.stride + x)]);
            }
        }
    } else if (padding > 0) {
        for (int y = 0; y < block.rows; ++y) {
            take_padding_off(row + y, padding, block.columns, costs + y * block.stride);
        }
    }
}

void Correlator::score_correlations(const Block& block, int row, float* scores) {
    const Block strip{block.columns, block.rows, whole_groups(block.columns)};
    const std::int32_t* dots = dots_.data();
    if (spectral_) {
        dots += row * strip.stride;
    } else {
        kernels_->dot(planes_from(row), packed_, strip, dots_.data());
    }
    const int summed = whole_vectors(block.columns + width_ - 1);
    for (int y = 0; y < block.rows; ++y) {
        roll_to(row + y, summed);
        kernels_->correlate(dots + y * strip.stride, sums_.data(), squares_.data(), width_,
                            block.columns, normalisation_, scores + y * block.stride);
    }
}

// The two bytes of each pixel's square, as planes of their own.
void Correlator::load_squares() {
    const auto bytes = static_cast<std::size_t>(planes_.plane_stride * channels_);
    if (squares_low_.size() < pixels_.size()) {
        squares_low_.resize(pixels_.size());
        squares_high_.resize(pixels_.size());
    }
    for (std::size_t i = 0; i < bytes; ++i) {
        const unsigned square = static_cast<unsigned>(pixels_[i]) * pixels_[i];
        squares_low_[i] = static_cast<std::uint8_t>(square);
        squares_high_[i] = static_cast<std::uint8_t>(square >> 8U);
    }
}

// Under a mask, or over more pixels than 32 bits hold, every sum is a dot product of one plane.
void Correlator::score_by_products(const Block& block, int row, float* scores) {
    const Block strip{block.columns, block.rows, whole_groups(block.columns)};
    const auto cells = static_cast<std::size_t>(strip.stride * strip.rows);
    std::fill_n(wide_.begin(), 3 * cells, 0.0);
    double* products = wide_.data();
    double* sums = products + cells;
    double* squares = sums + cells;
    const auto add = [&](const std::vector<std::uint8_t>& pixels, int plane,
                         const PackedTemplate& templ, double factor, double* to) {
        Planes planes = planes_from(row);
        planes.pixels = pixels.data() + row * planes_.stride + plane * planes_.plane_stride;
        kernels_->dot(planes, templ, strip, dots_.data());
        for (std::size_t i = 0; i < cells; ++i) {
            to[i] += factor * dots_[i];
        }
    };
    for (int plane = 0; plane < channels_; ++plane) {
        add(pixels_, plane, of_planes_[static_cast<std::size_t>(plane)], 1.0, products);
        add(pixels_, plane, inside_, 1.0, sums);
        add(squares_low_, plane, inside_, 1.0, squares);
        add(squares_high_, plane, inside_, 256.0, squares);
    }
    const Normalisation& norm = normalisation_;
    const auto template_factor = static_cast<float>(norm.template_squares);
    for (int y = 0; y < block.rows; ++y) {
        for (int x = 0; x < block.columns; ++x) {
            const auto i = static_cast<std::size_t>(y * strip.stride + x);
            const double numerator = norm.zero_mean
                                         ? norm.count * products[i] - sums[i] * norm.template_sum
                                         : products[i] + 128.0 * sums[i];
            const double variance =
                norm.zero_mean ? norm.count * squares[i] - sums[i] * sums[i] : squares[i];
            const float product = static_cast<float>(variance) * template_factor;
            scores[y * block.stride + x] =
                product > 0.0F
                    ? std::clamp(static_cast<float>(numerator) / std::sqrt(product), -1.0F, 1.0F)
                    : 0.0F;
        }
    }
}

}  // namespace kambara
