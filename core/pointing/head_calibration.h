// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "core/base/result.h"
#include "core/camera/head_model.h"
#include "core/camera/rig.h"

namespace kambara {

/// A point whose place in the rig is known, and where the head's camera sees it.
struct HeadSighting {
    Eigen::Vector3d point_in_rig_mm = Eigen::Vector3d::Zero();
    Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
};

/// What the head's camera saw while the head stood still.
struct HeadView {
    HeadAngles encoder;
    HeadApproach approach;
    std::vector<HeadSighting> sightings;
};

struct HeadCalibrationOptions {
    int least_views = 8;
    double least_pan_rad = 0.35;   ///< that the views must span: 20 degrees
    double least_tilt_rad = 0.17;  ///< 10 degrees
    double largest_rms_px = 1.5;
    double sigma_px = 0.1;  ///< of a pixel, against which the weak beliefs below are weighed
};

struct HeadCalibration {
    HeadModel model;
    double rms_px = 0.0;
    /// With the camera turning about its own centre instead, which is where its pose at home and
    /// the angles put it: what the model is worth.
    double rms_without_model_px = 0.0;
    int views = 0;
    int points = 0;
    bool pan_backlash_seen = false;  ///< there were approaches from both sides
    bool tilt_backlash_seen = false;
    double pan_backlash_sigma_rad = 0.0;
    double tilt_backlash_sigma_rad = 0.0;
    double tilt_axis_ahead_sigma_mm = 0.0;
    Eigen::Vector3d camera_from_tilt_sigma_mm = Eigen::Vector3d::Zero();
};

/// The head's model from views of points of known place at several head positions, by least squares
/// of the pixels' errors (Levenberg-Marquardt), the rig being given: sixteen numbers, which are the
/// base's pose, both lever arms, the skew, the camera's turn on its axis and both backlashes. What
/// the views leave open is held near nothing by weak beliefs: levers to 200 mm, skew and the
/// camera's turn to 6 degrees, backlash to 3. The deviations are the pixels' scatter
/// carried over, or the views' where that says more; an error that all views share, such as the
/// rig's own, is in neither.
/// Needs a pan-tilt camera in the rig, whose pose is the start. Refuses: too few views or too small
/// a span, points that the start puts behind the camera, an RMS beyond the gate.
Result<HeadCalibration> calibrate_head(const Rig& rig, const std::vector<HeadView>& views,
                                       const HeadCalibrationOptions& options = {});

/// How far a view is from a model: RMS of the angles, at the head's camera, between where it sees
/// the points and where the model has them. Empty where a pixel has no ray.
std::optional<double> view_rms_rad(const Rig& rig, const HeadModel& model, const HeadView& view);

/// The rig with the head's model, and its pan-tilt camera where that has it at home.
Rig with_head_model(Rig rig, const HeadModel& model);

}  // namespace kambara
