// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cmath>

#include "core/base/angles.h"

namespace kambara {

/// The simulated rig looks down by so much.
inline constexpr double cameras_down_rad = rad_from_deg(15.0);

/// The vertical, downwards, in its frame.
inline const Eigen::Vector3d down_in_rig(0.0, std::cos(cameras_down_rad),
                                         std::sin(cameras_down_rad));

}  // namespace kambara
