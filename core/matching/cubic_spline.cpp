// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/matching/cubic_spline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace kambara {
namespace {

using Four = std::array<double, 4>;

// The four basis functions that reach a place a fraction t beyond a sample, and their slopes.
Four weights(double t) {
    const double s = 1.0 - t;
    return {s * s * s / 6.0, (4.0 - 6.0 * t * t + 3.0 * t * t * t) / 6.0,
            (4.0 - 6.0 * s * s + 3.0 * s * s * s) / 6.0, t * t * t / 6.0};
}
Four slopes(double t) {
    const double s = 1.0 - t;
    return {-0.5 * s * s, -2.0 * t + 1.5 * t * t, 2.0 * s - 1.5 * s * s, 0.5 * t * t};
}

int mirrored(int i, int n) {
    if (n == 1) {
        return 0;
    }
    const int period = 2 * (n - 1);
    i = std::abs(i) % period;
    return i < n ? i : period - i;
}

// Samples to coefficients along one line, in place: the inverse of the filter (1, 4, 1) / 6.
void filter(double* line, int n, std::ptrdiff_t step) {
    if (n < 2) {
        return;
    }
    const double pole = std::sqrt(3.0) - 2.0;
    const int reach = std::min(n - 1, 28);  // beyond, the pole's power is below the rounding
    double sum = line[0];
    double power = pole;
    for (int i = 1; i <= reach; ++i, power *= pole) {
        sum += power * line[mirrored(i, n) * step];
    }
    line[0] = sum;
    for (int i = 1; i < n; ++i) {
        line[i * step] += pole * line[(i - 1) * step];
    }
    line[(n - 1) * step] =
        pole / (pole * pole - 1.0) * (line[(n - 1) * step] + pole * line[(n - 2) * step]);
    for (int i = n - 2; i >= 0; --i) {
        line[i * step] = pole * (line[(i + 1) * step] - line[i * step]);
    }
    for (int i = 0; i < n; ++i) {
        line[i * step] *= 6.0;
    }
}

}  // namespace

Rectangle spline_piece(const Rectangle& rectangle, const Image& picture) {
    constexpr int border_px = 8;
    const int left = std::max(0, rectangle.x - border_px);
    const int top = std::max(0, rectangle.y - border_px);
    const int right = std::min(picture.width(), rectangle.x + rectangle.width + border_px);
    const int bottom = std::min(picture.height(), rectangle.y + rectangle.height + border_px);
    return {left, top, right - left, bottom - top};
}

CubicSpline::CubicSpline(const Image& grey, const Rectangle& piece)
    : piece_(piece),
      coefficients_(static_cast<std::size_t>(piece.width) *
                    static_cast<std::size_t>(piece.height)) {
    for (int y = 0; y < piece.height; ++y) {
        double* to = coefficients_.data() + y * piece.width;
        for (int x = 0; x < piece.width; ++x) {
            to[x] = grey.at(piece.x + x, piece.y + y);
        }
        filter(to, piece.width, 1);
    }
    for (int x = 0; x < piece.width; ++x) {
        filter(coefficients_.data() + x, piece.height, piece.width);
    }
}

template <class Weights>
double CubicSpline::sum(double x, double y, const Weights& along, const Weights& across) const {
    const int x0 = static_cast<int>(std::floor(x)) - piece_.x - 1;
    const int y0 = static_cast<int>(std::floor(y)) - piece_.y - 1;
    double total = 0.0;
    for (int j = 0; j < 4; ++j) {
        const double* row = coefficients_.data() + mirrored(y0 + j, piece_.height) * piece_.width;
        double of_row = 0.0;
        for (int i = 0; i < 4; ++i) {
            of_row += along[static_cast<std::size_t>(i)] * row[mirrored(x0 + i, piece_.width)];
        }
        total += across[static_cast<std::size_t>(j)] * of_row;
    }
    return total;
}

double CubicSpline::value(double x, double y) const {
    return sum(x, y, weights(x - std::floor(x)), weights(y - std::floor(y)));
}

CubicSpline::Gradient CubicSpline::gradient(double x, double y) const {
    const double tx = x - std::floor(x);
    const double ty = y - std::floor(y);
    return {sum(x, y, slopes(tx), weights(ty)), sum(x, y, weights(tx), slopes(ty))};
}

}  // namespace kambara
