// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>

#include "core/camera/rig.h"

namespace kambara {

/// The pan-tilt camera as it stands when the head tells these angles: the camera at home, turned,
/// or by the rig's head model where there is one. The rig must have a pan-tilt camera.
Camera pan_tilt_camera_at(const Rig& rig, const HeadAngles& angles);

/// Of a picture in which things are so many times as large as at the zoom that the camera was
/// calibrated at: the pixel on which the same direction would lie there.
Eigen::Vector2d pixel_at_calibrated_zoom(const Camera& camera, const Eigen::Vector2d& pixel,
                                         double magnified);

/// The angles that would bring onto the optical axis what is seen at `pixel` while the head tells
/// `angles` (visual servoing, STR-5). A wrong mount of the head in the rig file does not matter to
/// first order: it takes part in both directions. `range_mm` from the camera matters only where a
/// head model has lever arms. `magnified`: so much larger than at the calibrated zoom. Empty where
/// no direction projects to that pixel.
std::optional<HeadAngles> angles_to_centre(const Rig& rig, const HeadAngles& angles,
                                           const Eigen::Vector2d& pixel, double range_mm,
                                           double magnified = 1.0);

}  // namespace kambara
