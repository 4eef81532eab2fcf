// SPDX-License-Identifier: GPL-3.0-or-later
// A rig that differs from what a session guesses it to be, and hands that hold a target before it.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <optional>
#include <random>
#include <vector>

#include "core/calibration/session/calibration_session.h"
#include "core/calibration/session/candidate_poses.h"
#include "core/geometry/triangulate.h"
#include "tests/core/calibration/rig_samples.h"

namespace kambara::testing_support {

/// The nominal rig as built: other focal lengths, centres, directions and baseline.
inline Rig built_rig(bool pan_tilt) {
    Rig rig = nominal_rig();
    auto& left = std::get<TsaiLens>(rig.left.lens);
    auto& right = std::get<TsaiLens>(rig.right->lens);
    left.f_mm *= 1.03;
    left.cx_px -= 12.0;
    right.f_mm *= 0.98;
    right.cy_px += 9.0;
    RigidTransform T = T_right_from_left(rig);
    T.R = rotation_about_x(rad_from_deg(1.0)) * rotation_about_y(rad_from_deg(-1.5)) * T.R;
    T.t_mm *= 1.04;
    Rig built = rig_from_pair(rig.left, *rig.right, T);
    if (pan_tilt) {
        built.pan_tilt = rig.pan_tilt;
        std::get<TsaiLens>(built.pan_tilt->lens).f_mm *= 1.02;
    }
    return built;
}

inline SessionSetup setup_for(const Rig& rig, const Target& target, LensModel model) {
    SessionSetup setup;
    setup.target = target;
    setup.model = model;
    setup.sensor = std::get<TsaiLens>(rig.left.lens).sensor;
    const auto cameras = cameras_of(rig);
    for (std::size_t c = 0; c < cameras.size(); ++c) {
        if (cameras[c] != nullptr) {
            setup.cameras[c] = PictureSize{cameras[c]->width_px, cameras[c]->height_px};
        }
    }
    return setup;
}

inline RigCalibratorOptions options_of(const SessionSetup& setup) {
    RigCalibratorOptions options;
    options.cameras = setup.cameras;
    options.model = setup.model;
    options.sensor = setup.sensor;
    return options;
}

/// What the cameras see of the whole target; empty where one of them does not see all of it.
inline std::optional<RigView> shown(const Rig& rig, const Target& target,
                                    const RigidTransform& T_left_from_target, double noise_px,
                                    std::mt19937& random) {
    const std::size_t all = corners_in_target_mm(target).size();
    const RigidTransform T = rig.left.T_camera_from_rig.inverse() * T_left_from_target;
    RigView view;
    const auto cameras = cameras_of(rig);
    for (std::size_t c = 0; c < cameras.size(); ++c) {
        if (cameras[c] == nullptr) {
            continue;
        }
        view.sights[c].corners = seen_by(*cameras[c], target, T, noise_px, random);
        if (view.sights[c].corners.size() != all) {
            return std::nullopt;
        }
    }
    return view;
}

/// As near the pose as hands hold it: some 15 mm and 2 degrees off in every direction.
inline RigidTransform held_about(const RigidTransform& pose, const Target& target,
                                 std::mt19937& random) {
    std::normal_distribution<double> normal;
    const Eigen::Vector3d middle = middle_of(corners_in_target_mm(target));
    const Eigen::Vector3d axis(normal(random), normal(random), normal(random));
    RigidTransform T;
    T.R = Eigen::AngleAxisd(rad_from_deg(2.0) * axis.norm(), axis.normalized()).toRotationMatrix() *
          pose.R;
    T.t_mm = pose * middle +
             15.0 * Eigen::Vector3d(normal(random), normal(random), normal(random)) - T.R * middle;
    return T;
}

/// Root mean square over the working volume of the range's error over the range, from pixels
/// without noise: what the calibrated rig does to the built one's pictures.
inline double true_range_error(const Rig& built, const Rig& calibrated) {
    double squares = 0.0;
    int places = 0;
    for (int i = 0; i < 75; ++i) {
        const double z = 1000.0 + 250.0 * (i % 5);
        const double x = 225.0 + z * std::tan(rad_from_deg(13.0 * (i / 15 - 2)));
        const Eigen::Vector3d at(x, 200.0 * (i / 5 % 3 - 1), z);
        const auto l = built.left.project(at);
        const auto r = built.right->project(at);
        if (!l || !r || !built.left.sees(*l) || !built.right->sees(*r)) {
            continue;
        }
        const auto ray_l = calibrated.left.unproject(*l);
        const auto ray_r = calibrated.right->unproject(*r);
        const auto meeting = ray_l && ray_r ? meeting_of(*ray_l, *ray_r) : std::nullopt;
        const double range = (built.left.T_camera_from_rig * at).norm();
        const double found =
            meeting ? (calibrated.left.T_camera_from_rig * meeting->midpoint_mm).norm() : 0.0;
        squares += std::pow(found / range - 1.0, 2);
        ++places;
    }
    return std::sqrt(squares / std::max(1, places));
}

/// Root mean square of what the report says the calibration leaves open of ranges.
inline double reported_range_error(const CalibrationReport& report) {
    double squares = 0.0;
    for (const RangeErrorPoint& place : report.range_errors) {
        squares += std::pow(place.sigma_calibration_mm / place.range_mm, 2);
    }
    return std::sqrt(squares /
                     static_cast<double>(std::max<std::size_t>(1, report.range_errors.size())));
}

}  // namespace kambara::testing_support
