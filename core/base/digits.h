// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <charconv>
#include <string>

namespace kambara {

/// The shortest text that reads back as the same number; a zero has no sign.
inline std::string digits(double value) {
    char text[40];
    const auto end = std::to_chars(text, text + sizeof text, value == 0.0 ? 0.0 : value).ptr;
    return {text, end};
}

}  // namespace kambara
