// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/calibration/session/rig_guess.h"
#include "core/calibration/target.h"

namespace kambara {

/// Where the target's sheets look, in its own frame: the mean of the directions into them.
Eigen::Vector3d facing(const Target& target);

/// The mean of a target's corners.
Eigen::Vector3d middle_of(const std::vector<Eigen::Vector3d>& corners_mm);

/// Where a corner of the target comes to lie in one camera's picture; empty where it does not.
std::optional<Eigen::Vector2d> pixel_in(const RigGuess& guess, std::size_t camera,
                                        const RigidTransform& T_first_from_target,
                                        const Eigen::Vector3d& on_target_mm);

/// Whether the whole target can be found by all cameras: all corners inside every picture with a
/// margin, no sheet seen too much from the side, neighbouring corners 8 px apart or more, upright
/// within 40 degrees.
bool can_be_found(const RigGuess& guess, const Target& target,
                  const RigidTransform& T_first_from_target);

/// Poses in which the target can be found: over the narrowest camera's
/// picture, near to far, turned and tilted to
/// all sides and rolled a little. Always the same ones.
std::vector<RigidTransform> candidate_poses(const RigGuess& guess, const Target& target);

}  // namespace kambara
