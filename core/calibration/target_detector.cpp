// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/target_detector.h"

#include <utility>

#include "core/calibration/box_detector.h"
#include "core/calibration/charuco_detector.h"
#include "core/calibration/chessboard_detector.h"

namespace kambara {

Result<DetectedCorners> detect_target(const Image& grey, const Target& target, const Lens* lens) {
    if (const auto* board = std::get_if<ChessboardTarget>(&target)) {
        return detect_chessboard(grey, *board);
    }
    if (const auto* board = std::get_if<CharucoTarget>(&target)) {
        return detect_charuco(grey, *board);
    }
    if (const auto* boxes = std::get_if<BoxTarget>(&target)) {
        BoxDetectorOptions options;
        if (lens != nullptr) {
            options.lens = *lens;
        }
        auto found = detect_boxes(grey, *boxes, options);
        if (!found) {
            return found.error();
        }
        return std::move(found->corners);
    }
    return Error{"A target of " + to_string(target) + " can't be found in pictures.",
                 "Use boxes, a chessboard or a ChArUco board."};
}

}  // namespace kambara
