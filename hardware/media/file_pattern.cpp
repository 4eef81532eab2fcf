// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cctype>
#include <cstdio>
#include <optional>
#include <string>

#include "hardware/media/picture_file.h"

namespace kambara {
namespace {

namespace fs = std::filesystem;

constexpr int longest_gap = 1000;
constexpr int last_first_number = 100000;  // a printf pattern's numbers may begin this late

// `*` stands for any run of characters, `?` for any one.
bool fits(const char* name, const char* pattern) {
    if (*pattern == '\0') {
        return *name == '\0';
    }
    if (*pattern == '*') {
        return fits(name, pattern + 1) || (*name != '\0' && fits(name + 1, pattern));
    }
    return *name != '\0' && (*pattern == '?' || *pattern == *name) && fits(name + 1, pattern + 1);
}

// Runs of digits compare by value, so that picture 9 comes before picture 10.
bool before(const std::string& a, const std::string& b) {
    std::size_t i = 0;
    std::size_t j = 0;
    const auto digit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
    while (i < a.size() && j < b.size()) {
        if (digit(a[i]) && digit(b[j])) {
            const auto run = [&digit](const std::string& text, std::size_t& at) {
                const std::size_t from = at;
                while (at < text.size() && digit(text[at])) {
                    ++at;
                }
                const std::size_t first = std::min(text.find_first_not_of('0', from), at);
                return text.substr(first, at - first);
            };
            const std::string x = run(a, i);
            const std::string y = run(b, j);
            if (x != y) {
                return x.size() != y.size() ? x.size() < y.size() : x < y;
            }
        } else if (a[i] != b[j]) {
            return a[i] < b[j];
        } else {
            ++i;
            ++j;
        }
    }
    return a.size() - i != b.size() - j ? a.size() - i < b.size() - j : a < b;
}

// Splits "left/%06d.png" into what stands before and after the number, and its width.
struct NumberForm {
    std::string before;
    std::string after;
    int width = 0;
};

std::optional<NumberForm> number_form(const std::string& pattern) {
    const auto percent = pattern.find('%');
    auto at = percent + 1;
    NumberForm form;
    while (at < pattern.size() && std::isdigit(static_cast<unsigned char>(pattern[at])) != 0 &&
           form.width < 100) {
        form.width = 10 * form.width + (pattern[at] - '0');
        ++at;
    }
    if (at >= pattern.size() || pattern[at] != 'd' || form.width > 20 ||
        pattern.find('%', at) != std::string::npos) {
        return std::nullopt;
    }
    form.before = pattern.substr(0, percent);
    form.after = pattern.substr(at + 1);
    return form;
}

fs::path numbered(const NumberForm& form, int number) {
    char digits[32];
    std::snprintf(digits, sizeof digits, "%0*d", form.width, number);
    return form.before + digits + form.after;
}

Result<std::vector<fs::path>> files_of_numbers(const std::string& pattern) {
    const auto form = number_form(pattern);
    if (!form) {
        return Error{"The pattern " + pattern + " is not understood.",
                     "Use one number form such as left/%06d.png, or left/*.png."};
    }
    std::error_code code;
    int number = 0;
    while (number <= last_first_number && !fs::exists(numbered(*form, number), code)) {
        ++number;
    }
    std::vector<fs::path> files;
    for (fs::path file = numbered(*form, number); fs::exists(file, code);
         file = numbered(*form, ++number)) {
        files.push_back(file);
    }
    for (int later = number + 1; later < number + longest_gap && !files.empty(); ++later) {
        if (fs::exists(numbered(*form, later), code)) {
            return Error{numbered(*form, number).string() +
                             " is missing: the pictures go on with " +
                             numbered(*form, later).string() + ".",
                         "Bring what is missing; or name them by *, and they are taken as they "
                         "are."};
        }
    }
    return files;
}

Result<std::vector<fs::path>> files_of_wildcard(const fs::path& pattern) {
    const fs::path folder = pattern.has_parent_path() ? pattern.parent_path() : fs::path(".");
    std::error_code code;
    if (!fs::is_directory(folder, code)) {
        return Error{"There is no folder " + folder.string() + ".", "Check the name."};
    }
    const std::string wanted = pattern.filename().string();
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder, code)) {
        const std::string name = entry.path().filename().string();
        const bool hidden = name.starts_with('.') && !wanted.starts_with('.');
        if (!hidden && fits(name.c_str(), wanted.c_str()) && entry.is_regular_file(code)) {
            files.push_back(pattern.has_parent_path() ? entry.path() : entry.path().filename());
        }
    }
    std::sort(files.begin(), files.end(), [](const fs::path& a, const fs::path& b) {
        return before(a.filename().string(), b.filename().string());
    });
    return files;
}

}  // namespace

Result<std::vector<fs::path>> files_of_pattern(const fs::path& pattern) {
    const std::string text = pattern.string();
    std::error_code code;
    if (fs::is_regular_file(pattern, code)) {
        return std::vector<fs::path>{pattern};
    }
    if (fs::is_directory(pattern, code)) {
        return Error{text + " is a folder.", "Name its pictures, for example " + text + "/*.png."};
    }
    const bool wildcard = text.find_first_of("*?") != std::string::npos;
    const bool printf_form = text.find('%') != std::string::npos;
    if (!wildcard && !printf_form) {
        return Error{"There is no file " + text + ".", "Check the name and the folder."};
    }
    auto files = wildcard ? files_of_wildcard(pattern) : files_of_numbers(text);
    if (files && files->empty()) {
        return Error{"No file fits the pattern " + text + ".",
                     "Check the folder and the pattern; on a command line, quote it."};
    }
    return files;
}

}  // namespace kambara
