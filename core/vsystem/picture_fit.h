// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/camera/rig.h"
#include "core/image/image.h"
#include "core/vsystem/frame_source.h"

namespace kambara {

/// The rig for the pictures that the grabbers deliver: itself where the sizes agree, scaled where
/// they differ but have the same shape (ACQ-9). Refuses pictures of another shape, left and right
/// pictures of different sizes, and a right source without a right camera in the rig.
Result<Rig> fitted_to_pictures(const Rig& rig, const Grabbers& grabbers);

/// Whether a picture is of the size that the camera is calibrated for.
bool fits(const Image& picture, const Camera& camera);

}  // namespace kambara
