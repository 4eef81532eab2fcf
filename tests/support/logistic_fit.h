// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace kambara::testing_support {

/// Samples of a yes-or-no outcome: what speaks for it, a row each (its first column 1), and the
/// outcome, 1 or 0.
struct LogisticSamples {
    Eigen::MatrixXd features;
    Eigen::VectorXd outcomes;
};

/// The weights w of most likelihood for P(yes) = 1 / (1 + exp(-w f)), all but the first held at 0
/// or more, and drawn towards 0 as by `ridge` samples: Newton steps, each the least of its
/// quadratic within the bounds (coordinate descent).
Eigen::VectorXd fit_logistic(const LogisticSamples& samples, double ridge = 0.1);

}  // namespace kambara::testing_support
