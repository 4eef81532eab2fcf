// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/named_table.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

#include "core/base/text_file.h"

namespace kambara::cli {
namespace {

std::string trimmed(const std::string& text) {
    const auto first = text.find_first_not_of(" \t\r");
    const auto last = text.find_last_not_of(" \t\r");
    return first == std::string::npos ? std::string() : text.substr(first, last - first + 1);
}

std::vector<std::string> cells_of(const std::string& line) {
    std::vector<std::string> cells(1);
    bool quoted = false;
    for (const char c : line) {
        if (c == '"') {
            quoted = !quoted;
        } else if (c == ',' && !quoted) {
            cells.emplace_back();
        } else {
            cells.back() += c;
        }
    }
    for (std::string& cell : cells) {
        cell = trimmed(cell);
    }
    return cells;
}

}  // namespace

std::optional<double> NamedRow::number(const std::string& column) const {
    const auto cell = cells.find(column);
    if (cell == cells.end() || cell->second.empty()) {
        return std::nullopt;
    }
    double value = 0.0;
    const char* end = cell->second.data() + cell->second.size();
    const auto [stop, code] = std::from_chars(cell->second.data(), end, value);
    return stop == end && code == std::errc{} && std::isfinite(value) ? std::optional(value)
                                                                      : std::nullopt;
}

std::optional<Eigen::Vector2d> NamedRow::pair(const std::string& x, const std::string& y) const {
    const auto first = number(x);
    const auto second = number(y);
    return first && second ? std::optional(Eigen::Vector2d(*first, *second)) : std::nullopt;
}

std::optional<Eigen::Vector3d> NamedRow::triple(const std::string& x, const std::string& y,
                                                const std::string& z) const {
    const auto first = pair(x, y);
    const auto third = number(z);
    return first && third ? std::optional(Eigen::Vector3d(first->x(), first->y(), *third))
                          : std::nullopt;
}

bool NamedTable::has(const std::vector<std::string>& names) const {
    return std::all_of(names.begin(), names.end(), [this](const std::string& name) {
        return std::find(columns.begin(), columns.end(), name) != columns.end();
    });
}

Result<NamedTable> read_named_table(const std::filesystem::path& path,
                                    const std::vector<std::string>& must_have) {
    const auto text = read_text_file(path);
    if (!text) {
        return text.error();
    }
    NamedTable table;
    std::istringstream lines(*text);
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) {
        if (trimmed(line).empty() || trimmed(line).front() == '#') {
            continue;
        }
        const auto cells = cells_of(line);
        if (table.columns.empty()) {
            table.columns = cells;
            continue;
        }
        NamedRow row{number, {}};
        for (std::size_t i = 0; i < std::min(cells.size(), table.columns.size()); ++i) {
            row.cells[table.columns[i]] = cells[i];
        }
        table.rows.push_back(std::move(row));
    }
    for (const std::string& name : must_have) {
        if (!table.has({name})) {
            return Error{path.string() + " has no column " + name + ".",
                         "Name the columns in its first line, separated by commas."};
        }
    }
    if (table.rows.empty()) {
        return Error{path.string() + " holds no rows.", "Write one line for each."};
    }
    return table;
}

Result<std::vector<TrackedPosition>> read_track_positions(const std::filesystem::path& path) {
    const auto table = read_named_table(path, {"frame", "state", "x_mm", "y_mm", "z_mm"});
    if (!table) {
        return table.error();
    }
    std::vector<TrackedPosition> positions;
    for (const NamedRow& row : table->rows) {
        const auto frame = row.number("frame");
        const auto point = row.triple("x_mm", "y_mm", "z_mm");
        const auto state = row.cells.find("state");
        if (frame && point && state != row.cells.end() && state->second == "Tracking") {
            positions.push_back({*frame, *point});
        }
    }
    if (positions.empty()) {
        return Error{path.string() + " holds no tracked position.",
                     "Follow a target in both cameras' pictures, with a rig file."};
    }
    return positions;
}

}  // namespace kambara::cli
