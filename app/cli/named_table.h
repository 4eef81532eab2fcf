// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/base/result.h"

namespace kambara::cli {

/// A row of a table whose first line names its columns.
struct NamedRow {
    int line = 0;  ///< of the file, the header being 1
    std::map<std::string, std::string> cells;

    std::optional<double> number(const std::string& column) const;
    std::optional<Eigen::Vector2d> pair(const std::string& x, const std::string& y) const;
    std::optional<Eigen::Vector3d> triple(const std::string& x, const std::string& y,
                                          const std::string& z) const;
};

struct NamedTable {
    std::vector<std::string> columns;
    std::vector<NamedRow> rows;

    bool has(const std::vector<std::string>& names) const;
};

/// Reads a comma-separated table; # begins a comment line. Refuses a file without rows, and one
/// without a column that must be there. Text in quotes keeps its commas.
Result<NamedTable> read_named_table(const std::filesystem::path& path,
                                    const std::vector<std::string>& must_have);

/// Positions of a track table's tracked rows, in the left camera's frame.
struct TrackedPosition {
    double frame = 0.0;
    Eigen::Vector3d point_in_left_mm = Eigen::Vector3d::Zero();
};
Result<std::vector<TrackedPosition>> read_track_positions(const std::filesystem::path& path);

}  // namespace kambara::cli
