// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace kambara {

/// The records of one environment and camera.
struct RecordGroup {
    std::string environment;  ///< empty where the table has no such column
    std::string camera;
    std::vector<std::string> labels;        ///< of the records; their number from 1 where not given
    std::vector<std::vector<double>> rows;  ///< a record each, as many values as parameters
};

/// Repeated calibrations as a table (resources/README.md: calibration records).
struct RecordTable {
    std::string label_column;             ///< record or attempt
    std::vector<std::string> parameters;  ///< the columns that hold numbers
    std::vector<RecordGroup> groups;      ///< in the order of their first records

    std::optional<std::size_t> column(std::string_view parameter) const;
};

/// Reads comma-separated text with a header line: the columns environment and camera make groups,
/// record (or attempt) names a record, all others are parameters. Refuses, naming the line, what
/// is missing, superfluous, no number or not finite. Any bytes are safe to pass.
Result<RecordTable> record_table_from_text(std::string_view text);

/// The values of one parameter.
std::vector<double> column_of(const RecordGroup& group, std::size_t parameter);

/// Records that are identical in every parameter, as sets of two or more row indices.
std::vector<std::vector<std::size_t>> duplicates_in(const RecordGroup& group);

/// The group with each set of duplicates reduced to its first.
RecordGroup without_duplicates(const RecordGroup& group);

}  // namespace kambara
