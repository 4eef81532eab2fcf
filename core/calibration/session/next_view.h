// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/calibration/range_error.h"
#include "core/calibration/session/rig_guess.h"
#include "core/calibration/target.h"

namespace kambara {

/// Where to hold the target next, and what for.
struct NextView {
    RigidTransform T_left_from_target;
    /// The target's corners by number, as each camera would see them; empty for a camera that takes
    /// no part.
    std::array<std::vector<Eigen::Vector2d>, most_cameras> corners_px;
    /// The outlines of its sheets to be drawn in each picture, corner after corner; parts may lie
    /// outside.
    std::array<std::vector<std::vector<Eigen::Vector2d>>, most_cameras> outlines_px;
    /// What the views kept, and this one with them, leave open of ranges, by prediction: the root
    /// mean square of the error over the range, one deviation (see volume_goal).
    double range_error_before = 0.0;
    double range_error_after = 0.0;
};

struct NextViewOptions {
    double noise_px = 0.1;  ///< of each coordinate of a corner
    /// What is suggested differs from every view kept by so much in at least one camera, so that
    /// hands that are a little off don't repeat one.
    double least_change_px = 40.0;
    RangeErrorOptions volume;
};

/// What the views leave open of ranges, by prediction, as in NextView. Views whose pose can't be
/// told count nothing.
double predicted_range_error(const RigGuess& guess, const Target& target,
                             const std::vector<RigView>& views, const NextViewOptions& options);

/// Of the poses in which all cameras can find the target, the one whose view takes most away from
/// the range error that the views kept leave, and repeats none of them: the best one of a grid of
/// poses, and from there to better ones beside it. Empty where there is no such pose: the cameras
/// have no picture in common that the target fits in. The same input gives the same pose. Takes
/// some tenths of a second; any thread.
std::optional<NextView> next_view(const RigGuess& guess, const Target& target,
                                  const std::vector<RigView>& views,
                                  const NextViewOptions& options);

}  // namespace kambara
