// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/argument_checks.h"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <system_error>
#include <vector>

#include "core/image/rectangle.h"

namespace kambara::cli {
namespace {

namespace fs = std::filesystem;

CLI::Validator number_check(const std::string& what, bool (*good)(double)) {
    return CLI::Validator(
        [what, good](std::string& text) {
            char* end = nullptr;
            const double value = std::strtod(text.c_str(), &end);
            if (text.empty() || *end != '\0' || !std::isfinite(value)) {
                return "\"" + text + "\" is not a number: give " + what;
            }
            return good(value) ? std::string() : text + " is out of range: give " + what;
        },
        "");
}

bool is_output(const CLI::Option& option) {
    for (const char* name : {"out", "csv", "json", "report", "map"}) {
        if (option.check_lname(name)) {
            return true;
        }
    }
    return false;
}

fs::path resolved(const std::string& text) {
    std::error_code code;
    const fs::path path = fs::weakly_canonical(text, code);
    return code ? fs::path(text) : path;
}

}  // namespace

CLI::Validator not_negative() {
    return number_check("0 or more", [](double value) { return value >= 0.0; });
}

CLI::Validator above_zero() {
    return number_check("more than 0", [](double value) { return value > 0.0; });
}

CLI::Validator a_rectangle(bool or_auto) {
    return CLI::Validator(
        [or_auto](std::string& text) {
            if (or_auto && text == "auto") {
                return std::string();
            }
            const auto rectangle = parse_rectangle(text);
            return rectangle ? std::string() : rectangle.error().text();
        },
        "");
}

std::string clash_of_files(const CLI::App& command) {
    std::set<fs::path> read;
    std::vector<std::string> written;
    std::error_code code;
    for (const CLI::Option* option : command.get_options()) {
        for (const std::string& text : option->results()) {
            if (is_output(*option)) {
                written.push_back(text);
            } else if (fs::is_regular_file(text, code)) {
                read.insert(resolved(text));
            }
        }
    }
    std::set<fs::path> seen;
    for (const std::string& text : written) {
        if (text == "-") {
            continue;
        }
        if (read.contains(resolved(text))) {
            return text +
                   " is read by the command and would be overwritten. Name another file to "
                   "write.";
        }
        if (!seen.insert(resolved(text)).second) {
            return text + " is to be written twice. Name a file of its own for each result.";
        }
    }
    return {};
}

}  // namespace kambara::cli
