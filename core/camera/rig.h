// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "core/camera/head_model.h"
#include "core/camera/lens.h"
#include "core/camera/mount.h"
#include "core/geometry/rigid_transform.h"

namespace kambara {

/// A lens, the size of its pictures, and where it is in the rig.
struct Camera {
    Lens lens;
    int width_px = 0;
    int height_px = 0;
    RigidTransform T_camera_from_rig;

    /// Pixel of a point in the rig's frame; empty where it projects nowhere (see lens.h).
    std::optional<Eigen::Vector2d> project(const Eigen::Vector3d& point_in_rig_mm) const;
    std::optional<Eigen::Vector2d> project(const Eigen::Vector3d& point_in_rig_mm,
                                           Eigen::Matrix<double, 2, 3>& pixel_by_point) const;
    /// The ray of a pixel in the rig's frame; empty where no direction projects to it.
    std::optional<Ray> unproject(const Eigen::Vector2d& pixel) const;
    bool sees(const Eigen::Vector2d& pixel) const;
};

enum class Medium { air, water };

/// Where a calibration comes from: kept with it, shown to people, never computed with.
struct Provenance {
    std::string method;   ///< e.g. "chessboard:9x6:30, brown, 14 views" or "converted from kitti"
    std::string created;  ///< date and time, ISO 8601; empty where unknown
    std::string program;  ///< name and version of what wrote it
    std::optional<double> stereo_rms_px;
    std::optional<double> baseline_sigma_mm;
    std::string settings;  ///< how it was asked for
    std::vector<std::string>
        pictures;  ///< what from: name and the content's hash (FNV-1a, 64 bits)
};

/// Calibrated cameras. Rig frame: origin at the left camera's optical centre, x towards the right
/// camera's, z the mean of the two optical axes made square to x, y down (geometry: frames).
/// For one camera alone it is the left camera's frame.
struct Rig {
    Medium medium = Medium::air;
    Camera left;
    std::optional<Camera> right;
    std::optional<Camera> pan_tilt;  ///< with the head at home
    std::optional<HeadModel> head;   ///< how the pan-tilt camera moves, where that is known
    std::optional<Mount> mount;      ///< on the vehicle, where that is known
    Provenance provenance;
    /// What the calibration leaves open of the left and right camera, in the order and units of
    /// rig_parameters.h; empty where that is not known.
    std::optional<Eigen::MatrixXd> parameter_covariance;
    /// Likewise of the pan-tilt camera's lens by itself, in the order of lens_parameter_names().
    std::optional<Eigen::MatrixXd> pan_tilt_lens_covariance;
};

/// The rig of two lenses and the pose between them, with the rig frame as defined above.
Rig rig_from_pair(const Camera& left, const Camera& right, const RigidTransform& T_right_from_left);

RigidTransform T_right_from_left(const Rig& rig);

/// Distance of the left and right optical centres: norm(C_left - C_right). Needs a right camera.
double baseline_mm(const Rig& rig);

/// The rig for left and right pictures of another size (see scaled() in lens.h); the pan-tilt
/// camera keeps its own.
Rig scaled_to(const Rig& rig, int width_px, int height_px);

}  // namespace kambara
