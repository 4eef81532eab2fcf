// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/matching/noise.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

namespace kambara {
namespace {

constexpr double most_noise_grey = 4.0;  // cameras have less; more of it is fine texture
constexpr double rounding_variance = 1.0 / 12.0;

// What smoothing by 1 px leaves of white noise's variance: the sum of the squared weights.
constexpr double smoothed_variance = 1.0 / (4.0 * std::numbers::pi);

// The variance of a piece as it is compared.
double variance_of(const Image& picture, const Rectangle& r, Transform transform) {
    thread_local Image transformed;
    transform_region(picture, r, transform, transformed);
    double sum = 0.0;
    double squares = 0.0;
    for (int y = 0; y < r.height; ++y) {
        const std::uint8_t* row = transformed.row(y);
        for (int x = 0; x < r.width; ++x) {
            sum += row[x];
            squares += static_cast<double>(row[x]) * row[x];
        }
    }
    const double n = static_cast<double>(r.width) * r.height;
    return std::max(0.0, squares / n - sum * sum / (n * n));
}

// The share of it that is not noise.
double signal_share(const Image& picture, const Rectangle& r, Transform transform) {
    const double variance = variance_of(picture, r, transform);
    const double noise = std::min(noise_grey(picture, r), most_noise_grey);
    const double kept = transform == Transform::none ? 1.0 : smoothed_variance;
    const double of_noise =
        noise * noise * kept + (transform == Transform::none ? 0.0 : rounding_variance);
    return variance > 0.0 ? std::max(0.0, 1.0 - of_noise / variance) : 0.0;
}

bool has_room(const Image& picture, const Rectangle& r, int margin) {
    return Rectangle{r.x - margin, r.y - margin, r.width + 2 * margin, r.height + 2 * margin}
        .inside(picture.width(), picture.height());
}

}  // namespace

double noise_grey(const Image& grey, const Rectangle& r) {
    if (r.width < 3 || r.height < 3) {
        return 0.0;
    }
    long sum = 0;
    for (int y = r.y + 1; y < r.y + r.height - 1; ++y) {
        const std::uint8_t* above = grey.row(y - 1);
        const std::uint8_t* here = grey.row(y);
        const std::uint8_t* below = grey.row(y + 1);
        for (int x = r.x + 1; x < r.x + r.width - 1; ++x) {
            const int corners = above[x - 1] + above[x + 1] + below[x - 1] + below[x + 1];
            const int sides = above[x] + below[x] + here[x - 1] + here[x + 1];
            sum += std::abs(corners - 2 * sides + 4 * here[x]);
        }
    }
    const double n = static_cast<double>(r.width - 2) * (r.height - 2);
    return std::sqrt(0.5 * std::numbers::pi) * static_cast<double>(sum) / (6.0 * n);
}

double likeness_kept(const MatchMethod& method, const Image& templ, const Rectangle& inner,
                     const Image& grey, const Rectangle& place) {
    const bool holds = method.measure == Measure::zncc && (method.transform == Transform::none ||
                                                           method.transform == Transform::gaussian);
    const int margin = margin_px(method.transform);
    if (!holds || !has_room(templ, inner, margin) || !has_room(grey, place, margin)) {
        return 1.0;
    }
    const double both =
        signal_share(templ, inner, method.transform) * signal_share(grey, place, method.transform);
    return std::sqrt(both);
}

}  // namespace kambara
