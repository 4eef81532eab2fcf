// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/chart_axis.h"

#include <algorithm>
#include <cmath>

namespace kambara {

std::vector<double> ChartAxis::marks() const {
    std::vector<double> all;
    for (double mark = from; mark < to + 0.5 * step; mark += step) {
        all.push_back(mark);
    }
    return all;
}

ChartAxis axis_of(double least, double most) {
    if (!(most > least)) {
        const double room = std::max(1e-3, 0.1 * std::abs(least));
        return axis_of(least - room, most + room);
    }
    const double rough = (most - least) / 5.0;
    const double power = std::pow(10.0, std::floor(std::log10(rough)));
    const double ratio = rough / power;
    ChartAxis axis;
    axis.step = power * (ratio <= 1.0 ? 1.0 : ratio <= 2.0 ? 2.0 : ratio <= 5.0 ? 5.0 : 10.0);
    axis.from = axis.step * std::floor(least / axis.step + 1e-9);
    axis.to = axis.step * std::ceil(most / axis.step - 1e-9);
    axis.decimals = std::clamp(static_cast<int>(-std::floor(std::log10(axis.step) + 1e-9)), 0, 6);
    return axis;
}

}  // namespace kambara
