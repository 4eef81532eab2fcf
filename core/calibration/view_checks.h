// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/calibration/mono_start.h"
#include "core/calibration/rig_views.h"
#include "core/calibration/target.h"

namespace kambara {

/// Whether the corners run the wrong way round: seen in a mirror, or from behind. A list of points
/// tells nothing of that.
bool mirrored(const Target& target, const DetectedCorners& corners);

/// Whether two sights are the same picture: the same corners in the same places.
bool same_picture(const DetectedCorners& a, const DetectedCorners& b);

/// The pose between two cameras on which most views agree, and those that don't.
struct PoseAgreement {
    bool found = false;
    PoseBlock b_from_a{};
    std::vector<int> views;    ///< seen by both
    std::vector<int> against;  ///< of those, the ones that contradict
};

/// Each view by itself tells a pose between the cameras; the one under which the others' corners
/// come out best in camera b is taken (least median), and views far off it contradict: their
/// pictures are not of the same instant, or not of the same target.
PoseAgreement agreed_pose(const std::vector<Eigen::Vector3d>& target_mm, const MonoResult& a,
                          const MonoResult& b);

/// A chessboard looks the same after half a turn: turns b's corners where its rows run against
/// a's. Nothing where the board's ends can be told apart or the corners aren't all there.
void align_half_turn(const ChessboardTarget& board, const DetectedCorners& a, DetectedCorners& b);

}  // namespace kambara
