// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>

namespace kambara {

/// A failure that a user can cause or mend. `cause` says what went wrong with the names and
/// numbers at hand; `remedy` says what to do next. Both are full sentences.
struct Error {
    std::string cause;
    std::string remedy;

    std::string text() const { return remedy.empty() ? cause : cause + " " + remedy; }
    bool operator==(const Error&) const = default;
};

}  // namespace kambara
