// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/camera/rig.h"
#include "core/geometry/rigid_transform.h"
#include "hardware/simulated/lighting.h"
#include "hardware/simulated/pixel_rays.h"
#include "hardware/simulated/scene.h"

namespace kambara {

/// The seabed as a camera sees it, row by row.
template <class Level>
struct SeabedView {
    std::vector<Level> picture;
    /// Where water scatters forward, else empty: the picture without that share, and the share
    /// before it is blurred.
    std::vector<Level> sharp;
    std::vector<Level> scattered;
};

/// Draws a seabed with so many samples across a pixel, and as many down.
template <class Level>
SeabedView<Level> draw_seabed(const Scene& scene, int seabed, const Camera& camera,
                              const PixelRays& rays, const Lighting<Level>& lighting,
                              const RigidTransform& T_camera_from_rig, int samples);

}  // namespace kambara
