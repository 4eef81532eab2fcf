// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "core/calibration/bundle.h"
#include "core/calibration/calibration_report.h"
#include "core/calibration/rig_calibrator.h"

namespace kambara {

/// A baseline farther off the tape's than this many deviations of both is refused.
inline constexpr double most_pull = 4.0;

/// The distance of a camera's centre from the first one's, and its deviation, mm.
std::pair<double, double> baseline_of(const Bundle& bundle, const BundleCovariance& covariance,
                                      std::size_t camera);

/// What the adjusted bundle says, for the report: cameras, pairs, residuals, coverage, range errors
/// and the rig. `places`: of the bundle's cameras among camera_names; `numbers`: of its views.
void fill_report(const Bundle& bundle, const BundleCovariance& covariance,
                 const std::vector<std::size_t>& places, const std::vector<std::size_t>& numbers,
                 const RigCalibratorOptions& options, CalibrationReport& report);

/// Holds the numbers of the report against what a trustworthy calibration has, and sets verdict,
/// reasons and notes.
void judge(const Target& target, const RigCalibratorOptions& options, CalibrationReport& report);

}  // namespace kambara
