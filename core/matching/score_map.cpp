// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/matching/score_map.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>

namespace kambara {
namespace {

struct TemplateSums {
    double count = 0.0;
    double sum = 0.0;
    double squares = 0.0;
};

TemplateSums sums_of(const Image& templ) {
    std::int64_t sum = 0;
    std::int64_t squares = 0;
    for (int y = 0; y < templ.height(); ++y) {
        const std::uint8_t* t = templ.row(y);
        for (std::size_t i = 0; i < templ.row_bytes(); ++i) {
            sum += t[i];
            squares += t[i] * t[i];
        }
    }
    return {static_cast<double>(templ.row_bytes()) * templ.height(), static_cast<double>(sum),
            static_cast<double>(squares)};
}

double correlation(bool remove_mean, const TemplateSums& T, double I, double II, double IT) {
    const double a = remove_mean ? T.count * II - I * I : II;
    const double b = remove_mean ? T.count * T.squares - T.sum * T.sum : T.squares;
    const double c = remove_mean ? T.count * IT - I * T.sum : IT;
    if (a <= 0.0 || b <= 0.0) {
        return 0.0;  // flat: undefined, and defined as no likeness
    }
    return std::clamp(c / std::sqrt(a * b), -1.0, 1.0);
}

double sad_at(const Image& picture, const Image& templ, int x, int y) {
    const std::size_t n = templ.row_bytes();
    const std::ptrdiff_t offset = static_cast<std::ptrdiff_t>(x) * picture.channels();
    std::int64_t total = 0;
    for (int row = 0; row < templ.height(); ++row) {
        const std::uint8_t* t = templ.row(row);
        const std::uint8_t* p = picture.row(y + row) + offset;
        int of_row = 0;
        for (std::size_t i = 0; i < n; ++i) {
            of_row += std::abs(static_cast<int>(p[i]) - static_cast<int>(t[i]));
        }
        total += of_row;
    }
    return static_cast<double>(total);
}

double correlation_at(bool remove_mean, const Image& picture, const Image& templ,
                      const TemplateSums& T, int x, int y) {
    const std::size_t n = templ.row_bytes();
    const std::ptrdiff_t offset = static_cast<std::ptrdiff_t>(x) * picture.channels();
    std::int64_t sum = 0;
    std::int64_t squares = 0;
    std::int64_t products = 0;
    for (int row = 0; row < templ.height(); ++row) {
        const std::uint8_t* t = templ.row(row);
        const std::uint8_t* p = picture.row(y + row) + offset;
        // 32 bits hold a row: 65536 pixels of 255^2 would be needed to fill them.
        std::uint32_t row_sum = 0;
        std::uint32_t row_squares = 0;
        std::uint32_t row_products = 0;
        for (std::size_t i = 0; i < n; ++i) {
            const std::uint32_t value = p[i];
            row_sum += value;
            row_squares += value * value;
            row_products += value * t[i];
        }
        sum += row_sum;
        squares += row_squares;
        products += row_products;
    }
    return correlation(remove_mean, T, static_cast<double>(sum), static_cast<double>(squares),
                       static_cast<double>(products));
}

void require_same_channels(const Image& picture, const Image& templ) {
    if (picture.channels() != templ.channels() || templ.row_bytes() > 65536) {
        throw std::invalid_argument("kambara::score_map: channels differ or template too wide");
    }
}

// The sums of one row of positions, side by side: each template pixel is met with a run of picture
// pixels, which the compiler turns into vector code. Sums of 32 bits hold 33000 pixels of 255^2;
// larger templates are added up in parts.
class RowSums {
  public:
    RowSums(const Image& picture, const Image& templ, int x0, int count)
        : picture_(picture),
          templ_(templ),
          offset_(static_cast<std::ptrdiff_t>(x0) * picture.channels()),
          step_(static_cast<std::size_t>(picture.channels())),
          width_(static_cast<std::size_t>(count) * step_ - step_ + 1),
          part_(width_),
          products_(width_),
          columns_(width_ + templ.row_bytes()),
          column_squares_(width_ + templ.row_bytes()) {}

