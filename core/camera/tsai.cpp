// SPDX-License-Identifier: GPL-3.0-or-later
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
    return 2.0 / root * std::sin(std::asin(argument) / 3.0);
}

}  // namespace

double tsai_squared_distorted_radius(double kappa, double q) {
    constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
    if (!(q >= 0.0) || !std::isfinite(kappa)) {
        return nothing;
    }
    const double r_u = std::sqrt(q);
    const double bend = kappa * q;  // the distortion relative to the radius
    if (6.75 * bend < -1.0) {       // r_u > 2 / (3 sqrt(-3 kappa)), squared
        return nothing;
    }
    double r = std::abs(bend) < 1e-12 ? r_u : closed_form_radius(kappa, r_u);
    // The closed form loses digits near the turning point and for tiny kappa: polish.
    for (int i = 0; i < 3; ++i) {
        const double slope = 1.0 + 3.0 * kappa * r * r;
        if (slope < 1e-6) {
            break;
        }
        r -= (r * (1.0 + kappa * r * r) - r_u) / slope;
    }
    return r * r;
}

}  // namespace kambara
