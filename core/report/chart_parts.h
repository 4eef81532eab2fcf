// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace kambara {

/// The colours that series of a chart are told apart by, in this order.
inline constexpr const char* series_colours[] = {"#2f6f9f", "#c4502b", "#3f8f5f", "#8a5fa8",
                                                 "#b58900", "#5f6b75", "#c2578f", "#1aa5a5"};

/// A number for a page; never -0.
std::string fixed_text(double value, int decimals);

}  // namespace kambara
