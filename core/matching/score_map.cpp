// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/matching/score_map.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>

#include "core/matching/correlator.h"

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
    thread_local Correlator correlator;
    ScoreMap map;
    correlator.set_template(measure, templ);
    correlator.scores(picture, positions, map);
    return map;
}

}  // namespace kambara
