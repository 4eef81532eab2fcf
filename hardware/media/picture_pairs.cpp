// SPDX-License-Identifier: GPL-3.0-or-later
#include "hardware/media/picture_pairs.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdint>
#include <optional>
#include <string>

namespace kambara {
namespace {

namespace fs = std::filesystem;

std::optional<std::int64_t> last_number(const fs::path& file) {
    const std::string name = file.stem().string();
    const auto is_digit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
    const auto end = std::find_if(name.rbegin(), name.rend(), is_digit).base();
    auto begin = end;
    while (begin != name.begin() && is_digit(*std::prev(begin))) {
        --begin;
    }
    std::int64_t number = 0;
    const std::string digits(begin, end);
    const auto [rest, fault] =
        std::from_chars(digits.data(), digits.data() + digits.size(), number);
    return fault == std::errc() ? std::optional(number) : std::nullopt;
}

std::vector<std::int64_t> numbers_of(const std::vector<fs::path>& files) {
    std::vector<std::int64_t> numbers;
    for (const fs::path& file : files) {
        if (const auto number = last_number(file)) {
            numbers.push_back(*number);
        }
    }
    return numbers.size() == files.size() ? numbers : std::vector<std::int64_t>{};
}

}  // namespace

Result<Done> check_pairs(const std::vector<fs::path>& left, const std::vector<fs::path>& right) {
    const auto on_left = numbers_of(left);
    const auto on_right = numbers_of(right);
    const std::size_t pairs = std::min(on_left.size(), on_right.size());
    std::size_t odd = pairs;  // the first that differs
    bool apart_by_the_same = left.size() == right.size();
    for (std::size_t i = pairs; i-- > 0;) {
        apart_by_the_same &= on_right[i] - on_left[i] == on_right[0] - on_left[0];
        odd = on_left[i] != on_right[i] ? i : odd;
    }
    if (odd == pairs || apart_by_the_same) {
        return Done{};
    }
    const auto holds = [](const std::vector<std::int64_t>& numbers, std::int64_t number) {
        return std::find(numbers.begin(), numbers.end(), number) != numbers.end();
    };
    const bool one_series =
        odd > 0 || holds(on_right, on_left[odd]) || holds(on_left, on_right[odd]);
    if (!one_series) {
        return Done{};
    }
    const fs::path& lone = on_left[odd] < on_right[odd] ? left[odd] : right[odd];
    return Error{left[odd].string() + " would be taken together with " + right[odd].string() +
                     ": " + lone.string() + " has no partner.",
                 "Bring its partner, or take it away."};
}

}  // namespace kambara
