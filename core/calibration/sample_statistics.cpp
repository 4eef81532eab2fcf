// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/sample_statistics.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/base/angles.h"
#include "core/calibration/student_t.h"
#include "core/geometry/rigid_transform.h"

namespace kambara {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

bool is_air(const std::string& environment) {
    return environment == "air" || environment == "laboratory";
}

bool is_water(const std::string& environment) {
    return environment == "water" || environment == "underwater";
}

// The columns of such names, all or none.
std::optional<std::vector<std::size_t>> columns(const RecordTable& table,
                                                const std::vector<std::string>& names) {
    std::vector<std::size_t> found;
    for (const std::string& name : names) {
        const auto column = table.column(name);
        if (!column) {
            return std::nullopt;
        }
        found.push_back(*column);
    }
    return found;
}

std::optional<std::vector<std::size_t>> translation_columns(const RecordTable& table,
                                                            const std::string& camera) {
    return columns(table, {"tx" + camera + "_mm", "ty" + camera + "_mm", "tz" + camera + "_mm"});
}

std::optional<std::vector<std::size_t>> rotation_columns(const RecordTable& table,
                                                         const std::string& camera) {
    std::vector<std::string> names;
    for (const char* entry : {"11", "12", "13", "21", "22", "23", "31", "32", "33"}) {
        names.push_back(std::string("r") + entry + "_" + camera);
    }
    return columns(table, names);
}

Eigen::Vector3d vector_from(const std::vector<double>& row, const std::vector<std::size_t>& at) {
    return {row[at[0]], row[at[1]], row[at[2]]};
}

Eigen::Matrix3d matrix_from(const std::vector<double>& row, const std::vector<std::size_t>& at) {
    Eigen::Matrix3d R;
    for (std::size_t i = 0; i < 9; ++i) {
        R(static_cast<Eigen::Index>(i / 3), static_cast<Eigen::Index>(i % 3)) = row[at[i]];
    }
    return R;
}

}  // namespace

SampleStatistics statistics_of(const std::vector<double>& values, std::optional<double> t) {
    SampleStatistics result;
    result.n = static_cast<int>(values.size());
    const auto n = static_cast<double>(values.size());
    result.mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
    double squares = 0.0;
    for (const double value : values) {
        squares += (value - result.mean) * (value - result.mean);
    }
    result.deviation = values.size() > 1 ? std::sqrt(squares / (n - 1.0)) : nothing;
    result.t = t ? *t : student_t_quantile(0.975, n - 1.0);
    result.half_width = result.t * result.deviation / std::sqrt(n);
    result.percentage_error =
        result.mean == 0.0 ? nothing : 200.0 * result.half_width / std::abs(result.mean);
    return result;
}

std::vector<BaselineRecord> baselines_of(const RecordTable& table, const RecordGroup& group) {
    const auto t0 = translation_columns(table, "0");
    const auto t2 = translation_columns(table, "2");
    std::vector<BaselineRecord> baselines;
    if (!t0 || !t2) {
        return baselines;
    }
    const auto r0 = rotation_columns(table, "0");
    const auto r2 = rotation_columns(table, "2");
    for (std::size_t i = 0; i < group.rows.size(); ++i) {
        const auto& row = group.rows[i];
        const Eigen::Vector3d T0 = vector_from(row, *t0);
        const Eigen::Vector3d T2 = vector_from(row, *t2);
        BaselineRecord record{group.labels[i], (T0 - T2).norm(), {}, {}};
        if (r0 && r2) {
            const Eigen::Matrix3d R0 = matrix_from(row, *r0);
            const Eigen::Matrix3d R2 = matrix_from(row, *r2);
            // As printed, to a few digits: anything worse is no rotation, and gives no baseline.
            if (is_rotation(R0, 1e-3) && is_rotation(R2, 1e-3)) {
                record.baseline_mm = (R0.transpose() * T0 - R2.transpose() * T2).norm();
                record.turn_between_deg =
                    deg_from_rad(Eigen::AngleAxisd(R0 * R2.transpose()).angle());
            }
        }
        baselines.push_back(std::move(record));
    }
    return baselines;
}

std::vector<WaterComparison> water_comparisons(const RecordTable& table, double n) {
    std::vector<WaterComparison> comparisons;
    const auto f =
        table.column("focal_length_mm") ? table.column("focal_length_mm") : table.column("f_mm");
    const auto kappa = table.column("kappa1_per_mm2");
    if (!f || !kappa) {
        return comparisons;
    }
    for (const RecordGroup& dry : table.groups) {
        const auto wet =
            std::find_if(table.groups.begin(), table.groups.end(), [&](const RecordGroup& other) {
                return is_water(other.environment) && other.camera == dry.camera;
            });
        if (!is_air(dry.environment) || wet == table.groups.end()) {
            continue;
        }
        const auto f_air = statistics_of(column_of(dry, *f));
        const auto f_water = statistics_of(column_of(*wet, *f));
        WaterComparison one;
        one.camera = dry.camera;
        one.f_ratio = f_water.mean / f_air.mean;
        one.f_ratio_half_width =
            std::abs(one.f_ratio) *
            std::hypot(f_air.half_width / f_air.mean, f_water.half_width / f_water.mean);
        one.predicted_f_ratio = n;
        one.kappa1_in_water_per_mm2 = statistics_of(column_of(*wet, *kappa)).mean;
        one.predicted_kappa1_per_mm2 = statistics_of(column_of(dry, *kappa)).mean -
                                       (1.0 - 1.0 / (n * n)) / (2.0 * f_air.mean * f_air.mean);
        comparisons.push_back(one);
    }
    return comparisons;
}

}  // namespace kambara
