// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/calibration/target.h"
#include "hardware/simulated/seabed_view.h"
#include "hardware/simulated/sheet.h"

namespace kambara {

/// Draws the target's sheets, which are given in the camera's frame, into a picture of the seabed.
/// `blur_px` is the blur of the share that water scatters forward, where it does.
template <class Level>
void draw_target(std::vector<Level>& picture, const SeabedView<Level>& seabed, const Scene& scene,
                 const Camera& camera, const PixelRays& rays, const Lighting<Level>& lighting,
                 const std::vector<TargetPatch>& sheets_in_camera, double blur_px);

}  // namespace kambara
