// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/point_list.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

namespace kambara {
namespace {

const char* const remedy =
    "Write one point a line: x y z X Y, or x y z XL YL XR YR for two cameras.";

bool parts_numbers(char c) {
    return c == ' ' || c == '\t' || c == ',' || c == ';' || c == '\r';
}

std::vector<std::string_view> words_of(std::string_view line) {
    line = line.substr(0, line.find('#'));
    std::vector<std::string_view> words;
    std::size_t i = 0;
    while (i < line.size()) {
        if (parts_numbers(line[i])) {
            ++i;
            continue;
        }
        std::size_t end = i;
        while (end < line.size() && !parts_numbers(line[end])) {
            ++end;
        }
        words.push_back(line.substr(i, end - i));
        i = end;
    }
    return words;
}

bool number_from(std::string_view word, double& value) {
    if (word.starts_with('+')) {
        word.remove_prefix(1);
    }
    const auto [end, code] = std::from_chars(word.data(), word.data() + word.size(), value);
    return code == std::errc() && end == word.data() + word.size();
}

Error fault_in(int line, const std::string& what) {
    return {"Line " + std::to_string(line) + " of the points " + what + ".", remedy};
}

}  // namespace

Result<PointList> point_list_from_text(std::string_view text) {
    PointList list;
    std::size_t wanted = 0;
    int number = 0;
    while (!text.empty()) {
        ++number;
        const auto length = std::min(text.find('\n'), text.size());
        const auto words = words_of(text.substr(0, length));
        text.remove_prefix(std::min(length + 1, text.size()));
        if (words.empty()) {
            continue;
        }
        if (words.size() != 5 && words.size() != 7) {
            return fault_in(number, "holds " + std::to_string(words.size()) +
                                        " numbers where 5 or 7 are expected");
        }
        if (wanted != 0 && words.size() != wanted) {
            return fault_in(number, "holds " + std::to_string(words.size()) +
                                        " numbers, those before it " + std::to_string(wanted));
        }
        wanted = words.size();
        double values[7] = {};
        for (std::size_t i = 0; i < words.size(); ++i) {
            if (!number_from(words[i], values[i])) {
                return fault_in(
                    number, "holds something that is no number in place " + std::to_string(i + 1));
            }
            if (!std::isfinite(values[i])) {
                return fault_in(number, "holds a number that is not finite");
            }
        }
        const Eigen::Vector3d place(values[0], values[1], values[2]);
        list.left.push_back({place, {values[3], values[4]}});
        if (wanted == 7) {
            list.right.push_back({place, {values[5], values[6]}});
        }
        list.lines.push_back(number);
    }
    if (list.lines.empty()) {
        return Error{"There are no points.", remedy};
    }
    return list;
}

}  // namespace kambara
