// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/matching/transform.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <utility>
#include <vector>

#include "core/matching/kernels/transform_rows.h"

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

// The rows about the one at hand, each smoothed along once and kept while it is needed.
template <int RADIUS>
class RowsAlong {
  public:
    RowsAlong(double sigma_px, const Image& picture, const Rectangle& region)
        : weights_(gaussian_weights<RADIUS>(sigma_px)), picture_(picture), region_(region) {
        if (kept().size() < static_cast<std::size_t>(rows_kept * stride())) {
            kept().resize(static_cast<std::size_t>(rows_kept * stride()));
        }
        for (int y = -RADIUS; y < RADIUS; ++y) {
            add(y);
        }
    }

    /// The rows about y; to be asked for one row after the other.
    const std::int16_t* const* about(int y) {
        add(y + RADIUS);
        for (int j = -RADIUS; j <= RADIUS; ++j) {
            about_[static_cast<std::size_t>(j + RADIUS)] = place(y + j);
        }
        return about_.data();
    }
    const std::int16_t* weights() const { return weights_.data(); }

  private:
    static constexpr int rows_kept = 2 * RADIUS + 1;

    static std::vector<std::int16_t>& kept() {
        thread_local std::vector<std::int16_t> rows;
        return rows;
    }
    int stride() const { return region_.width + 64; }
    std::int16_t* place(int y) const { return kept().data() + (y + RADIUS) % rows_kept * stride(); }
    void add(int y) const {
        transform_rows().smooth_along(picture_.row(region_.y + y) + region_.x, weights_.data(),
                                      RADIUS, region_.width, place(y));
    }

    const std::array<std::int16_t, RADIUS + 1> weights_;
    const Image& picture_;
    const Rectangle region_;
    std::array<const std::int16_t*, rows_kept> about_{};
};

void smooth(const Image& picture, const Rectangle& region, Image& out) {
    RowsAlong<smooth_radius> rows(1.0, picture, region);
    for (int y = 0; y < region.height; ++y) {
        transform_rows().smooth_across(rows.about(y), rows.weights(), region.width, out.row(y));
    }
}

void sign_of_difference(const Image& picture, const Rectangle& region, Image& out) {
    RowsAlong<narrow_radius> less(0.8, picture, region);
    RowsAlong<wide_radius> more(1.6, picture, region);
    for (int y = 0; y < region.height; ++y) {
        transform_rows().larger_across(less.about(y), less.weights(), more.about(y), more.weights(),
                                       region.width, out.row(y));
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
                      Image& out) {
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
    const auto& rows = transform_rows();
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
            return smooth(picture, region, out);
        case Transform::sdog:
            return sign_of_difference(picture, region, out);
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
