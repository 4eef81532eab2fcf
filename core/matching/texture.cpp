// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/matching/texture.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <string>

#include "core/matching/noise.h"
#include "core/matching/score_map.h"

namespace kambara {
namespace {

constexpr int smallest_side_px = 7;
// Texture is what noise can't be: more than it by as much as its own scatter may well make of it.
constexpr double least_contrast_grey = 0.8;
constexpr double least_gradient_grey_px = 0.15;
constexpr double least_noise_grey = 0.5;        // rounding's, and something of compression's
constexpr double noise_in_contrast = 1 / 9.0;   // of its variance, in a 3 x 3 mean
constexpr double noise_in_gradient = 1 / 27.0;  // likewise, in a central difference of such means

double clamped(const Image& grey, int x, int y) {
    return grey.at(std::clamp(x, 0, grey.width() - 1), std::clamp(y, 0, grey.height() - 1));
}

double mean_3x3(const Image& grey, int x, int y) {
    double sum = 0.0;
    for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
            sum += clamped(grey, x + dx, y + dy);
        }
    }
    return sum / 9.0;
}

double weaker_eigenvalue(const Eigen::Matrix2d& symmetric) {
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(symmetric, Eigen::EigenvaluesOnly)
        .eigenvalues()[0];
}

// Whether a mean square over n pixels is more than the noise in it, beyond doubt and by enough. Of
// the n only one in `alike` counts, neighbours having noise in common.
bool stands_out(double mean_square, double of_noise, double least, double n, double alike) {
    constexpr double deviations = 5.0;
    const double scatter = of_noise * std::max(1.0, deviations * std::sqrt(2.0 * alike / n));
    return mean_square - of_noise >= std::max(least * least, scatter);
}

// Zero-mean correlation of a part of a template; 0 over a flat patch.
double likeness_of(const Image& grey, const Image& templ, const Rectangle& inner, int x0, int y0) {
    double n = 0.0, I = 0.0, T = 0.0, II = 0.0, TT = 0.0, IT = 0.0;
    for (int y = 0; y < inner.height; ++y) {
        for (int x = 0; x < inner.width; ++x) {
            const double i = grey.at(x0 + x, y0 + y);
            const double t = templ.at(inner.x + x, inner.y + y);
            n += 1.0;
            I += i;
            T += t;
            II += i * i;
            TT += t * t;
            IT += i * t;
        }
    }
    const double of_both = (n * II - I * I) * (n * TT - T * T);
    return of_both > 0.0 ? (n * IT - I * T) / std::sqrt(of_both) : 0.0;
}

}  // namespace

Texture texture_of(const Image& grey, const Rectangle& r) {
    double sum = 0.0;
    double squares = 0.0;
    Eigen::Matrix2d gradients = Eigen::Matrix2d::Zero();
    for (int y = r.y; y < r.y + r.height; ++y) {
        for (int x = r.x; x < r.x + r.width; ++x) {
            const double value = mean_3x3(grey, x, y);
            sum += value;
            squares += value * value;
            const Eigen::Vector2d g(0.5 * (mean_3x3(grey, x + 1, y) - mean_3x3(grey, x - 1, y)),
                                    0.5 * (mean_3x3(grey, x, y + 1) - mean_3x3(grey, x, y - 1)));
            gradients += g * g.transpose();
        }
    }
    const double n = static_cast<double>(r.width) * r.height;
    const double mean = sum / n;
    return {std::sqrt(std::max(0.0, squares / n - mean * mean)),
            std::sqrt(std::max(0.0, weaker_eigenvalue(gradients / n)))};
}

Result<Done> check_template(const Image& grey, const Rectangle& r) {
    if (!r.inside(grey.width(), grey.height())) {
        return Error{"The template " + to_string(r) + " is not inside the picture of " +
                         std::to_string(grey.width()) + " x " + std::to_string(grey.height()) +
                         " pixels.",
                     "Choose a rectangle that lies wholly inside."};
    }
    if (r.width < smallest_side_px || r.height < smallest_side_px) {
        return Error{"The template " + to_string(r) + " is too small to be followed.",
                     "Choose at least 7 x 7 pixels; 21 x 21 is a good size."};
    }
    if (r.width > largest_template_px || r.height > largest_template_px) {
        return Error{"The template " + to_string(r) + " is too large to be followed.",
                     "Choose at most 255 x 255 pixels; 31 x 31 is a good size."};
    }
    const Texture texture = texture_of(grey, r);
    const double n = static_cast<double>(r.width) * r.height;
    const double noise = std::max(noise_grey(grey, r), least_noise_grey);
    if (!stands_out(texture.contrast_grey * texture.contrast_grey,
                    noise * noise * noise_in_contrast, least_contrast_grey, n, 9.0)) {
        return Error{"The template " + to_string(r) + " has no texture: its grey levels vary by " +
                         std::to_string(texture.contrast_grey) + ", noise included.",
                     "Choose a piece with marks or edges, or a larger one."};
    }
    if (!stands_out(texture.weakest_gradient_grey_px * texture.weakest_gradient_grey_px,
                    noise * noise * noise_in_gradient, least_gradient_grey_px, n, 15.0)) {
        return Error{"The template " + to_string(r) +
                         " has texture in one direction only and would slide along it.",
                     "Include a corner, an end of the edge or another mark."};
    }
    return Done{};
}

Eigen::Matrix2d match_covariance_px2(const Image& grey, const Image& templ, const Rectangle& inner,
                                     int x0, int y0, double floor_px) {
    const double n = static_cast<double>(inner.width) * inner.height;
    const double likeness = likeness_of(grey, templ, inner, x0, y0);
    double sum = 0.0;
    double squares = 0.0;
    Eigen::Matrix2d gradients = Eigen::Matrix2d::Zero();
    for (int y = y0; y < y0 + inner.height; ++y) {
        for (int x = x0; x < x0 + inner.width; ++x) {
            const double value = grey.at(x, y);
            sum += value;
            squares += value * value;
            const Eigen::Vector2d g(0.5 * (clamped(grey, x + 1, y) - clamped(grey, x - 1, y)),
                                    0.5 * (clamped(grey, x, y + 1) - clamped(grey, x, y - 1)));
            gradients += g * g.transpose();
        }
    }
    const double variance = std::max(0.0, squares / n - sum * sum / (n * n));
    const double residual = std::max(0.0, 1.0 - likeness * likeness) * variance + 1.0 / 12.0;
    const Eigen::Matrix2d floor = floor_px * floor_px * Eigen::Matrix2d::Identity();
    if (weaker_eigenvalue(gradients) < 1e-6 * n) {
        return Eigen::Matrix2d::Identity() + floor;  // slides freely: known to a pixel or so
    }
    const double a = gradients(0, 0);
    const double b = gradients(0, 1);
    const double d = gradients(1, 1);
    Eigen::Matrix2d inverse;
    inverse << d, -b, -b, a;
    return residual / (a * d - b * b) * inverse + floor;
}

}  // namespace kambara
