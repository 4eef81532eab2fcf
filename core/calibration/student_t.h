// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace kambara {

/// The probability that Student's t with `degrees` > 0 of freedom is below `t`.
double student_t_probability(double t, double degrees);

/// The t below which Student's t is with `probability` in (0, 1); the inverse of the above, to
/// 1e-10 of its value. A two-sided interval of 95 % takes student_t_quantile(0.975, n - 1).
/// NaN outside the ranges.
double student_t_quantile(double probability, double degrees);

}  // namespace kambara
