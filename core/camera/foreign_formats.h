// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/camera/picture_size.h"
#include "core/camera/rig.h"

namespace kambara {

/// Calibrations as other programs write them. All take text and give a rig, or text for a rig;
/// lengths are turned from and to metres where the other side uses them. A rig read needs the
/// pictures' size; where a format does not hold it, it is given, and refused when it is not. Any
/// bytes are safe to pass.

/// KITTI's calib.txt with two 3 x 4 projection matrices, left then right: two lines of twelve
/// numbers, with or without names such as "P0:". Rectified, no distortion; metres.
Result<Rig> rig_from_kitti(std::string_view text, const std::optional<PictureSize>& size);

/// OpenCV's intrinsics.yml (M1 D1 M2 D2) and extrinsics.yml (R T), as its stereo calibration sample
/// writes them. T keeps its unit, which the sample takes from the board: mm is assumed.
Result<Rig> rig_from_opencv(std::string_view intrinsics, std::string_view extrinsics,
                            const std::optional<PictureSize>& size);

/// ROS camera_info of a stereo pair, as camera_calibration writes it: the pose between the cameras
/// follows from the rectification matrices and the right projection's fourth column; metres.
Result<Rig> rig_from_ros(std::string_view left, std::string_view right);

/// Kalibr's camchain of two pinhole cameras with radtan distortion or none; metres.
Result<Rig> rig_from_kalibr(std::string_view camchain);

/// A lens put into other terms, and the largest distance between the two over the whole picture.
struct FittedLens {
    BrownLens lens;
    double worst_residual_px = 0.0;
};

/// The Brown lens with 4 (k3 held at 0), 5 or 8 terms that comes nearest to any lens: least squares
/// over a grid of pixels that covers the picture.
Result<FittedLens> fitted_brown(const Camera& camera, int terms);

/// What is written, and how far the other program's model is from ours.
struct ExportedPair {
    std::string first;   ///< intrinsics.yml, left.yaml or camchain.yaml
    std::string second;  ///< extrinsics.yml or right.yaml; empty for camchain.yaml
    double worst_residual_px = 0.0;
};

/// Lenses that the other side can't hold are fitted; more than this is refused.
inline constexpr double most_export_residual_px = 0.05;

Result<ExportedPair> rig_to_opencv(const Rig& rig);
Result<ExportedPair> rig_to_ros(const Rig& rig);
Result<ExportedPair> rig_to_kalibr(const Rig& rig);

}  // namespace kambara
