// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>

#include "core/base/angles.h"
#include "core/camera/rig.h"

namespace kambara {

/// The angles that bring to the optical axis what a pixel of the pan-tilt picture shows while the
/// head is at `seen_from` and its lens shows things `magnification` times as large as the
/// calibrated one does. Where the head model has lever arms, for things `range_mm` away. Empty
/// where the rig has no pan-tilt camera or no direction belongs to the pixel.
std::optional<HeadAngles> centring_angles(const Rig& rig, const Eigen::Vector2d& pixel,
                                          const HeadAngles& seen_from, double magnification = 1.0,
                                          double range_mm = 2000.0);

}  // namespace kambara
