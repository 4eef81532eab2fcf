// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/camera/rig.h"
#include "core/geometry/rigid_transform.h"
#include "hardware/simulated/lighting.h"
#include "hardware/simulated/scene.h"
#include "hardware/simulated/sheet.h"

namespace kambara {

/// Adds the specks that drift in the water to a picture, but for those behind the sheets, which
/// are in the camera's frame.
template <class Level>
void draw_specks(std::vector<Level>& picture, const Scene& scene, double time_s,
                 const Camera& camera, const Lighting<Level>& lighting,
                 const RigidTransform& T_camera_from_rig, const std::vector<Sheet>& sheets);

/// Draws marine snow over a picture, the farthest flakes first: discs, out of focus when near,
/// that hide what is behind them and are dimmed by the water before them.
template <class Level>
void draw_snow(std::vector<Level>& picture, const Scene& scene, double time_s, const Camera& camera,
               const Lighting<Level>& lighting, const RigidTransform& T_camera_from_rig,
               const std::vector<Sheet>& sheets);

}  // namespace kambara
