// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/student_t.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace kambara {
namespace {

// The continued fraction of the incomplete beta function (Abramowitz and Stegun 26.5.8), summed
// by Lentz's method; converges quickly for x < (a + 1) / (a + b + 2).
double beta_fraction(double a, double b, double x) {
    constexpr double tiny = 1e-300;
    const auto off_zero = [](double value) { return std::abs(value) < tiny ? tiny : value; };
    double c = 1.0;
    double d = 1.0 / off_zero(1.0 - (a + b) * x / (a + 1.0));
    double sum = d;
    for (int m = 1; m < 10000; ++m) {
        const double even = m * (b - m) * x / ((a + 2.0 * m - 1.0) * (a + 2.0 * m));
        d = 1.0 / off_zero(1.0 + even * d);
        c = off_zero(1.0 + even / c);
        sum *= c * d;
        const double odd = -(a + m) * (a + b + m) * x / ((a + 2.0 * m) * (a + 2.0 * m + 1.0));
        d = 1.0 / off_zero(1.0 + odd * d);
        c = off_zero(1.0 + odd / c);
        sum *= c * d;
        if (std::abs(c * d - 1.0) < 1e-16) {
            break;
        }
    }
    return sum;
}

// ln(Gamma(a + 1/2) / Gamma(a)): for large a by its series, where the difference of two large
// logarithms would lose digits.
double log_gamma_ratio(double a) {
    if (a < 1000.0) {
        return std::lgamma(a + 0.5) - std::lgamma(a);
    }
    return 0.5 * std::log(a) - 1.0 / (8.0 * a) + 1.0 / (192.0 * a * a * a);
}

// The regularised incomplete beta function I_x(a, 1/2), x and 1 - x given apart so that neither
// loses its digits.
double incomplete_beta_half(double a, double x, double one_minus_x) {
    if (x <= 0.0) {
        return 0.0;
    }
    if (one_minus_x <= 0.0) {
        return 1.0;
    }
    const double log_x = one_minus_x < 0.5 ? std::log1p(-one_minus_x) : std::log(x);
    const double front =
        std::exp(log_gamma_ratio(a) + a * log_x) * std::sqrt(one_minus_x * std::numbers::inv_pi);
    if (x < (a + 1.0) / (a + 2.5)) {
        return front * beta_fraction(a, 0.5, x) / a;
    }
    return 1.0 - 2.0 * front * beta_fraction(0.5, a, one_minus_x);
}

// The probability beyond t >= 0.
double upper_tail(double t, double degrees) {
    const double all = degrees + t * t;
    return 0.5 * incomplete_beta_half(0.5 * degrees, degrees / all, t * t / all);
}

}  // namespace

double student_t_probability(double t, double degrees) {
    if (!(degrees > 0.0) || std::isnan(t)) {
        return std::numeric_limits<double>::quiet_NaN();
    }
    if (std::isinf(t)) {
        return t > 0.0 ? 1.0 : 0.0;
    }
    const double tail = upper_tail(std::abs(t), degrees);
    return t < 0.0 ? tail : 1.0 - tail;
}

double student_t_quantile(double probability, double degrees) {
    if (!(probability > 0.0 && probability < 1.0) || !(degrees > 0.0)) {
        return std::numeric_limits<double>::quiet_NaN();
    }
    if (probability == 0.5) {
        return 0.0;
    }
    const double tail = probability < 0.5 ? probability : 1.0 - probability;
    double low = 0.0;
    double high = 1.0;
    while (upper_tail(high, degrees) > tail && high < 1e150) {
        low = high;
        high *= 2.0;
    }
    // The tail falls steadily: halving can't fail, and is quick enough.
    for (int i = 0; i < 200 && high - low > 1e-15 * high; ++i) {
        const double middle = 0.5 * (low + high);
        (upper_tail(middle, degrees) > tail ? low : high) = middle;
    }
    const double t = 0.5 * (low + high);
    return probability < 0.5 ? -t : t;
}

}  // namespace kambara
