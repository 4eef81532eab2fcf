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

constexpr int narrow_radius = 3;
constexpr int wide_radius = 6;

// A Gaussian of the given sigma in whole numbers: the middle one, then to one side; the sum over
// both sides is 256.
template <int RADIUS>
std::array<std::uint16_t, RADIUS + 1> gaussian_weights(double sigma_px) {
    std::array<double, RADIUS + 1> exact{};
    double sum = 0.0;
    for (std::size_t i = 0; i <= RADIUS; ++i) {
        const double t = static_cast<double>(i) / sigma_px;
        exact[i] = std::exp(-0.5 * t * t);
        sum += i == 0 ? exact[i] : 2.0 * exact[i];
    }
    std::array<std::uint16_t, RADIUS + 1> weights{};
    int rest = 256;
    for (std::size_t i = RADIUS; i > 0; --i) {
        weights[i] = static_cast<std::uint16_t>(std::lround(256.0 * exact[i] / sum));
        rest -= 2 * weights[i];
    }
    weights[0] = static_cast<std::uint16_t>(rest);
    return weights;
}

const std::array<std::uint16_t, narrow_radius + 1>& narrow() {
    static const auto weights = gaussian_weights<narrow_radius>(1.0);
    return weights;
}
const std::array<std::uint16_t, wide_radius + 1>& wide() {
    static const auto weights = gaussian_weights<wide_radius>(2.0);
    return weights;
}

// Rows smoothed along, as far up and down as the smoothing across needs, then across: row after
// row of sums that are 65536 times the grey level.
class Smoother {
  public:
    Smoother(const Image& picture, const Rectangle& region, const std::uint16_t* weights,
             int radius)
        : weights_(weights), radius_(radius), width_(region.width) {
        const auto& rows = transform_rows();
        along_.resize(static_cast<std::size_t>(region.width) *
                      static_cast<std::size_t>(region.height + 2 * radius));
        sums_.resize(static_cast<std::size_t>(region.width));
        for (int y = -radius; y < region.height + radius; ++y) {
            rows.smooth_along(picture.row(region.y + y) + region.x, weights, radius, region.width,
                              along_.data() + (y + radius) * region.width);
        }
    }

    const std::uint32_t* row(int y) {
        std::array<const std::uint16_t*, 2 * wide_radius + 1> about{};
        for (int j = 0; j <= 2 * radius_; ++j) {
            about[static_cast<std::size_t>(j)] = along_.data() + (y + j) * width_;
        }
        transform_rows().smooth_across(about.data(), weights_, radius_, width_, sums_.data());
        return sums_.data();
    }

  private:
    const std::uint16_t* weights_;
    int radius_;
    int width_;
    std::vector<std::uint16_t> along_;
    std::vector<std::uint32_t> sums_;
};

void smooth(const Image& picture, const Rectangle& region, Image& out) {
    Smoother smoother(picture, region, narrow().data(), narrow_radius);
    for (int y = 0; y < region.height; ++y) {
        const std::uint32_t* sums = smoother.row(y);
        std::uint8_t* to = out.row(y);
        for (int x = 0; x < region.width; ++x) {
            to[x] = static_cast<std::uint8_t>((sums[x] + 32768U) >> 16U);
        }
    }
}

void sign_of_difference(const Image& picture, const Rectangle& region, Image& out) {
    Smoother less(picture, region, narrow().data(), narrow_radius);
    Smoother more(picture, region, wide().data(), wide_radius);
    for (int y = 0; y < region.height; ++y) {
        const std::uint32_t* a = less.row(y);
        const std::uint32_t* b = more.row(y);
        std::uint8_t* to = out.row(y);
        for (int x = 0; x < region.width; ++x) {
            to[x] = a[x] > b[x] ? 1 : 0;
        }
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
            return narrow_radius;
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
