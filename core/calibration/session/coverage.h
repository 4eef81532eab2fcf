// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core/calibration/session/rig_guess.h"
#include "core/calibration/target.h"

namespace kambara {

/// How one camera's picture is covered: fields of a grid, row by row.
struct PictureCoverage {
    static constexpr int across = 8;
    static constexpr int down = 6;
    std::array<int, 48> views{};  ///< in how many views a corner lies in the field
    double share = 0.0;           ///< of the fields that have any
};

/// How the target was held in one view, as far as the guess of the rig tells.
struct HeldPose {
    double depth_mm = 0.0;  ///< of the target's middle, before the left camera
    double turn_deg = 0.0;  ///< of the target about the upright axis, from facing the left camera
    double tilt_deg = 0.0;  ///< and about the one across
    double roll_deg = 0.0;
};

/// What views of the target have seen so far. Depths and angles rest on the guess of the rig.
struct Coverage {
    std::array<PictureCoverage, most_cameras> pictures;
    std::vector<HeldPose> poses;  ///< of the views whose pose can be told
    double nearest_mm = 0.0;
    double farthest_mm = 0.0;
    double widest_slant_deg = 0.0;  ///< turn and tilt together
};

Coverage coverage_of(const RigGuess& guess, const Target& target,
                     const std::vector<RigView>& views);

}  // namespace kambara
