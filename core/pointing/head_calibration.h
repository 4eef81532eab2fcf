// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/camera/head_model.h"
#include "core/camera/rig.h"

namespace kambara {

/// A point, where the rig as it is has it, and where the head's camera sees it.
struct HeadSighting {
    Eigen::Vector3d point_in_rig_mm = Eigen::Vector3d::Zero();
    Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
};

/// Likewise, and where the fixed cameras see it.
struct PairSighting {
    Eigen::Vector3d point_in_rig_mm = Eigen::Vector3d::Zero();
    Eigen::Vector2d left_px = Eigen::Vector2d::Zero();
    Eigen::Vector2d right_px = Eigen::Vector2d::Zero();
};

/// What the cameras saw of a target while it and the head stood still. The points of both lists are
/// those of one rigid target, laid where the rig as it is has it. Without `pair` it lies there;
/// with it, that is a start only, and what counts is the layout and the pixels.
struct HeadView {
    HeadAngles encoder;
    HeadApproach approach;
    std::vector<HeadSighting> sightings;
    std::vector<PairSighting> pair;
};

struct HeadCalibrationOptions {
    int least_views = 8;
    double least_pan_rad = 0.35;   ///< that the views must span: 20 degrees
    double least_tilt_rad = 0.17;  ///< 10 degrees
    double largest_rms_px = 1.5;
};

/// What the views say of the rig itself.
struct RigByHeadViews {
    /// The parameter (rig_parameters.h, or pan_tilt. and a lens's) that they move most against its
    /// own deviation, and by how many of these: more than three says that the rig has changed since
    /// it was calibrated, or that its covariance is too narrow.
    std::string most_moved;
    double most_moved_sigmas = 0.0;
    bool pan_tilt_lens_held = true;  ///< nothing tells how well it is known
    /// The rig so moved, with the head's model in it and the covariance that is left.
    Rig refined;
};

struct HeadCalibration {
    HeadModel model;  ///< by all that is known: what the deviations are of
    /// What steers best beside the rig as it is: the rig and the places that it gives are held, so
    /// that what it is off by is taken up by the head's numbers. As `model` where there is no
    /// by_rig.
    HeadModel model_for_given_rig;
    double rms_px = 0.0;                   ///< of the head's camera
    std::optional<double> pair_rms_px;     ///< of the fixed cameras, where their pixels took part
    std::optional<RigByHeadViews> by_rig;  ///< where the rig's covariance took part
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
    Eigen::Vector3d base_from_rig_sigma_mm = Eigen::Vector3d::Zero();
    Eigen::Vector3d base_turn_sigma_rad = Eigen::Vector3d::Zero();  ///< about the base's axes
};

/// The head's model from views of a target at several head positions, by least squares of the
/// pixels' errors (Levenberg-Marquardt): sixteen numbers, which are the base's pose, both lever
/// arms, the skew, the camera's turn on its axis and both backlashes. Where views have the fixed
/// cameras' pixels, the target's pose in each is unknown as well; where the rig has a covariance,
/// too, so are the rig's parameters, with its own calibration as what is believed of them. The
/// deviations of the pixels are taken from their scatter, the fixed cameras' and the head's each by
/// itself. Likewise the pan-tilt camera's lens, where the rig has its covariance, too; else it is
/// held.
/// What the views leave open is held near nothing by weak beliefs: levers to 200 mm, skew and the
/// camera's turn to 6 degrees, backlash to 3. The deviations are the pixels' and the rig's carried
/// over, or the views' scatter where that says more. Where the rig has no covariance (by_rig is
/// empty) it is held, and its own error, which all views share, is in none of them.
/// The base's pose is told in the frame of the rig as given, which its left camera holds.
/// Needs a pan-tilt camera in the rig, whose pose is the start. Refuses: too few views or too small
/// a span, points that the start puts behind the camera, an RMS beyond the gate.
Result<HeadCalibration> calibrate_head(const Rig& rig, const std::vector<HeadView>& views,
                                       const HeadCalibrationOptions& options = {});

/// How far a view is from a model: RMS of the angles, at the head's camera, between where it sees
/// the points and where the model has them. Empty where a pixel has no ray.
std::optional<double> view_rms_rad(const Rig& rig, const HeadModel& model, const HeadView& view);

/// By how much the head misses what is so far from its camera.
struct HeadMiss {
    double rms_rad = 0.0;
    double worst_rad = 0.0;
};

/// What it would cost to steer `rig`, which has the head's model, as `without` it is steered: over
/// the views' angles and all angles between them.
HeadMiss missed_without_model(const Rig& rig, const Rig& without,
                              const std::vector<HeadView>& views, double range_mm);

/// The rig with the head's model, and its pan-tilt camera where that has it at home.
Rig with_head_model(Rig rig, const HeadModel& model);

}  // namespace kambara