    void compute(Measure measure, int y) {
        std::fill(products_.begin(), products_.end(), 0);
        const int rows_a_part = std::max(1, static_cast<int>(32768 / templ_.row_bytes()));
        for (int first = 0; first < templ_.height(); first += rows_a_part) {
            const int last = std::min(templ_.height(), first + rows_a_part);
            std::fill(part_.begin(), part_.end(), 0u);
            for (int row = first; row < last; ++row) {
                add_row(measure, picture_.row(y + row) + offset_, templ_.row(row));
            }
            for (std::size_t i = 0; i < width_; ++i) {
                products_[i] += part_[i];
            }
        }
        if (measure != Measure::sad) {
            add_columns(y);
        }
    }

    double score(Measure measure, const TemplateSums& T, int position) const {
        const std::size_t i = static_cast<std::size_t>(position) * step_;
        if (measure == Measure::sad) {
            return static_cast<double>(products_[i]);
        }
        // Prefix sums over the columns: the difference is the sum under the template.
        const std::size_t end = i + templ_.row_bytes();
        return correlation(measure == Measure::zncc, T,
                           static_cast<double>(columns_[end] - columns_[i]),
                           static_cast<double>(column_squares_[end] - column_squares_[i]),
                           static_cast<double>(products_[i]));
    }

  private:
    void add_row(Measure measure, const std::uint8_t* p, const std::uint8_t* t) {
        std::uint32_t* sums = part_.data();
        for (std::size_t k = 0; k < templ_.row_bytes(); ++k) {
            const int value = t[k];
            const std::uint8_t* run = p + k;
            if (measure == Measure::sad) {
                for (std::size_t i = 0; i < width_; ++i) {
                    sums[i] += static_cast<std::uint32_t>(std::abs(run[i] - value));
                }
            } else {
                for (std::size_t i = 0; i < width_; ++i) {
                    sums[i] += static_cast<std::uint32_t>(run[i] * value);
                }
            }
        }
    }

    void add_columns(int y) {
        const std::size_t n = width_ + templ_.row_bytes() - 1;
        columns_[0] = 0;
        column_squares_[0] = 0;
        for (std::size_t i = 0; i < n; ++i) {
            std::int64_t sum = 0;
            std::int64_t squares = 0;
            const std::uint8_t* p = picture_.row(y) + offset_ + i;
            for (int row = 0; row < templ_.height(); ++row, p += picture_.row_bytes()) {
                sum += *p;
                squares += *p * *p;
            }
            columns_[i + 1] = columns_[i] + sum;
            column_squares_[i + 1] = column_squares_[i] + squares;
        }
    }

    const Image& picture_;
    const Image& templ_;
    const std::ptrdiff_t offset_;
    const std::size_t step_;   // from a position to the next, in bytes
    const std::size_t width_;  // bytes that a row of positions spans
    std::vector<std::uint32_t> part_;
    std::vector<std::int64_t> products_;
    std::vector<std::int64_t> columns_;
    std::vector<std::int64_t> column_squares_;
};

}  // namespace

double score_at(Measure measure, const Image& picture, const Image& templ, int x, int y) {
    require_same_channels(picture, templ);
    if (measure == Measure::sad) {
        return sad_at(picture, templ, x, y);
    }
    return correlation_at(measure == Measure::zncc, picture, templ, sums_of(templ), x, y);
}

Rectangle all_positions(const Image& picture, const Image& templ) {
    return {0, 0, std::max(0, picture.width() - templ.width() + 1),
            std::max(0, picture.height() - templ.height() + 1)};
}

ScoreMap score_map(Measure measure, const Image& picture, const Image& templ,
                   const Rectangle& positions) {
    require_same_channels(picture, templ);
    const Rectangle all = all_positions(picture, templ);
    const int x0 = std::max(positions.x, all.x);
    const int y0 = std::max(positions.y, all.y);
    const int x1 = std::min(positions.x + positions.width, all.x + all.width);
    const int y1 = std::min(positions.y + positions.height, all.y + all.height);
    ScoreMap map;
    map.positions = {x0, y0, std::max(0, x1 - x0), std::max(0, y1 - y0)};
    if (x1 <= x0 || y1 <= y0 || templ.empty()) {
        return map;
    }
    const TemplateSums sums = sums_of(templ);
    RowSums row(picture, templ, x0, x1 - x0);
    map.scores.reserve(static_cast<std::size_t>(x1 - x0) * static_cast<std::size_t>(y1 - y0));
    for (int y = y0; y < y1; ++y) {
        row.compute(measure, y);
        for (int i = 0; i < x1 - x0; ++i) {
            map.scores.push_back(static_cast<float>(row.score(measure, sums, i)));
        }
    }
    return map;
}

}  // namespace kambara
