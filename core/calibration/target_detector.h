// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/calibration/detected_corners.h"
#include "core/calibration/target.h"
#include "core/camera/lens.h"
#include "core/image/image.h"

namespace kambara {

/// Finds a target in a grey picture: its corners by number, sub-pixel, with their deviations; a
/// part of them where the target tells its parts apart. A lens, where one is known, makes straight
/// lines straight for detectors that use them; it need not be exact. Refuses, saying why, a picture
/// in which the target is not found for sure, and a target that can't be found in pictures.
Result<DetectedCorners> detect_target(const Image& grey, const Target& target,
                                      const Lens* lens = nullptr);

}  // namespace kambara
