// SPDX-License-Identifier: GPL-3.0-or-later
// Views of targets through known rigs, at the level of corners.
#pragma once

#include <Eigen/Geometry>
#include <random>
#include <vector>

#include "core/base/angles.h"
#include "core/calibration/rig_calibrator.h"
#include "core/calibration/target.h"
#include "core/camera/nominal_rig.h"
#include "core/camera/rig.h"

namespace kambara::testing_support {

/// How the target is shown.
struct Showing {
    int views = 30;
    double noise_px = 0.05;
    double nearest_mm = 750.0;
    double farthest_mm = 1600.0;
    double across = 0.35;  ///< of the distance, to both sides
    double turn_deg = 25.0;
    bool pan_tilt = true;
};

inline std::vector<const Camera*> cameras_of(const Rig& rig) {
    return {&rig.left, rig.right ? &*rig.right : nullptr, rig.pan_tilt ? &*rig.pan_tilt : nullptr};
}

inline RigidTransform random_pose(const Target& target, const Showing& how, std::mt19937& random) {
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    const auto* boxes = std::get_if<BoxTarget>(&target);
    const double turn = boxes != nullptr && boxes->planes.size() > 1 ? -45.0 : 0.0;
    const double range =
        how.nearest_mm + 0.5 * (1.0 + unit(random)) * (how.farthest_mm - how.nearest_mm);
    const Eigen::Vector3d place(225.0 + how.across * range * unit(random),
                                (0.12 + 0.25 * unit(random)) * range, range);
    RigidTransform T;
    T.R = Eigen::AngleAxisd(rad_from_deg(20.0) * unit(random), Eigen::Vector3d::UnitZ())
              .toRotationMatrix() *
          rotation_about_y(rad_from_deg(turn + how.turn_deg * unit(random))) *
          rotation_about_x(rad_from_deg(how.turn_deg * unit(random)));
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    const auto corners = corners_in_target_mm(target);
    for (const auto& corner : corners) {
        middle += corner / static_cast<double>(corners.size());
    }
    T.t_mm = place - T.R * middle;
    return T;
}

/// The corners that one camera sees: for boxes and markers any part, for a chessboard all or none.
inline DetectedCorners seen_by(const Camera& camera, const Target& target,
                               const RigidTransform& T_rig_from_target, double noise_px,
                               std::mt19937& random) {
    std::normal_distribution<double> noise(0.0, 1.0);
    DetectedCorners seen;
    const auto corners = corners_in_target_mm(target);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const auto px = camera.project(T_rig_from_target * corners[i]);
        const Eigen::Vector2d off(noise(random), noise(random));
        if (px && camera.sees(*px)) {
            seen.push_back({static_cast<int>(i), *px + noise_px * off, 0.05});
        }
    }
    const bool whole = std::holds_alternative<ChessboardTarget>(target);
    if (seen.size() < (whole ? corners.size() : 12U)) {
        seen.clear();
    }
    return seen;
}

/// Views that at least two cameras see.
inline std::vector<RigView> views_of(const Rig& rig, const Target& target, const Showing& how,
                                     std::mt19937& random) {
    std::vector<RigView> views;
    while (static_cast<int>(views.size()) < how.views) {
        const RigidTransform T = random_pose(target, how, random);
        RigView view;
        int seen = 0;
        const auto cameras = cameras_of(rig);
        for (std::size_t c = 0; c < cameras.size(); ++c) {
            if (cameras[c] == nullptr || (c == 2 && !how.pan_tilt)) {
                continue;
            }
            view.sights[c].corners = seen_by(*cameras[c], target, T, how.noise_px, random);
            seen += view.sights[c].corners.empty() ? 0 : 1;
            view.sights[c].fault = "not in the picture";
        }
        if (seen >= 2 && !view.sights[0].corners.empty() && !view.sights[1].corners.empty()) {
            views.push_back(std::move(view));
        }
    }
    return views;
}

inline RigCalibratorOptions options_for(const Rig& rig, bool pan_tilt = true) {
    RigCalibratorOptions options;
    const auto cameras = cameras_of(rig);
    for (std::size_t c = 0; c < cameras.size(); ++c) {
        if (cameras[c] != nullptr && (c < 2 || pan_tilt)) {
            options.cameras[c] = PictureSize{cameras[c]->width_px, cameras[c]->height_px};
        }
    }
    if (const auto* tsai = std::get_if<TsaiLens>(&rig.left.lens)) {
        options.model = LensModel::tsai;
        options.sensor = tsai->sensor;
    }
    return options;
}

}  // namespace kambara::testing_support
