// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/reliability.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace kambara::testing_support {

Reliability reliability_of(const std::vector<Forecast>& forecasts) {
    Reliability result;
    result.count = static_cast<int>(forecasts.size());
    if (forecasts.empty()) {
        return result;
    }
    const double all = static_cast<double>(forecasts.size());
    for (const Forecast& forecast : forecasts) {
        const double came = forecast.came_true ? 1.0 : 0.0;
        const double off = forecast.probability - came;
        result.brier_score += off * off / all;
        result.share_true += came / all;
        const double tenth = std::clamp(std::floor(10.0 * forecast.probability), 0.0, 9.0);
        ReliabilityBin& bin = result.bins[static_cast<std::size_t>(tenth)];
        bin.mean_probability += forecast.probability;
        bin.share_true += came;
        ++bin.count;
    }
    for (ReliabilityBin& bin : result.bins) {
        if (bin.count > 0) {
            bin.mean_probability /= bin.count;
            bin.share_true /= bin.count;
            result.calibration_error +=
                std::abs(bin.mean_probability - bin.share_true) * bin.count / all;
        }
    }
    return result;
}

}  // namespace kambara::testing_support
