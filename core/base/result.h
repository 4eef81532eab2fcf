// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <utility>
#include <variant>

#include "core/base/error.h"

namespace kambara {

/// The value of a command that has nothing to give back.
struct Done {
    bool operator==(const Done&) const = default;
};

/// Either a value or the error that prevented it. Asking for the side that is not there is a
/// broken invariant and throws std::logic_error.
template <class T>
class [[nodiscard]] Result {
  public:
    // Implicit on purpose: `return value;` and `return Error{...};` both read naturally.
    Result(T value) : content_(std::in_place_index<0>, std::move(value)) {}
    Result(Error error) : content_(std::in_place_index<1>, std::move(error)) {}

    bool ok() const { return content_.index() == 0; }
    explicit operator bool() const { return ok(); }

    T& value() & {
        require(ok());
        return std::get<0>(content_);
    }
    const T& value() const& {
        require(ok());
        return std::get<0>(content_);
    }
    T&& value() && {
        require(ok());
        return std::get<0>(std::move(content_));
    }
    const Error& error() const {
        require(!ok());
        return std::get<1>(content_);
    }

    T& operator*() & { return value(); }
    const T& operator*() const& { return value(); }
    T&& operator*() && { return std::move(*this).value(); }
    T* operator->() { return &value(); }
    const T* operator->() const { return &value(); }

  private:
    static void require(bool condition) {
        if (!condition) {
            throw std::logic_error("kambara::Result: the side asked for is not there");
        }
    }

    std::variant<T, Error> content_;
};

}  // namespace kambara
