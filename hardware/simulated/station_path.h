// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace kambara {

/// The range experiment's seventy-five places (1999, section 7.2.3: three heights, five depths,
/// five places across): 1 to 2 m before the rig, at -26 to 26 degrees from the middle between its
/// cameras, 250 mm above to 250 mm below. The target is still at each for a while, then goes to
/// the next, which is a neighbour; after the last it stays. In the rig's frame.
namespace station_path {

inline constexpr int stations = 75;
inline constexpr double still_s = 0.4;
inline constexpr double station_s = 1.0;  ///< from one station's beginning to the next one's

/// The station's place, 0 <= station < 75.
Eigen::Vector3d place_mm(int station);

/// The place at a time, which is not negative.
Eigen::Vector3d place_at_mm(double time_s);

/// The station at which the target is still; -1 while it moves.
int station_at(double time_s);

}  // namespace station_path
}  // namespace kambara
