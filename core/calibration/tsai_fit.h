// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/calibration/seen_point.h"
#include "core/calibration/tsai_refine.h"

namespace kambara {

/// How far a fit goes after the linear stage: basic refines f, T_z and kappa1 alone, the centre
/// and, for a plane, s_x staying as given; full refines everything that the points can tell.
enum class TsaiMethod { basic, full };

struct TsaiFitOptions {
    TsaiLens given;  ///< the sensor, the centre to start from, and s_x for a plane
    TsaiMethod method = TsaiMethod::full;
    bool coplanar = false;
};

/// The parameters that points of this layout can tell.
TsaiMask told_parameters(const TsaiFitOptions& options);

/// The linear stage alone, its best candidate; empty where none is possible.
std::optional<TsaiView> linear_fit(const std::vector<SeenPoint>& points,
                                   const TsaiFitOptions& options);

/// The linear stage and the refinements, over all the points, by least squares: one wrong point
/// spoils it. Empty where the linear stage finds no camera.
std::optional<TsaiView> fit(const std::vector<SeenPoint>& points, const TsaiFitOptions& options);

/// A fit over the points that agree, and which those are.
struct RobustFit {
    TsaiView view;
    std::vector<int> inliers;
    std::vector<int> outliers;
    bool suspicious = false;  ///< the fit over all the points did not look like noise alone
    double median_px = 0.0;   ///< of all the points' residual lengths
};

/// As above, whatever up to two fifths of the points are: where all the points together don't fit,
/// those are looked for that agree (least trimmed squares from small subsets, drawn with a fixed
/// seed); then a point is an outlier where its residual, with the uncertainty of its prediction,
/// would come from the others' noise less than once in a thousand such lists (F test). The fit
/// itself is always full, so that a centre given wrongly is not taken for outliers.
std::optional<RobustFit> robust_fit(const std::vector<SeenPoint>& points,
                                    const TsaiFitOptions& options);

}  // namespace kambara
