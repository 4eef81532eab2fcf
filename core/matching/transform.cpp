// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/matching/transform.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <utility>
#include <vector>

#include "core/matching/kernels/kernels.h"

namespace kambara {
namespace {

constexpr std::array<std::pair<Transform, const char*>, 7> names{{
    {Transform::none, "none"},
    {Transform::gaussian, "gauss"},
    {Transform::rank3, "rank3"},
    {Transform::rank5, "rank5"},
    {Transform::census, "census"},
    {Transform::sdog, "sdog"},
    {Transform::gradient, "gradient"},
}};

constexpr int smooth_radius = 3;
constexpr int narrow_radius = 2;
constexpr int wide_radius = 4;

// A Gaussian of the given sigma in whole numbers: the middle one, then to one side; the sum over
// both sides is 256.
template <int RADIUS>
std::array<std::int16_t, RADIUS + 1> gaussian_weights(double sigma_px) {
    std::array<double, RADIUS + 1> exact{};
    double sum = 0.0;
    for (std::size_t i = 0; i <= RADIUS; ++i) {
        const double t = static_cast<double>(i) / sigma_px;
        exact[i] = std::exp(-0.5 * t * t);
        sum += i == 0 ? exact[i] : 2.0 * exact[i];
    }
    std::array<std::int16_t, RADIUS + 1> weights{};
    int rest = 256;
    for (std::size_t i = RADIUS; i > 0; --i) {
        weights[i] = static_cast<std::int16_t>(std::lround(256.0 * exact[i] / sum));
        rest -= 2 * weights[i];
    }
    weights[0] = static_cast<std::int16_t>(rest);
    return weights;
}

// The rows about those at hand, RESULTS that follow each other, each smoothed along once and kept
// while it is needed.
template <int RADIUS, int RESULTS>
class RowsAlong {
  public:
    /// Rows of so many numbers.
    explicit RowsAlong(std::ptrdiff_t numbers) : stride_(whole_lines(numbers)) {
        const auto size = static_cast<std::size_t>((rows_kept + 1) * stride_);
        if (kept().size() < size) {
            kept().resize(size);
        }
    }

    /// The rows from y - RADIUS to y + results - 1 + RADIUS; to be asked for from the first on.
    /// `along` smooths the row of a number into a row of numbers.
    template <class Along>
    const std::int16_t* const* about(int y, int results, const Along& along) {
        for (; next_ < y + results + RADIUS; ++next_) {
            along(next_, place(next_));
        }
        for (int j = 0; j < results + 2 * RADIUS; ++j) {
            about_[static_cast<std::size_t>(j)] = place(y + j - RADIUS);
        }
        return about_.data();
    }

  private:
    static constexpr int rows_kept = 2 * RADIUS + RESULTS;
    static constexpr std::ptrdiff_t in_line = 32;  // of the cache, which no load should cross

    static std::ptrdiff_t whole_lines(std::ptrdiff_t numbers) {
        return (numbers + in_line - 1) / in_line * in_line;
    }
    static std::vector<std::int16_t>& kept() {
        thread_local std::vector<std::int16_t> rows;
        return rows;
    }
    std::int16_t* place(int y) const {
        const auto first = reinterpret_cast<std::uintptr_t>(kept().data()) / sizeof(std::int16_t);
        const auto skipped = static_cast<std::ptrdiff_t>((in_line - first % in_line) % in_line);
        return kept().data() + skipped + (y + RADIUS) % rows_kept * stride_;
    }

