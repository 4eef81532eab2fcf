// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace kambara {

/// The marks of a chart's axis: 1, 2 or 5 times a power of ten apart, around all of the values.
struct ChartAxis {
    double from = 0.0;
    double to = 1.0;
    double step = 0.2;
    int decimals = 1;  ///< that tell its marks apart

    /// Where a value lies, from 0 to 1.
    double share(double value) const { return (value - from) / (to - from); }
    std::vector<double> marks() const;
};

/// Where `most` is no more than `least`, one with some room about it.
ChartAxis axis_of(double least, double most);

}  // namespace kambara
