// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/target_detector.h"

#include "core/calibration/charuco_detector.h"
#include "core/calibration/chessboard_detector.h"

namespace kambara {

Result<DetectedCorners> detect_target(const Image& grey, const Target& target, const Lens*) {
    if (const auto* board = std::get_if<ChessboardTarget>(&target)) {
        return detect_chessboard(grey, *board);
    }
    if (const auto* board = std::get_if<CharucoTarget>(&target)) {
        return detect_charuco(grey, *board);
    }
    return Error{"A target of " + to_string(target) + " can't be found in pictures.",
                 "Use a chessboard or a ChArUco board."};
}

}  // namespace kambara
