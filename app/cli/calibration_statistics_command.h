// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "app/cli/outcome.h"

namespace kambara::cli {

struct CalibrationStatisticsOptions {
    std::filesystem::path records;  ///< a CSV (resources/README.md: calibration records)
    double index_of_water = 1.333;
};

/// Repeated calibrations compared. JSON: groups[{environment, camera, records, duplicates,
/// parameters{NAME{n, mean, deviation, t, half_width, lower, upper, percentage_error, with_t_2_776,
/// without_duplicates}}, baselines, baseline_statistics}], air_and_water[]. What can't be told
/// (a deviation of one record) is null.
Outcome run_calibration_statistics(const CalibrationStatisticsOptions& options);

}  // namespace kambara::cli
