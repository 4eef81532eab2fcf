// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/vsystem/calibration_views.h"

#include <cstddef>
#include <string>

#include "core/calibration/calibrator.h"
#include "core/calibration/chessboard_detector.h"
#include "core/camera/rig_file.h"

namespace kambara {
namespace {

constexpr std::size_t most_views = 100;

// The corners, or why there are none.
void detect(const Frame& frame, const ChessboardTarget& board,
            std::vector<Eigen::Vector2d>& corners, std::string& fault) {
    auto found = detect_chessboard(grey_from(*frame.picture), board);
    if (found) {
        corners = std::move(*found);
    } else {
        fault = found.error().cause;
    }
}

CalibrationOutcome outcome_of(const CalibrationReport& report) {
    CalibrationOutcome outcome;
    outcome.verdict = to_string(report.verdict);
    outcome.reasons = report.reasons;
    outcome.views_used = report.views_used;
    outcome.stereo_rms_px = report.stereo_rms_px.value_or(report.rms_px);
    outcome.baseline_mm = report.T_right_from_left.t_mm.norm();
    if (report.verdict != CalibrationReport::Verdict::refused) {
        outcome.rig_text = rig_to_text(report.rig);
    }
    return outcome;
}

}  // namespace

Result<Reply> CalibrationViews::capture(const ImageSet& images) {
    std::lock_guard lock(mutex_);
    if (views_.size() >= most_views) {
        return Error{"A hundred views are captured already.", "Calibrate from them."};
    }
    views_.push_back(images.stereo);
    return Reply(Done{});
}

Result<std::pair<Rig, CalibrationOutcome>> CalibrationViews::calibrate(const Calibrate& command,
                                                                       const Rig& before) {
    const auto target = parse_target(command.target);
    if (!target) {
        return target.error();
    }
    const auto* board = std::get_if<ChessboardTarget>(&*target);
    if (board == nullptr) {
        return Error{
            "Calibrating with the target " + command.target + " is not in this version yet.",
            "Use a chessboard."};
    }
    std::vector<StereoFrame> frames;
    {
        std::lock_guard lock(mutex_);
        frames = views_;
    }
    if (frames.empty()) {
        return Error{"No view of the target has been captured.",
                     "Show the target to both cameras and capture some views first."};
    }
    CalibratorOptions options;
    options.width_px = frames.front().left.picture->width();
    options.height_px = frames.front().left.picture->height();
    options.stereo = frames.front().right.picture != nullptr;
    std::vector<BoardView> views(frames.size());
    for (std::size_t i = 0; i < frames.size(); ++i) {
        detect(frames[i].left, *board, views[i].left_px, views[i].left_fault);
        if (options.stereo) {
            detect(frames[i].right, *board, views[i].right_px, views[i].right_fault);
        }
    }
    CalibrationReport report = calibrate_chessboard(views, *board, options);
    report.rig.provenance.method =
        command.target + ", brown, " + std::to_string(report.views_used) + " views";
    report.rig.medium = before.medium;
    if (before.pan_tilt) {
        report.rig.pan_tilt = before.pan_tilt;
        report.rig.pan_tilt->T_camera_from_rig = before.pan_tilt->T_camera_from_rig *
                                                 before.left.T_camera_from_rig.inverse() *
                                                 report.rig.left.T_camera_from_rig;
    }
    if (report.verdict != CalibrationReport::Verdict::refused) {
        std::lock_guard lock(mutex_);
        // Views captured meanwhile stay for the next time.
        views_.erase(views_.begin(), views_.begin() + static_cast<std::ptrdiff_t>(frames.size()));
    }
    return std::pair(report.rig, outcome_of(report));
}

}  // namespace kambara
