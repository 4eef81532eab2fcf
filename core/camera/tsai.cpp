// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/camera/lens_functions.h"

namespace kambara {
namespace {

// r (1 + kappa r^2) = r_u by the trigonometric forms of the cubic's root.
double closed_form_radius(double kappa, double r_u) {
    const double root = std::sqrt(3.0 * std::abs(kappa));
    const double argument = 1.5 * r_u * root;
    if (kappa > 0.0) {
        return 2.0 / root * std::sinh(std::asinh(argument) / 3.0);
    }
    return 2.0 / root * std::sin(std::asin(std::min(argument, 1.0)) / 3.0);
}

// A start for Newton's method. For bends up to that of a strong wide-angle lens a rational form,
// equal to the root's series to the fourth order, is within 3 % and costs no trigonometry.
double start_radius(double kappa, double r_u, double bend) {
    if (bend > -0.09 && bend < 0.5) {
        return r_u * (1.0 + 2.0 * bend) / (1.0 + 3.0 * bend);
    }
    return closed_form_radius(kappa, r_u);
}

}  // namespace

double tsai_squared_distorted_radius(double kappa, double q) {
    constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
    if (!(q >= 0.0) || !std::isfinite(kappa)) {
        return nothing;
    }
    const double bend = kappa * q;  // the distortion relative to the radius
    if (6.75 * bend < -1.0) {       // r_u > 2 / (3 sqrt(-3 kappa)), squared
        return nothing;
    }
    const double r_u = std::sqrt(q);
    double r = start_radius(kappa, r_u, bend);
    for (int i = 0; i < 8; ++i) {
        const double slope = 1.0 + 3.0 * kappa * r * r;
        if (slope < 1e-6) {
            break;  // at the turning point, where the closed form is as good as it gets
        }
        const double step = (r * (1.0 + kappa * r * r) - r_u) / slope;
        r -= step;
        if (std::abs(step) <= 1e-9 * r) {
            break;  // what is left is of the order of the step's square
        }
    }
    return r * r;
}

}  // namespace kambara
