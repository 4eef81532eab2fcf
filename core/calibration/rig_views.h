// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/calibration/detected_corners.h"

namespace kambara {

/// The cameras of a rig, in the order of everything that is told a camera each. The pan-tilt camera
/// is the one with its head at home.
inline constexpr std::array camera_names{"left", "right", "pan_tilt"};
inline constexpr std::size_t most_cameras = camera_names.size();

/// The target in one camera's picture. No corners: it was not found, and `fault` says why.
struct CameraSight {
    DetectedCorners corners;
    std::string fault;
};

/// What all cameras saw at one instant; a camera that doesn't take part saw nothing.
struct RigView {
    std::array<CameraSight, most_cameras> sights;
};

}  // namespace kambara
