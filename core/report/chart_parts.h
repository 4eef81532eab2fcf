// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace kambara {

/// The colours that series of a chart are told apart by, in this order.
inline constexpr const char* series_colours[] = {"#2f6f9f", "#c4502b", "#3f8f5f", "#8a5fa8",
                                                 "#b58900", "#5f6b75", "#c2578f", "#1aa5a5"};

/// About how wide is a text of the charts' size, px.
inline double text_width(std::size_t letters) {
    return 6.6 * static_cast<double>(letters);
}

/// Room for the labels that stand to the right of a chart, px.
template <class Series>
double legend_width(const std::vector<Series>& series) {
    std::size_t longest = 0;
    for (const Series& one : series) {
        longest = std::max(longest, one.label.size());
    }
    return 40.0 + std::max(100.0, text_width(longest));
}

/// A number for a page; never -0.
std::string fixed_text(double value, int decimals);

}  // namespace kambara
