// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/calibration/box_outline.h"
#include "core/calibration/detected_corners.h"
#include "core/calibration/edge_chain.h"
#include "core/calibration/side_fit.h"
#include "core/calibration/target.h"
#include "core/camera/lens.h"
#include "core/image/image.h"

namespace kambara {

struct BoxDetectorOptions {
    EdgeChainOptions chains;
    /// Makes lines straight. Without it, the boxes' own sides tell how the lens bends lines.
    std::optional<Lens> lens;
    double least_width_px = 5.5;  ///< narrower boxes help to tell which is which, and are left out
};

/// What each stage came to, for those who want to look.
struct BoxStages {
    std::vector<EdgeChain> chains;
    std::vector<Quadrilateral> outlines;  ///< chains that go round a quadrilateral
    std::vector<FittedBox> candidates;    ///< outlines with four sides that could be measured
    std::vector<FittedBox> boxes;         ///< those that are the target's, measured again
    std::vector<int> numbers;             ///< ... and which ones
};

struct BoxDetection {
    DetectedCorners corners;
    int boxes_total = 0;
    std::vector<std::string> remarks;  ///< in sentences: what was left out, and why
};

/// Finds the boxes of a target in a grey picture (calibration: the detection pipeline): closed edge
/// chains, quadrilaterals, sides, grids on the target's planes, identities, and the corners
/// measured again as the lens has them. Any boxes may be missing as long as the others tell which
/// they are (box_identity.h); what the target's own geometry does not explain is no box of it.
/// Refuses with a reason; `stages` is filled as far as it came. Any thread.
Result<BoxDetection> detect_boxes(const Image& grey, const BoxTarget& target,
                                  const BoxDetectorOptions& options = {},
                                  BoxStages* stages = nullptr);

}  // namespace kambara
