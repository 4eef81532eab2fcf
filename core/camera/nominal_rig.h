// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/camera/rig.h"

namespace kambara {

/// The nominal rig of the geometry: 640 x 480, baseline 450 mm, both fixed cameras turned 3 degrees
/// inward, the pan-tilt camera between and above them looking 21 degrees down. For the simulated
/// rig and for tests; a real rig is whatever calibration finds. In water the fixed lenses have the
/// focal lengths and kappa1 that 1999 measured there.
Rig nominal_rig(Medium medium = Medium::air);

/// A camera of which nothing is known but the size of its pictures: a lens without distortion that
/// sees 60 degrees across. For following targets in pictures; what it says of directions is no
/// measurement.
Rig unknown_camera(int width_px, int height_px);

}  // namespace kambara
