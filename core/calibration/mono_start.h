// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <stop_token>
#include <vector>

#include "core/calibration/bundle.h"
#include "core/calibration/detected_corners.h"

namespace kambara {

/// One camera by itself.
struct MonoResult {
    bool converged = false;
    BundleCamera camera;
    /// A view each; empty where the view has too few corners or fits no pose.
    std::vector<std::optional<PoseBlock>> camera_from_target;
    std::vector<double> view_rms_px;    ///< a view each, of the corners kept
    std::vector<DetectedCorners> kept;  ///< without the corners that fit nowhere
    int corners_left_out = 0;
};

/// The picture's size and what is known of a camera beforehand.
struct MonoStart {
    LensModel model = LensModel::brown;
    Sensor sensor;
    int width_px = 0;
    int height_px = 0;
    bool free_k3 = false;
};

/// Calibrates one camera from its views of a target, flat or not. The focal length starts from
/// whichever of a row of values lets the views' poses fit best (perspective from points, OpenCV),
/// the lens then follows by least squares, first with a loss that outliers don't move.
MonoResult calibrate_mono(const std::vector<Eigen::Vector3d>& target_mm,
                          const std::vector<DetectedCorners>& views, const MonoStart& start,
                          const std::stop_token& stop = {});

/// The standard deviation of a coordinate, from the residuals' median, which outliers don't move.
double robust_sigma_px(const std::vector<Eigen::Vector2d>& residuals);

}  // namespace kambara
