// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>

namespace kambara {

/// The lens equations for any scalar: double, or an automatic differentiation type with a member
/// `a` for its value (ceres::Jet). They assume a point within the lens's range; the checked forms
/// are in lens.h. No Ceres header is needed to read this file.

inline double value_of(double x) {
    return x;
}
template <class Jet>
double value_of(const Jet& x) {
    return x.a;
}

/// Solves w (1 + kappa w)^2 = q for the smallest w >= 0, w being the squared distorted radius and
/// q the squared undistorted one (Tsai: r_u = r_d (1 + kappa r_d^2)). Exact to machine precision.
/// NaN where there is none: kappa < 0 and r_u > 2 / (3 sqrt(-3 kappa)).
double tsai_squared_distorted_radius(double kappa1_per_mm2, double squared_undistorted_mm2);

/// As above with derivatives: one Newton step from the exact root carries them (implicit function
/// theorem), without the square root that is singular on the axis.
template <class T>
T tsai_squared_distorted_radius_of(const T& kappa, const T& q) {
    const double w0 = tsai_squared_distorted_radius(value_of(kappa), value_of(q));
    const T g = w0 * (1.0 + kappa * w0) * (1.0 + kappa * w0) - q;
    const T slope = (1.0 + kappa * w0) * (1.0 + 3.0 * kappa * w0);
    return w0 - g / slope;
}

/// Pixel of the undistorted direction (x, y, 1) through Tsai's model (geometry: equations 10-24,
/// mended). parameters: f_mm, kappa1_per_mm2, cx_px, cy_px, sx; pitch: dx' and dy in mm.
template <class T>
void tsai_pixel(const T* parameters, double dx_prime_mm, double dy_mm, const T& x, const T& y,
                T* pixel) {
    const T xu = parameters[0] * x;
    const T yu = parameters[0] * y;
    const T q = xu * xu + yu * yu;
    const T w = tsai_squared_distorted_radius_of<T>(parameters[1], q);
    const T shrink = 1.0 / (1.0 + parameters[1] * w);
    pixel[0] = parameters[4] * xu * shrink / dx_prime_mm + parameters[2];
    pixel[1] = yu * shrink / dy_mm + parameters[3];
}

/// Distorts the direction (x, y, 1) by Brown and Conrady's terms in OpenCV's order
/// k1 k2 p1 p2 k3 k4 k5 k6 (the last three divide).
template <class T>
void brown_distort(const T* k, const T& x, const T& y, T* distorted) {
    const T r2 = x * x + y * y;
    const T radial = (1.0 + r2 * (k[0] + r2 * (k[1] + r2 * k[4]))) /
                     (1.0 + r2 * (k[5] + r2 * (k[6] + r2 * k[7])));
    distorted[0] = x * radial + 2.0 * k[2] * x * y + k[3] * (r2 + 2.0 * x * x);
    distorted[1] = y * radial + k[2] * (r2 + 2.0 * y * y) + 2.0 * k[3] * x * y;
}

/// Pixel of the direction (x, y, 1). parameters: fx, fy, cx, cy in px, then the eight terms.
template <class T>
void brown_pixel(const T* parameters, const T& x, const T& y, T* pixel) {
    T distorted[2];
    brown_distort(parameters + 4, x, y, distorted);
    pixel[0] = parameters[0] * distorted[0] + parameters[2];
    pixel[1] = parameters[1] * distorted[1] + parameters[3];
}

}  // namespace kambara
