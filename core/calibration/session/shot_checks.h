// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>

#include "core/calibration/rig_views.h"
#include "core/calibration/target.h"
#include "core/image/image.h"

namespace kambara {

/// The pictures of one instant, as camera_names counts; none for a camera that takes no part.
using PictureSet = std::array<ImagePtr, most_cameras>;

/// The target in every picture, or why not.
RigView find_in_all(const PictureSet& pictures, const Target& target);

struct SharpnessOptions {
    double most_blur_px = 4.0;   ///< median width of the edges, where it was measured
    double most_sigma_px = 0.4;  ///< median deviation of a corner
};

/// Which camera that takes part did not find the target, and why, as a sentence; empty where all
/// found it.
std::string not_found(const RigView& seen, const std::array<bool, most_cameras>& taking_part);

/// Which picture is not sharp enough, as a sentence; empty where all are.
std::string not_sharp(const RigView& seen, const SharpnessOptions& options);

/// Whether `seen` shows the target where `before` does, in every camera that saw it both times.
bool repeats(const RigView& seen, const RigView& before, double least_change_px);

}  // namespace kambara
