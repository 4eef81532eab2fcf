// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/vsystem/calibration_views.h"

#include <cstddef>
#include <string>

#include "core/calibration/rig_calibrator.h"
#include "core/calibration/target_detector.h"
#include "core/camera/rig_file.h"

namespace kambara {
namespace {

constexpr std::size_t most_views = 100;

// The corners, or why there are none.
CameraSight sight_of(const Frame& frame, const Target& target) {
    auto found = detect_target(grey_from(*frame.picture), target);
    return found ? CameraSight{std::move(*found), ""} : CameraSight{{}, found.error().cause};
}

PictureSize size_of(const Frame& frame) {
    return {frame.picture->width(), frame.picture->height()};
}

CalibrationOutcome outcome_of(const CalibrationReport& report) {
    CalibrationOutcome outcome;
    outcome.verdict = to_string(report.verdict);
    outcome.reasons = report.reasons;
    outcome.views_used = report.views_used;
    outcome.stereo_rms_px = report.stereo_rms_px.value_or(report.rms_px);
    outcome.baseline_mm = report.pairs[1] ? report.pairs[1]->baseline_mm : 0.0;
    if (report.verdict != Verdict::refused) {
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
    std::vector<StereoFrame> frames;
    {
        std::lock_guard lock(mutex_);
        frames = views_;
    }
    if (frames.empty()) {
        return Error{"No view of the target has been captured.",
                     "Show the target to both cameras and capture some views first."};
    }
    RigCalibratorOptions options;
    options.medium = before.medium;
    options.cameras[0] = size_of(frames.front().left);
    const bool stereo = frames.front().right.picture != nullptr;
    if (stereo) {
        options.cameras[1] = size_of(frames.front().right);
    }
    std::vector<RigView> views(frames.size());
    for (std::size_t i = 0; i < frames.size(); ++i) {
        views[i].sights[0] = sight_of(frames[i].left, *target);
        if (stereo) {
            views[i].sights[1] = sight_of(frames[i].right, *target);
        }
    }
    CalibrationReport report = calibrate_rig(views, *target, options);
    report.rig.provenance.method =
        command.target + ", brown, " + std::to_string(report.views_used) + " views";
    if (before.pan_tilt) {  // as it is beside the left camera
        const RigidTransform T_before_from_now =
            before.left.T_camera_from_rig.inverse() * report.rig.left.T_camera_from_rig;
        report.rig.pan_tilt = before.pan_tilt;
        report.rig.pan_tilt->T_camera_from_rig =
            before.pan_tilt->T_camera_from_rig * T_before_from_now;
        report.rig.pan_tilt_lens_covariance = before.pan_tilt_lens_covariance;
        report.rig.head = before.head;
        if (report.rig.head) {
            report.rig.head->T_base_from_rig = before.head->T_base_from_rig * T_before_from_now;
        }
    }
    if (report.verdict != Verdict::refused) {
        std::lock_guard lock(mutex_);
        // Views captured meanwhile stay for the next time.
        views_.erase(views_.begin(), views_.begin() + static_cast<std::ptrdiff_t>(frames.size()));
    }
    return std::pair(report.rig, outcome_of(report));
}

}  // namespace kambara
