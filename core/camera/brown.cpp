// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/camera/brown.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "core/camera/lens_functions.h"

namespace kambara {
namespace {

constexpr double largest_radius = 12.0;

struct Radial {
    double factor;       // distorted radius / undistorted radius
    double slope;        // d(distorted radius) / d(undistorted radius)
    double denominator;  // of the rational form
};

Radial radial_at(const std::array<double, 12>& p, double r) {
    const double* k = p.data() + 4;
    const double r2 = r * r;
    const double n = 1.0 + r2 * (k[0] + r2 * (k[1] + r2 * k[4]));
    const double d = 1.0 + r2 * (k[5] + r2 * (k[6] + r2 * k[7]));
    const double n_by_r2 = k[0] + r2 * (2.0 * k[1] + r2 * 3.0 * k[4]);
    const double d_by_r2 = k[5] + r2 * (2.0 * k[6] + r2 * 3.0 * k[7]);
    const double factor_by_r2 = (n_by_r2 * d - n * d_by_r2) / (d * d);
    return {n / d, n / d + 2.0 * r2 * factor_by_r2, d};
}

bool grows_at(const std::array<double, 12>& p, double r) {
    const Radial radial = radial_at(p, r);
    return radial.denominator > 1e-6 && radial.slope > 1e-6;
}

// The radius whose distorted radius is `wanted`; the caller knows that r -> r factor(r) grows.
double undistorted_radius(const std::array<double, 12>& p, double max_radius, double wanted) {
    double low = 0.0;
    double high = max_radius;
    double r = std::min(wanted, max_radius);
    for (int i = 0; i < 60 && high - low > 1e-9 * high; ++i) {
        const Radial radial = radial_at(p, r);
        const double rest = r * radial.factor - wanted;
        (rest > 0.0 ? high : low) = r;
        const double newton = r - rest / radial.slope;
        r = newton > low && newton < high ? newton : 0.5 * (low + high);
        if (std::abs(rest) < 1e-15) {
            break;
        }
    }
    return r;
}

}  // namespace

double brown_max_radius(const std::array<double, 12>& parameters) {
    constexpr double step = 0.01;
    double r = 0.0;
    while (r < largest_radius && grows_at(parameters, r + step)) {
        r += step;
    }
    double outside = r + step;
    for (int i = 0; i < 40; ++i) {
        const double middle = 0.5 * (r + outside);
        (grows_at(parameters, middle) ? r : outside) = middle;
    }
    return std::min(r, largest_radius);
}

Eigen::Matrix2d brown_jacobian(const std::array<double, 12>& parameters,
                               const Eigen::Vector2d& at) {
    const double* k = parameters.data() + 4;
    const double x = at.x();
    const double y = at.y();
    const double r2 = x * x + y * y;
    const double n = 1.0 + r2 * (k[0] + r2 * (k[1] + r2 * k[4]));
    const double d = 1.0 + r2 * (k[5] + r2 * (k[6] + r2 * k[7]));
    const double n_by_r2 = k[0] + r2 * (2.0 * k[1] + r2 * 3.0 * k[4]);
    const double d_by_r2 = k[5] + r2 * (2.0 * k[6] + r2 * 3.0 * k[7]);
    const double factor = n / d;
    const double slope = 2.0 * (n_by_r2 * d - n * d_by_r2) / (d * d);  // d factor/dx = slope x
    Eigen::Matrix2d J;
    J(0, 0) = factor + slope * x * x + 2.0 * k[2] * y + 6.0 * k[3] * x;
    J(0, 1) = slope * x * y + 2.0 * k[2] * x + 2.0 * k[3] * y;
    J(1, 0) = J(0, 1);
    J(1, 1) = factor + slope * y * y + 6.0 * k[2] * y + 2.0 * k[3] * x;
    return J;
}

std::optional<Eigen::Vector2d> brown_undistort(const std::array<double, 12>& parameters,
                                               double max_radius,
                                               const Eigen::Vector2d& distorted) {
    const double wanted = distorted.norm();
    if (!std::isfinite(wanted)) {
        return std::nullopt;
    }
    Eigen::Vector2d at = distorted;
    if (wanted > 0.0) {
        at *= undistorted_radius(parameters, max_radius, wanted) / wanted;
    }
    double rest_norm = 0.0;
    for (int i = 0; i < 30; ++i) {
        Eigen::Vector2d result;
        brown_distort(parameters.data() + 4, at.x(), at.y(), result.data());
        const Eigen::Vector2d rest = result - distorted;
        rest_norm = rest.norm();
        if (rest_norm < 1e-15 * (1.0 + wanted)) {
            break;
        }
        const Eigen::Matrix2d J = brown_jacobian(parameters, at);
        if (std::abs(J.determinant()) < 1e-12) {
            return std::nullopt;
        }
        at -= J.inverse() * rest;
    }
    if (!(rest_norm < 1e-12 * (1.0 + wanted)) || at.norm() > max_radius) {
        return std::nullopt;
    }
    return at;
}

}  // namespace kambara
