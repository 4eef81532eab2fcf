// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/calibration/detected_corners.h"
#include "core/calibration/target.h"
#include "core/image/image.h"

namespace kambara {

/// The corners of a ChArUco board in a grey picture, by the markers around them (OpenCV); any part
/// of the board with six corners or more, not all in a row. The window in which a corner is refined
/// is scaled to the squares' size. Refuses, saying why, a picture with less.
Result<DetectedCorners> detect_charuco(const Image& grey, const CharucoTarget& board);

}  // namespace kambara