    const std::ptrdiff_t stride_;
    int next_ = -RADIUS;
    std::array<const std::int16_t*, rows_kept> about_{};
};

void smooth(const Image& picture, const Rectangle& region, const TransformRows& by, Image& out) {
    const auto weights = gaussian_weights<smooth_radius>(1.0);
    const auto along = [&](int y, std::int16_t* to) {
        by.smooth_along(picture.row(region.y + y) + region.x, weights.data(), region.width, to);
    };
    RowsAlong<smooth_radius, 1> rows(region.width);
    for (int y = 0; y < region.height; ++y) {
        by.smooth_across(rows.about(y, 1, along), weights.data(), region.width, out.row(y));
    }
}

void sign_of_difference(const Image& picture, const Rectangle& region, const TransformRows& by,
                        Image& out) {
    const TwoGaussians weights{gaussian_weights<narrow_radius>(0.8),
                               gaussian_weights<wide_radius>(1.6)};
    const auto along = [&](int y, std::int16_t* to) {
        const int readable = (picture.height() - region.y - y) * picture.width() - region.x;
        by.both_along(picture.row(region.y + y) + region.x, weights, region.width, readable,
                      (y & 1) != 0, to);
    };
    RowsAlong<wide_radius, 2> rows(2 * whole_groups(region.width));
    for (int y = 0; y < region.height; y += 2) {
        const int results = std::min(2, region.height - y);
        // Rows from the first on: what is written beyond one's end is written over by the next.
        by.larger_across(rows.about(y, results, along), false, weights, region.width, results,
                         (region.height - y) * region.width, out.row(y));
    }
}

void copy(const Image& picture, const Rectangle& region, Image& out) {
    for (int y = 0; y < region.height; ++y) {
        std::copy_n(picture.row(region.y + y) + region.x * picture.channels(), out.row_bytes(),
                    out.row(y));
    }
}

}  // namespace

Result<Transform> parse_transform(std::string_view name) {
    for (const auto& [transform, its_name] : names) {
        if (name == its_name) {
            return transform;
        }
    }
    return Error{"There is no transform \"" + std::string(name) + "\".",
                 "Choose none, gauss, rank3, rank5, census, sdog or gradient."};
}

std::string to_string(Transform transform) {
    for (const auto& [its, name] : names) {
        if (its == transform) {
            return name;
        }
    }
    return "none";
}

int margin_px(Transform transform) {
    switch (transform) {
        case Transform::none:
            break;
        case Transform::gaussian:
            return smooth_radius;
        case Transform::rank3:
        case Transform::gradient:
            return 1;
        case Transform::rank5:
        case Transform::census:
            return 2;
        case Transform::sdog:
            return wide_radius;
    }
    return 0;
}

Rectangle transformable(const Image& picture, Transform transform) {
    const int margin = margin_px(transform);
    return {margin, margin, picture.width() - 2 * margin, picture.height() - 2 * margin};
}

void transform_region(const Image& picture, const Rectangle& region, Transform transform,
                      Image& out, const TransformRows& rows) {
    const int margin = margin_px(transform);
    const Rectangle needed{region.x - margin, region.y - margin, region.width + 2 * margin,
                           region.height + 2 * margin};
    if (!needed.inside(picture.width(), picture.height()) ||
        (picture.channels() != 1 && transform != Transform::none)) {
        throw std::invalid_argument("a transform reaches out of its picture, or is one of colour");
    }
    const int channels = transform == Transform::census ? 3 : picture.channels();
    if (out.width() != region.width || out.height() != region.height ||
        out.channels() != channels) {
        out = Image(region.width, region.height, channels);
    }
    const auto by_rows = [&](auto* of_row) {
        std::array<const std::uint8_t*, 5> about{};
        for (int y = 0; y < region.height; ++y) {
            for (int j = 0; j <= 2 * margin; ++j) {
                about[static_cast<std::size_t>(j)] =
                    picture.row(region.y + y + j - margin) + region.x;
            }
            of_row(about.data(), region.width, out.row(y));
        }
    };
    switch (transform) {
        case Transform::none:
            return copy(picture, region, out);
        case Transform::gaussian:
            return smooth(picture, region, rows, out);
        case Transform::sdog:
            return sign_of_difference(picture, region, rows, out);
        case Transform::rank3:
            return by_rows(rows.rank3);
        case Transform::rank5:
            return by_rows(rows.rank5);
        case Transform::census:
            return by_rows(rows.census);
        case Transform::gradient:
            return by_rows(rows.gradient);
    }
}

}  // namespace kambara
