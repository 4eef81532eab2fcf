// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/calibration/bundle.h"
#include "core/calibration/calibration_report.h"
#include "core/calibration/rig_views.h"
#include "core/calibration/target.h"
#include "core/camera/picture_size.h"

namespace kambara {

struct KnownBaseline {
    double baseline_mm = 0.0;
    double sigma_mm = 0.0;
};

struct RigCalibratorOptions {
    /// The cameras that take part; the left one always does.
    std::array<std::optional<PictureSize>, most_cameras> cameras;
    LensModel model = LensModel::brown;
    Sensor sensor;  ///< Tsai's, the same behind every lens
    /// Brown's third radial term: as given, or, where nothing is said, free if the residuals show
    /// it (narrow lenses can't tell it).
    std::optional<bool> free_k3 = {};
    bool estimate_target = false;  ///< the target's corners, too, within their deviations
    bool held_out = true;          ///< calibrate the halves and test them on each other
    int least_views = 3;
    double usable_rms_px = 0.5;             ///< above: usable, not good
    double refused_rms_px = 1.0;            ///< above: refused
    std::optional<KnownBaseline> baseline;  ///< from left to right, by tape
    Medium medium = Medium::air;
    std::optional<Rig> expected;  ///< data sheet, or an earlier calibration, in air or water
};

using CalibrationProgress = std::function<void(double share)>;

/// Calibrates one, two or three cameras from views of a target: each camera by itself, then the
/// poses between them, then all lenses, poses and views together by least squares, with the
/// covariance that follows. Corners that fit nowhere, repeated pictures, and views whose pictures
/// contradict each other are left out, with the reason. The report says how far the result can be
/// trusted. Always gives a report; a refused one says why. The same input gives the same digits.
/// Any thread.
CalibrationReport calibrate_rig(const std::vector<RigView>& views, const Target& target,
                                const RigCalibratorOptions& options, std::stop_token stop = {},
                                const CalibrationProgress& progress = {});

}  // namespace kambara
