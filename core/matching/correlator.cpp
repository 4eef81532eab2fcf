// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/matching/correlator.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <type_traits>

namespace kambara {
namespace {

constexpr int strip_rows = 24;  // whole blocks of every kernel; the results stay in the cache
constexpr double most_in_32_bits = 65793.0;

template <class T>
void make_room(std::vector<T>& vector, std::size_t size) {
    if (vector.size() < size) {
        vector.resize(size);
    }
}

// Rounded to whole groups of four bytes, with slack after the last.
PackedTemplate empty_like(int width, int height, int planes) {
    PackedTemplate templ;
    templ.width = width;
    templ.height = height;
    templ.planes = planes;
    templ.padded_width = (width + 3) / 4 * 4;
    templ.bytes.assign(templ.offset(planes, 0) + kernel_template_slack, 0);
    templ.centred.assign(templ.bytes.size(), 0);
    templ.centred16.assign(templ.bytes.size(), 0);
    return templ;
}

// The kernels' dot product is with T - 128: sets that factor.
void set_factor(PackedTemplate& templ, std::size_t i, int factor) {
    templ.centred[i] = static_cast<std::int8_t>(factor);
    templ.centred16[i] = static_cast<std::int16_t>(factor);
}

void check_size(const Image& templ, const Image* mask, int step) {
    if (templ.width() < 1 || templ.height() < 1 || templ.width() > largest_template_px ||
        templ.height() > largest_template_px || (templ.channels() != 1 && templ.channels() != 3) ||
        step < 1) {
        throw std::invalid_argument("a template has 1 x 1 to 255 x 255 pixels of 1 or 3 channels");
    }
    if (mask != nullptr && (mask->width() != templ.width() || mask->height() != templ.height() ||
                            mask->channels() != 1)) {
        throw std::invalid_argument("a mask is of its template's size, with one channel");
    }
}

// To every step-th place.
template <class T>
void spread(const T* from, int count, int step, T* to) {
    for (int x = 0; x < count; ++x) {
        to[x * step] = from[x];
    }
}

}  // namespace

Correlator::Correlator(const Kernels& kernels) : kernels_(&kernels) {}

void Correlator::set_template(Measure measure, const Image& templ, const Image* mask, int step) {
    check_size(templ, mask, step);
    measure_ = measure;
    step_ = step;
    channels_ = templ.channels();
    width_ = (templ.width() + step - 1) / step;
    height_ = (templ.height() + step - 1) / step;
    masked_ = mask != nullptr;
    spectral_known_ = false;
    if (measure == Measure::hamming) {
        pack_bits(templ, mask);
    } else {
        pack_levels(templ, mask);
    }
}

void Correlator::pack_bits(const Image& templ, const Image* mask) {
    const bool single = channels_ == 1;
    packed_ = {};
    packed_.width = width_;
    packed_.height = height_;
    packed_.planes = channels_;
    packed_.padded_width = single ? (width_ + 7) / 8 : width_;
    packed_.column_step = single ? 8 : 1;
    packed_.bytes.assign(packed_.offset(channels_, 0) + kernel_template_slack, 0);
    packed_.masks.assign(packed_.bytes.size(), 0);
    for (int c = 0; c < channels_; ++c) {
        for (int y = 0; y < height_; ++y) {
            for (int x = 0; x < width_; ++x) {
                const std::size_t i =
                    packed_.offset(c, y) + static_cast<std::size_t>(single ? x / 8 : x);
                const int shift = single ? x % 8 : 0;
                const bool in = mask == nullptr || mask->at(x * step_, y * step_) != 0;
                const int all = in ? (single ? 1 : 255) : 0;
                const int bits = templ.at(x * step_, y * step_, c);
                packed_.bytes[i] = static_cast<std::uint8_t>(packed_.bytes[i] | bits << shift);
                packed_.masks[i] = static_cast<std::uint8_t>(packed_.masks[i] | all << shift);
            }
        }
    }
}

void Correlator::pack_levels(const Image& templ, const Image* mask) {
    packed_ = empty_like(width_, height_, channels_);
    outside_ = packed_;
    outside_.width = outside_.padded_width;  // its padding counts
    inside_ = empty_like(width_, height_, 1);
    of_planes_.assign(static_cast<std::size_t>(channels_), inside_);
    std::int64_t count = 0;
    std::int64_t sum = 0;  // of T - 128
    std::int64_t squares = 0;
    std::int64_t centred_squares = 0;
    for (int c = 0; c < channels_; ++c) {
        for (int y = 0; y < height_; ++y) {
            for (int x = 0; x < packed_.padded_width; ++x) {
                const std::size_t i = packed_.offset(c, y) + static_cast<std::size_t>(x);
                const std::size_t in_plane = packed_.offset(0, y) + static_cast<std::size_t>(x);
                if (x >= width_ && !kernels_->sad_counts_padding) {
                    continue;
                }
                if (x >= width_ || (mask != nullptr && mask->at(x * step_, y * step_) == 0)) {
                    set_factor(outside_, i, 1);
                    continue;
                }
                const int value = templ.at(x * step_, y * step_, c);
                packed_.bytes[i] = static_cast<std::uint8_t>(value);
                set_factor(packed_, i, value - 128);
                set_factor(of_planes_[static_cast<std::size_t>(c)], in_plane, value - 128);
                set_factor(inside_, in_plane, 1);
                ++count;
                sum += value - 128;
                squares += value * value;
                centred_squares += (value - 128) * (value - 128);
            }
        }
    }
    normalisation_.zero_mean = measure_ == Measure::zncc;
    normalisation_.count = static_cast<double>(count);
    normalisation_.template_sum = static_cast<double>(sum);
    normalisation_.template_squares = normalisation_.zero_mean
                                          ? static_cast<double>(count * centred_squares - sum * sum)
                                          : static_cast<double>(squares);
    by_products_ = !is_cost(measure_) && (masked_ || normalisation_.count > most_in_32_bits);
}

void Correlator::load(const Image& picture, const Rectangle& region, int first_x, int first_y,
                      int columns, int rows) {
    const int bytes = columns + width_ - 1;
    const int lines = rows + height_ - 1;
    planes_.stride = whole_groups(columns) + whole_groups(width_ + 3) + kernel_columns;
    // An odd number of groups, so that the rows do not all meet in a few sets of the cache.
    planes_.stride |= kernel_columns;
    planes_.plane_stride = planes_.stride * lines;
    make_room(pixels_,
              static_cast<std::size_t>(planes_.plane_stride * channels_) + kernel_row_slack);
    planes_.pixels = pixels_.data();
    for (int y = 0; y < lines; ++y) {
        const std::uint8_t* from = picture.row(region.y + first_y + y * step_) +
                                   static_cast<std::ptrdiff_t>(region.x + first_x) * channels_;
        std::uint8_t* to = pixels_.data() + y * planes_.stride;
        if (channels_ == 3 && step_ == 1) {
            kernels_->transforms.split(from, bytes, to, to + planes_.plane_stride,
                                       to + 2 * planes_.plane_stride);
        }
        const bool bits = packed_.column_step == 8;
        for (int c = 0; c < channels_; ++c, to += planes_.plane_stride) {
            if (channels_ == 1 && step_ == 1) {
                if (bits) {
                    kernels_->transforms.gather_bits(from, bytes, to);
                } else {
                    std::memcpy(to, from, static_cast<std::size_t>(bytes));
                }
            } else if (step_ != 1) {
                for (int x = 0; x < bytes; ++x) {
                    to[x] = from[x * step_ * channels_ + c];
                }
                if (bits) {
                    kernels_->transforms.gather_bits(to, bytes, to);
                }
            }
            std::memset(to + bytes, 0, static_cast<std::size_t>(planes_.stride - bytes));
        }
    }
}

Planes Correlator::planes_from(int row) const {
    Planes planes = planes_;
    planes.pixels += row * planes_.stride;
    return planes;
}

void Correlator::scores(const Image& picture, const Rectangle& positions, ScoreMap& map) {
    const int full_width = (width_ - 1) * step_ + 1;
    const int full_height = (height_ - 1) * step_ + 1;
    const int left = std::max(positions.x, 0);
    const int top = std::max(positions.y, 0);
    const int right = std::min(positions.x + positions.width, picture.width() - full_width + 1);
    const int bottom = std::min(positions.y + positions.height, picture.height() - full_height + 1);
    map.positions = {left, top, std::max(right - left, 0), std::max(bottom - top, 0)};
    if (map.positions.width == 0 || map.positions.height == 0) {
        map.positions.width = 0;
        map.positions.height = 0;
        map.scores.clear();
        map.costs.clear();
        return;
    }
    if (picture.channels() != channels_) {
        throw std::invalid_argument("a picture has as many channels as its template");
    }
    const std::size_t size = static_cast<std::size_t>(map.positions.width) *
                             static_cast<std::size_t>(map.positions.height);
    // Not cleared before: what is there is written over.
    map.costs.resize(is_cost(measure_) ? size : 0);
    map.scores.resize(is_cost(measure_) ? 0 : size);
    // The positions of each phase of the step see pixels of their own.
    for (int first_y = 0; first_y < std::min(step_, map.positions.height); ++first_y) {
        for (int first_x = 0; first_x < std::min(step_, map.positions.width); ++first_x) {
            const int columns = (map.positions.width - first_x + step_ - 1) / step_;
            const int rows = (map.positions.height - first_y + step_ - 1) / step_;
            load(picture, map.positions, first_x, first_y, columns, rows);
            scan(columns, rows, first_x, first_y, map);
        }
    }
}

void Correlator::scan(int columns, int rows, int first_x, int first_y, ScoreMap& map) {
    const bool cost = is_cost(measure_);
    const auto strip = static_cast<std::size_t>(whole_groups(columns) * strip_rows);
    const auto line = static_cast<std::size_t>(whole_groups(columns) +
                                               2 * whole_groups(width_ + 3) + kernel_columns);
    spectral_ = !cost && !by_products_ &&
                (way_ == Way::spectrum ||
                 (way_ == Way::quickest && SpectralDot::pays(packed_, columns, rows)));
    make_room(dots_, spectral_ ? static_cast<std::size_t>(whole_groups(columns) * rows) : strip);
    make_room(wide_, by_products_ ? 3 * strip : 0);
    for (auto* vector : {&sums_, &squares_, &column_sums_, &column_squares_}) {
        make_room(*vector, line);
    }
    if (by_products_) {
        load_squares();
    }
    if (spectral_) {
        if (!spectral_known_) {
            spectral_dot_.set_template(packed_);
            spectral_known_ = true;
        }
        spectral_dot_.dot(planes_, {columns, rows, whole_groups(columns)}, dots_.data());
    }
    if (cost) {
        scan_strips(columns, rows, first_x, first_y, costs_, map.positions.width, map.costs);
    } else {
        scan_strips(columns, rows, first_x, first_y, scores_, map.positions.width, map.scores);
    }
}

template <class T>
void Correlator::scan_strips(int columns, int rows, int first_x, int first_y, std::vector<T>& strip,
                             int map_width, std::vector<T>& map) {
    const bool straight = step_ == 1;
    make_room(strip, straight ? 0 : static_cast<std::size_t>(columns * strip_rows));
    Block block{columns, 0, straight ? map_width : columns};
    // What is done in one go needs no strips.
    const int rows_at_once = straight && measure_ == Measure::hamming ? rows : strip_rows;
    for (int row = 0; row < rows; row += rows_at_once) {
        const auto place = [&](int y) {
            return map.data() +
                   static_cast<std::ptrdiff_t>(first_y + (row + y) * step_) * map_width + first_x;
        };
        block.rows = std::min(rows_at_once, rows - row);
        T* to = straight ? place(0) : strip.data();
        if constexpr (std::is_same_v<T, float>) {
            by_products_ ? score_by_products(block, row, to) : score_correlations(block, row, to);
        } else {
            measure_ == Measure::sad ? score_sads(block, row, to) : score_bits(block, row, to);
        }
        for (int y = 0; !straight && y < block.rows; ++y) {
            spread(to + y * block.stride, columns, step_, place(y));
        }
    }
}

}  // namespace kambara
