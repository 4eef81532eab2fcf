// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/calibration/range_error.h"
#include "core/calibration/rig_views.h"
#include "core/camera/rig.h"

namespace kambara {

enum class Verdict { good, usable, refused };
std::string to_string(Verdict verdict);

/// A parameter as it came out; sigma 0 for what was held fixed.
struct NamedValue {
    std::string name;  ///< with its unit
    double value = 0.0;
    double sigma = 0.0;
};

/// What one camera came to.
struct CameraResult {
    Camera camera;
    double rms_px = 0.0;  ///< root mean square of the corners' residual lengths, joint solution
    int corners_used = 0;
    int views_used = 0;
    std::vector<NamedValue> parameters;
    /// Share of the picture, in 8 x 6 fields, in which a corner was seen.
    double picture_share = 0.0;
    /// Of the residuals' variance, what is the same for all corners of a field: what the lens model
    /// doesn't describe. About 0 where it describes all.
    double systematic_px = 0.0;
    double blur_px = 0.0;  ///< median width of the edges at the corners; 0 where not measured
};

/// The left camera and another one.
struct PairResult {
    RigidTransform T_other_from_left;
    Eigen::Vector3d sigma_T_mm = Eigen::Vector3d::Zero();
    double baseline_mm = 0.0;
    double baseline_sigma_mm = 0.0;
};

struct RejectedView {
    int view = 0;
    std::string camera;  ///< whose picture is at fault; empty where they contradict each other
    std::string reason;
};

struct Residual {
    int view = 0;
    int camera = 0;  ///< as camera_names counts
    int id = 0;
    Eigen::Vector2d px;
    Eigen::Vector2d residual_px;  ///< predicted minus seen
    bool used = true;
};

/// The calibration from one half of the views, put to the test on the other, both ways.
struct HeldOutCheck {
    int views = 0;
    int lengths = 0;             ///< between neighbouring corners
    double mean_error_mm = 0.0;  ///< of a length, without its sign
    double largest_error_mm = 0.0;
    double scale_error = 0.0;  ///< the target's size as triangulated over the drawing's, less 1
};

/// A baseline measured by tape against the one the pictures tell.
struct BaselineCheck {
    double measured_mm = 0.0;
    double measured_sigma_mm = 0.0;
    double found_mm = 0.0;  ///< by the pictures alone
    double found_sigma_mm = 0.0;
    double pull = 0.0;  ///< the difference in units of both deviations together
};

/// What a calibration did and why it ended as it did.
struct CalibrationReport {
    Verdict verdict = Verdict::refused;
    std::vector<std::string> reasons;     ///< for anything less than good
    std::vector<std::string> notes;       ///< worth knowing, no fault
    double rms_px = 0.0;                  ///< over all corners used
    std::optional<double> stereo_rms_px;  ///< over left and right, as OpenCV's stereoCalibrate
    int corners_used = 0;
    int corners_total = 0;  ///< of every picture given
    int views_used = 0;
    std::vector<RejectedView> views_rejected;
    std::array<std::optional<CameraResult>, most_cameras> cameras;
    std::array<std::optional<PairResult>, most_cameras> pairs;  ///< the left one's stays empty
    std::vector<Residual> residuals;
    double nearest_mm = 0.0;  ///< depth of the nearest and farthest corner used, left camera
    double farthest_mm = 0.0;
    std::optional<HeldOutCheck> held_out;
    std::optional<BaselineCheck> baseline;
    RangeErrorOptions range_options;
    std::vector<RangeErrorPoint> range_errors;
    Rig rig;  ///< to be used unless refused
};

}  // namespace kambara
