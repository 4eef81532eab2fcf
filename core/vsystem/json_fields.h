// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace kambara::json_fields {

using Json = nlohmann::json;

/// Reading inside this folder throws a Fault, which the outer functions turn into an Error.
struct Fault {
    std::string what;
};

inline const Json& field(const Json& object, const char* key) {
    if (!object.is_object() || !object.contains(key)) {
        throw Fault{std::string("\"") + key + "\" is missing"};
    }
    return object.at(key);
}

template <class T>
T get(const Json& object, const char* key) {
    const Json& value = field(object, key);
    bool fits = false;
    if constexpr (std::is_same_v<T, bool>) {
        fits = value.is_boolean();
    } else if constexpr (std::is_same_v<T, std::string>) {
        fits = value.is_string();
    } else if constexpr (std::is_integral_v<T>) {
        // Anything that the type can't hold is refused rather than wrapped.
        fits = value.is_number_integer() &&
               (value.is_number_unsigned()
                    ? value.get<std::uint64_t>() <=
                          static_cast<std::uint64_t>(std::numeric_limits<T>::max())
                    : std::is_signed_v<T> &&
                          value.get<std::int64_t>() >=
                              static_cast<std::int64_t>(std::numeric_limits<T>::min()));
    } else {
        fits = value.is_number();
    }
    if (!fits) {
        throw Fault{std::string("\"") + key + "\" has the wrong type"};
    }
    return value.get<T>();
}

/// Empty where the key is missing.
template <class T>
std::optional<T> get_optional(const Json& object, const char* key) {
    return object.contains(key) ? std::optional<T>(get<T>(object, key)) : std::nullopt;
}

template <class T>
void put_optional(Json& object, const char* key, const std::optional<T>& value) {
    if (value) {
        object[key] = *value;
    }
}

template <int Rows>
Json from_vector(const Eigen::Matrix<double, Rows, 1>& v) {
    Json list = Json::array();
    for (int i = 0; i < Rows; ++i) {
        list.push_back(v[i]);
    }
    return list;
}

template <int Rows>
Eigen::Matrix<double, Rows, 1> get_vector(const Json& object, const char* key) {
    const Json& list = field(object, key);
    if (!list.is_array() || list.size() != Rows) {
        throw Fault{std::string("\"") + key + "\" is not a list of " + std::to_string(Rows)};
    }
    Eigen::Matrix<double, Rows, 1> v;
    for (int i = 0; i < Rows; ++i) {
        const Json& value = list.at(static_cast<std::size_t>(i));
        if (!value.is_number()) {
            throw Fault{std::string("\"") + key + "\" holds something other than numbers"};
        }
        v[i] = value.get<double>();
    }
    return v;
}

/// On one line; bytes that are not UTF-8 (a path's, say) are replaced rather than thrown at.
inline std::string text_of(const Json& json) {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// Parses the text and reads it; whatever is wrong becomes an Error that names it.
template <class Read>
auto read_text(std::string_view text, const char* kind, Read read)
    -> Result<decltype(read(Json()))> {
    const char* remedy = "Check that both ends are of the same version.";
    const Json json = Json::parse(text, nullptr, /*allow_exceptions=*/false);
    if (json.is_discarded()) {
        return Error{std::string("The ") + kind + " is not valid JSON.", remedy};
    }
    try {
        return read(json);
    } catch (const Fault& fault) {
        return Error{std::string("The ") + kind + " can't be read: " + fault.what + ".", remedy};
    }
}

}  // namespace kambara::json_fields
