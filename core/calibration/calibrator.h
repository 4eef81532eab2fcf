// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/calibration/target.h"
#include "core/camera/rig.h"

namespace kambara {

/// The board as both cameras saw it at one instant; a side where it was not found is empty and says
/// why.
struct BoardView {
    std::vector<Eigen::Vector2d> left_px;
    std::vector<Eigen::Vector2d> right_px;
    std::string left_fault;
    std::string right_fault;
};

struct KnownBaseline {
    double baseline_mm = 0.0;
    double sigma_mm = 0.0;
};

struct CalibratorOptions {
    int width_px = 0;
    int height_px = 0;
    bool stereo = true;    ///< false: the left camera alone
    bool free_k3 = false;  ///< the third radial term; narrow lenses can't tell it
    int least_views = 3;
    double usable_rms_px = 0.5;   ///< above: usable, not good
    double refused_rms_px = 1.0;  ///< above: refused
    std::optional<KnownBaseline> baseline;
};

/// What one camera came to. Sigmas: fx, fy, cx, cy in px, then the eight distortion terms; 0 for
/// what was held fixed.
struct CameraResult {
    Camera camera;
    double rms_px = 0.0;  ///< root mean square of the corners' residual lengths, joint solution
    std::array<double, 12> sigma{};
};

struct RejectedView {
    int view = 0;
    std::string reason;
};

/// What a calibration did and why it ended as it did.
struct CalibrationReport {
    enum class Verdict { good, usable, refused };
    Verdict verdict = Verdict::refused;
    std::vector<std::string> reasons;     ///< for anything less than good
    double rms_px = 0.0;                  ///< over all corners used
    std::optional<double> stereo_rms_px;  ///< over both cameras, as OpenCV's stereoCalibrate has it
    int corners_used = 0;
    int corners_total = 0;  ///< of every picture given
    int views_used = 0;
    std::vector<RejectedView> views_rejected;
    CameraResult left;
    std::optional<CameraResult> right;
    RigidTransform T_right_from_left;
    Eigen::Vector3d sigma_T_mm = Eigen::Vector3d::Zero();
    double baseline_sigma_mm = 0.0;
    Rig rig;  ///< to be used unless refused
};

std::string to_string(CalibrationReport::Verdict verdict);

using CalibrationProgress = std::function<void(double share)>;

/// Calibrates one camera or two from views of a flat chessboard: each camera by Zhang's method
/// (OpenCV), then both lenses, the pose between them and every board's pose together by least
/// squares of the reprojection residuals, with the covariance that follows. Views that fit far
/// worse than the others are left out. Always gives a report; a refused one says why. Any thread.
CalibrationReport calibrate_chessboard(const std::vector<BoardView>& views,
                                       const ChessboardTarget& board,
                                       const CalibratorOptions& options, std::stop_token stop = {},
                                       const CalibrationProgress& progress = {});

}  // namespace kambara
