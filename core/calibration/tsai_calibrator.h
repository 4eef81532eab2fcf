// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/calibration/seen_point.h"
#include "core/calibration/tsai_fit.h"
#include "core/calibration/tsai_refine.h"

namespace kambara {

struct TsaiOptions {
    Sensor sensor;
    double cx_px = 0.0;  ///< the centre to start from; the basic method keeps it
    double cy_px = 0.0;
    TsaiMethod method = TsaiMethod::full;
    /// The points are on one plane, which then tells all but s_x; it is kept as given here.
    bool coplanar = false;
    double sx = 1.0;
    /// One sigma of f above this share of f: the camera is called poorly determined.
    double poor_f_percent = 0.6;
};

/// What Tsai's method made of a list of points, and how far to trust it.
struct TsaiReport {
    TsaiView view;
    std::vector<int> outliers;  ///< indices of the points that were left out
    int points_used = 0;
    double sse_px2 = 0.0;  ///< squared residual lengths of the points used, summed
    double mean_error_px = 0.0;
    double max_error_px = 0.0;
    double noise_px = 0.0;  ///< deviation of one coordinate, by the residuals
    int degrees_of_freedom = 0;
    /// Of the eleven parameters in the order of tsai::Parameter; zero rows for what was held. Empty
    /// after the basic method, whose rotation comes from the linear stage and is no least-squares
    /// result.
    std::optional<TsaiMatrix> covariance;
    TsaiVector sigma = TsaiVector::Zero();
    /// Half-widths of the two-sided 95 % intervals: Student's t with the degrees of freedom.
    TsaiVector interval_95 = TsaiVector::Zero();
    /// One sigma that f can't do better than with such points and such noise, % of f.
    double f_bound_percent = 0.0;
    /// That bound is above the options' limit, or may be: its own upper 95 % limit, for the noise
    /// is only as well known as the degrees of freedom allow, is above it.
    bool poorly_determined = false;
    std::vector<std::string> reasons;  ///< for what is poorly determined
};

/// Tsai's camera from points of known place (calibration: Tsai's method): the linear stage, the
/// refinements, outliers left out, and the covariance that follows from the residuals. Refuses,
/// with the reason: fewer than 7 points, numbers that are not finite, a point given twice, points
/// on one line, points on one plane where `coplanar` is not set (or off it where it is), a
/// left-handed world frame, points that fit no camera. With hardly any depth (3 % of the distance),
/// a strong lens and a centre far off, one list in two hundred is refused as left-handed that is
/// not. Error sentences number the points from 1 by `labels` (their lines in a file) where given.
/// Any thread; deterministic.
Result<TsaiReport> calibrate_tsai(const std::vector<SeenPoint>& points, const TsaiOptions& options,
                                  const std::vector<int>& labels = {});

}  // namespace kambara
