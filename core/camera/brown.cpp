// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/camera/brown.h"

#include <algorithm>
#include <cmath>

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

struct Direction {
    Eigen::Vector2d distorted;
    Eigen::Matrix2d by_undistorted;
};

Direction distorted_at(const std::array<double, 12>& p, const Eigen::Vector2d& at) {
    const double* k = p.data() + 4;
    const double x = at.x();
    const double y = at.y();
    const double r2 = x * x + y * y;
    const double inverse_d = 1.0 / (1.0 + r2 * (k[5] + r2 * (k[6] + r2 * k[7])));
    const double factor = (1.0 + r2 * (k[0] + r2 * (k[1] + r2 * k[4]))) * inverse_d;
    const double n_by_r2 = k[0] + r2 * (2.0 * k[1] + r2 * 3.0 * k[4]);
    const double d_by_r2 = k[5] + r2 * (2.0 * k[6] + r2 * 3.0 * k[7]);
    const double slope = 2.0 * (n_by_r2 - factor * d_by_r2) * inverse_d;  // d factor/dx = slope x
    Direction result;
    result.distorted << x * factor + 2.0 * k[2] * x * y + k[3] * (r2 + 2.0 * x * x),
        y * factor + k[2] * (r2 + 2.0 * y * y) + 2.0 * k[3] * x * y;
    Eigen::Matrix2d& J = result.by_undistorted;
    J(0, 0) = factor + slope * x * x + 2.0 * k[2] * y + 6.0 * k[3] * x;
    J(0, 1) = slope * x * y + 2.0 * k[2] * x + 2.0 * k[3] * y;
    J(1, 0) = J(0, 1);
    J(1, 1) = factor + slope * y * y + 6.0 * k[2] * y + 2.0 * k[3] * x;
    return result;
}

// Newton's method from `at`; empty where it does not arrive inside `max_radius`.
std::optional<Eigen::Vector2d> undistorted_from(const std::array<double, 12>& p, double max_radius,
                                                const Eigen::Vector2d& distorted,
                                                Eigen::Vector2d at) {
    for (int i = 0; i < 12; ++i) {
        const Direction now = distorted_at(p, at);
        const Eigen::Vector2d rest = distorted - now.distorted;
        const Eigen::Matrix2d& J = now.by_undistorted;
        const double determinant = J(0, 0) * J(1, 1) - J(0, 1) * J(1, 0);
        const Eigen::Vector2d step = Eigen::Vector2d(J(1, 1) * rest.x() - J(0, 1) * rest.y(),
                                                     J(0, 0) * rest.y() - J(1, 0) * rest.x()) /
                                     determinant;
        at += step;
        const double size = at.norm();
        if (!(size <= 2.0 * max_radius)) {
            return std::nullopt;
        }
        // What is left after a step is of the order of its square: nothing, in double precision.
        if (step.norm() <= 1e-9 * (1.0 + size)) {
            return determinant > 0.0 && size <= max_radius ? std::optional(at) : std::nullopt;
        }
    }
    return std::nullopt;
}

// The radius whose distorted radius is `wanted`; the caller knows that r -> r factor(r) grows.
double undistorted_radius(const std::array<double, 12>& p, double max_radius, double wanted) {
    double low = 0.0;
    double high = max_radius;
    double r = std::min(wanted, max_radius);
    double last_step = high;
    for (int i = 0; i < 100; ++i) {
        const Radial radial = radial_at(p, r);
        const double rest = r * radial.factor - wanted;
        (rest > 0.0 ? high : low) = r;
        const double newton = r - rest / radial.slope;
        // Newton's step where it stays inside and gains on the last one; else half the interval.
        const bool good =
            newton >= low && newton <= high && std::abs(newton - r) < 0.5 * std::abs(last_step);
        const double next = good ? newton : 0.5 * (low + high);
        last_step = next - r;
        r = next;
        if (std::abs(last_step) <= 1e-12 * r) {
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
    return distorted_at(parameters, at).by_undistorted;
}

std::optional<Eigen::Vector2d> brown_undistort(const std::array<double, 12>& parameters,
                                               double max_radius,
                                               const Eigen::Vector2d& distorted) {
    const double wanted = distorted.norm();
    if (!std::isfinite(wanted)) {
        return std::nullopt;
    }
    // Ordinary lenses are solved from the distorted direction itself in a few steps; the radial
    // solution is the start for those that bend so much that this fails.
    if (auto found = undistorted_from(parameters, max_radius, distorted, distorted)) {
        return found;
    }
    if (wanted == 0.0) {
        return std::nullopt;
    }
    const double radius = undistorted_radius(parameters, max_radius, wanted);
    return undistorted_from(parameters, max_radius, distorted, distorted * (radius / wanted));
}

}  // namespace kambara
