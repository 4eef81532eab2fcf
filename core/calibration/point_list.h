// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/calibration/seen_point.h"

namespace kambara {

/// Points of known place and where one camera or two saw them, with the line each came from.
struct PointList {
    std::vector<SeenPoint> left;   ///< or the only camera's
    std::vector<SeenPoint> right;  ///< as many, or none
    std::vector<int> lines;        ///< counted from 1
};

/// Reads lines `x y z X Y` or, for two cameras, `x y z XL YL XR YR`: mm and px, apart by blanks,
/// commas or semicolons; # begins a comment. All lines are of one kind. Refuses, naming the line,
/// anything else, also numbers that are not finite. Any bytes are safe to pass.
Result<PointList> point_list_from_text(std::string_view text);

}  // namespace kambara
