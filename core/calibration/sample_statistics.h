// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/calibration/record_table.h"

namespace kambara {

/// What 1999 took for t whatever the number of records: right for five.
inline constexpr double t_of_1999 = 2.776;

/// One parameter over repeated calibrations (calibration: statistics).
struct SampleStatistics {
    int n = 0;
    double mean = 0.0;
    double deviation = 0.0;         ///< n - 1; NaN for one record
    double t = 0.0;                 ///< of the two-sided 95 % interval
    double half_width = 0.0;        ///< t deviation / sqrt(n)
    double percentage_error = 0.0;  ///< 2 half_width / |mean|, %; NaN where the mean is 0
};

/// With Student's t for n - 1 degrees of freedom, or with the t given.
SampleStatistics statistics_of(const std::vector<double>& values, std::optional<double> t = {});

/// One pair of translations to the left (0) and right (2) camera and what follows from it.
struct BaselineRecord {
    std::string label;
    /// norm(T0 - T2), as 1999 printed it: the baseline only where both cameras have the same
    /// rotation.
    double norm_t0_minus_t2_mm = 0.0;
    /// norm(R0^T T0 - R2^T T2), the distance of the optical centres, where rotations are given.
    std::optional<double> baseline_mm;
    std::optional<double> turn_between_deg;  ///< between the two rotations
};

/// From the columns tx0_mm ty0_mm tz0_mm tx2_mm ty2_mm tz2_mm and, where they are there, the
/// rotations' r11_0 ... r33_0, r11_2 ... r33_2. Empty where the translations are not all there.
std::vector<BaselineRecord> baselines_of(const RecordTable& table, const RecordGroup& group);

/// One camera in air and in water, beside what a flat port makes of the first, far away:
/// f_w = n f_a and kappa1_w = kappa1_a - (1 - 1 / n^2) / (2 f_a^2) (geometry: water).
struct WaterComparison {
    std::string camera;
    double f_ratio = 0.0;
    double f_ratio_half_width = 0.0;  ///< 95 %, from both means' intervals
    double predicted_f_ratio = 0.0;
    double kappa1_in_water_per_mm2 = 0.0;
    double predicted_kappa1_per_mm2 = 0.0;
};

/// For every camera that has records in air (or laboratory) and in water (or underwater), from
/// focal_length_mm (or f_mm) and kappa1_per_mm2.
std::vector<WaterComparison> water_comparisons(const RecordTable& table, double index_of_water);

}  // namespace kambara
