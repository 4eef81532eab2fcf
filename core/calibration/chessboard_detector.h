// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/calibration/detected_corners.h"
#include "core/calibration/target.h"
#include "core/image/image.h"

namespace kambara {

/// The board's inner corners in a grey picture, sub-pixel, in the order of corners_in_target_mm (or
/// all in the reverse order: a half turn of the board). The window in which a corner is refined is
/// 0.3 of the distance to its neighbours, so that it holds one corner only, near or far. Refuses a
/// picture in which the whole board is not found, or in which it is too small to be measured.
Result<DetectedCorners> detect_chessboard(const Image& grey, const ChessboardTarget& board);

}  // namespace kambara
