// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

namespace kambara::testing_support {

/// A probability that something would be so, and whether it was.
struct Forecast {
    double probability = 0.0;
    bool came_true = false;
};

struct ReliabilityBin {
    double mean_probability = 0.0;
    double share_true = 0.0;
    int count = 0;
};

/// How far forecasts can be trusted: by tenths of the probability, what was forecast beside what
/// came true.
struct Reliability {
    std::array<ReliabilityBin, 10> bins;
    /// The mean distance between the two, weighted by the bins' counts (Naeini, Cooper & Hauskrecht
    /// 2015: expected calibration error).
    double calibration_error = 0.0;
    /// Mean squared distance of the forecasts from what came true, 1 or 0 (Brier 1950).
    double brier_score = 0.0;
    double share_true = 0.0;
    int count = 0;
};

Reliability reliability_of(const std::vector<Forecast>& forecasts);

}  // namespace kambara::testing_support
