// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/logistic_fit.h"

#include <algorithm>
#include <cmath>

namespace kambara::testing_support {
namespace {

double loss(const LogisticSamples& samples, const Eigen::VectorXd& weights, double ridge) {
    const Eigen::ArrayXd odds = samples.features * weights;
    // log(1 + exp(x)) - y x, without overflow
    const Eigen::ArrayXd each =
        odds.max(0.0) + (1.0 + (-odds.abs()).exp()).log() - samples.outcomes.array() * odds;
    return each.sum() + 0.5 * ridge * weights.tail(weights.size() - 1).squaredNorm();
}

// The step of least 1/2 s'Hs + g's that keeps weights + s within the bounds.
Eigen::VectorXd bounded_step(const Eigen::MatrixXd& hessian, const Eigen::VectorXd& gradient,
                             const Eigen::VectorXd& weights) {
    constexpr int sweeps = 2000;
    Eigen::VectorXd step = Eigen::VectorXd::Zero(weights.size());
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        double most = 0.0;
        for (Eigen::Index i = 0; i < step.size(); ++i) {
            const double slope = gradient[i] + hessian.row(i).dot(step);
            double to = step[i] - slope / hessian(i, i);
            to = i == 0 ? to : std::max(to, -weights[i]);
            most = std::max(most, std::abs(to - step[i]));
            step[i] = to;
        }
        if (most < 1e-10) {
            break;
        }
    }
    return step;
}

}  // namespace

Eigen::VectorXd fit_logistic(const LogisticSamples& samples, double ridge) {
    constexpr int most_steps = 100;
    Eigen::VectorXd weights = Eigen::VectorXd::Zero(samples.features.cols());
    double best = loss(samples, weights, ridge);
    for (int i = 0; i < most_steps; ++i) {
        const Eigen::ArrayXd p = 1.0 / (1.0 + (-(samples.features * weights).array()).exp());
        Eigen::VectorXd pull = ridge * weights;
        pull[0] = 0.0;
        const Eigen::VectorXd gradient =
            samples.features.transpose() * (p - samples.outcomes.array()).matrix() + pull;
        const Eigen::VectorXd curvature = p * (1.0 - p);
        Eigen::MatrixXd hessian =
            samples.features.transpose() * curvature.asDiagonal() * samples.features;
        hessian.diagonal().array() += ridge;
        const Eigen::VectorXd step = bounded_step(hessian, gradient, weights);
        double share = 1.0;
        while (share > 1e-6 && loss(samples, weights + share * step, ridge) > best) {
            share *= 0.5;
        }
        weights += share * step;
        best = std::min(best, loss(samples, weights, ridge));
        if (share * step.cwiseAbs().maxCoeff() < 1e-8) {
            break;
        }
    }
    return weights;
}

}  // namespace kambara::testing_support
