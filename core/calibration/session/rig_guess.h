// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/calibration/bundle.h"
#include "core/calibration/rig_calibrator.h"
#include "core/calibration/rig_views.h"
#include "core/camera/rig.h"

namespace kambara {

/// What is taken for the rig while it is being calibrated: a solution, a data sheet, or nothing but
/// the nominal rig. The cameras that take part, the left one first.
struct RigGuess {
    std::vector<std::size_t> places;  ///< of the cameras, among camera_names
    std::vector<BundleCamera> cameras;
    std::vector<PictureSize> sizes;
};

/// The guess from a rig, with lenses of the model that is being calibrated: where the rig's are of
/// the other kind, without distortion. A camera the rig lacks, and one of other proportions, is
/// taken from the nominal rig.
RigGuess guess_from(const Rig& rig, const RigCalibratorOptions& options);

/// Where the target was in a view, from the first camera that has 6 corners of it or more
/// (perspective from points, OpenCV's SQPNP); empty where none tells.
std::optional<PoseBlock> first_from_target(const RigGuess& guess,
                                           const std::vector<Eigen::Vector3d>& target_mm,
                                           const RigView& view);

}  // namespace kambara
