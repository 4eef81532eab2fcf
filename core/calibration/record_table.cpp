// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/record_table.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace kambara {
namespace {

const char* const remedy =
    "Write a header line and one record a line: environment,camera,record,f_mm,...; "
    "resources/README.md has an example.";

std::string_view trimmed(std::string_view text) {
    const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
    while (!text.empty() && blank(text.front())) {
        text.remove_prefix(1);
    }
    while (!text.empty() && blank(text.back())) {
        text.remove_suffix(1);
    }
    return text;
}

std::vector<std::string_view> cells_of(std::string_view line) {
    std::vector<std::string_view> cells;
    for (;;) {
        const auto comma = line.find(',');
        cells.push_back(trimmed(line.substr(0, comma)));
        if (comma == std::string_view::npos) {
            return cells;
        }
        line.remove_prefix(comma + 1);
    }
}

std::optional<double> number_from(std::string_view word) {
    double value = 0.0;
    const auto [end, code] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (code != std::errc() || end != word.data() + word.size() || !std::isfinite(value)) {
        return std::nullopt;
    }
    return value;
}

enum class Role { environment, camera, label, parameter };

Role role_of(std::string_view column) {
    if (column == "environment") {
        return Role::environment;
    }
    if (column == "camera") {
        return Role::camera;
    }
    return column == "record" || column == "attempt" ? Role::label : Role::parameter;
}

Error fault_in(int line, const std::string& what) {
    return {"Line " + std::to_string(line) + " of the records " + what + ".", remedy};
}

// The names of the columns and what each is for.
struct Header {
    std::vector<std::string_view> columns;
    std::vector<Role> roles;
};

Result<Header> header_from(std::string_view line, RecordTable& table) {
    Header header{cells_of(line), {}};
    std::vector<std::string_view> sorted = header.columns;
    std::sort(sorted.begin(), sorted.end());
    if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) {
        return fault_in(1, "names a column twice");
    }
    for (const std::string_view column : header.columns) {
        header.roles.push_back(role_of(column));
        if (column.empty() || number_from(column)) {
            return fault_in(1, "is no header: a column has no name");
        }
        if (header.roles.back() == Role::parameter) {
            table.parameters.emplace_back(column);
        } else if (header.roles.back() == Role::label) {
            table.label_column = column;
        }
    }
    if (table.parameters.empty()) {
        return fault_in(1, "names no parameter");
    }
    return header;
}

RecordGroup& group_for(RecordTable& table, std::string_view environment, std::string_view camera) {
    const auto found =
        std::find_if(table.groups.begin(), table.groups.end(), [&](const RecordGroup& group) {
            return group.environment == environment && group.camera == camera;
        });
    if (found != table.groups.end()) {
        return *found;
    }
    table.groups.push_back({std::string(environment), std::string(camera), {}, {}});
    return table.groups.back();
}

std::optional<Error> add_record(const Header& header, std::string_view line, int number,
                                RecordTable& table) {
    const auto cells = cells_of(line);
    if (cells.size() != header.columns.size()) {
        return fault_in(number, "holds " + std::to_string(cells.size()) + " values, the header " +
                                    std::to_string(header.columns.size()));
    }
    std::string_view environment;
    std::string_view camera;
    std::string_view label;
    std::vector<double> values;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (header.roles[i] == Role::environment) {
            environment = cells[i];
        } else if (header.roles[i] == Role::camera) {
            camera = cells[i];
        } else if (header.roles[i] == Role::label) {
            label = cells[i];
        } else if (const auto value = number_from(cells[i])) {
            values.push_back(*value);
        } else {
            return fault_in(number, "holds no finite number for " + std::string(header.columns[i]));
        }
    }
    RecordGroup& group = group_for(table, environment, camera);
    group.rows.push_back(std::move(values));
    group.labels.push_back(label.empty() ? std::to_string(group.rows.size()) : std::string(label));
    return std::nullopt;
}

}  // namespace

std::optional<std::size_t> RecordTable::column(std::string_view parameter) const {
    const auto found = std::find(parameters.begin(), parameters.end(), parameter);
    if (found == parameters.end()) {
        return std::nullopt;
    }
    return static_cast<std::size_t>(found - parameters.begin());
}

Result<RecordTable> record_table_from_text(std::string_view text) {
    RecordTable table;
    std::optional<Header> header;
    int number = 0;
    while (!text.empty()) {
        ++number;
        const auto length = std::min(text.find('\n'), text.size());
        const std::string_view line = trimmed(text.substr(0, length));
        text.remove_prefix(std::min(length + 1, text.size()));
        if (line.empty()) {
            continue;
        }
        if (!header) {
            auto read = header_from(line, table);
            if (!read) {
                return read.error();
            }
            header = std::move(*read);
        } else if (const auto fault = add_record(*header, line, number, table)) {
            return *fault;
        }
    }
    if (table.groups.empty()) {
        return Error{"There are no records.", remedy};
    }
    return table;
}

std::vector<double> column_of(const RecordGroup& group, std::size_t parameter) {
    std::vector<double> values;
    for (const auto& row : group.rows) {
        values.push_back(row[parameter]);
    }
    return values;
}

std::vector<std::vector<std::size_t>> duplicates_in(const RecordGroup& group) {
    std::vector<std::vector<std::size_t>> sets;
    std::vector<bool> seen(group.rows.size(), false);
    for (std::size_t i = 0; i < group.rows.size(); ++i) {
        std::vector<std::size_t> same{i};
        for (std::size_t k = i + 1; k < group.rows.size(); ++k) {
            if (!seen[k] && group.rows[k] == group.rows[i]) {
                same.push_back(k);
                seen[k] = true;
            }
        }
        if (!seen[i] && same.size() > 1) {
            sets.push_back(std::move(same));
        }
    }
    return sets;
}

RecordGroup without_duplicates(const RecordGroup& group) {
    RecordGroup result{group.environment, group.camera, {}, {}};
    for (std::size_t i = 0; i < group.rows.size(); ++i) {
        if (std::find(result.rows.begin(), result.rows.end(), group.rows[i]) == result.rows.end()) {
            result.rows.push_back(group.rows[i]);
            result.labels.push_back(group.labels[i]);
        }
    }
    return result;
}

}  // namespace kambara
