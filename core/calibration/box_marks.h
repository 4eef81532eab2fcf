// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/calibration/box_layout.h"
#include "core/calibration/target_view.h"
#include "core/image/image.h"

namespace kambara {

/// The round marks of a target, in its frame.
std::vector<BoxMark> box_marks(const BoxTarget& target);

/// What a picture shows where a view of the target has its marks. A mark that is out of the
/// picture, too small (under 1.6 px across) or faint counts for neither.
struct SeenMarks {
    int present = 0;  ///< dark in the middle and light around
    int absent = 0;   ///< as light in the middle as around
};

/// Looks at the places of the marks. The picture is grey with dark marks on light; `ink` is the
/// level of the boxes seen, px as the view gives them. Any thread.
SeenMarks seen_marks(const Image& grey, const std::vector<BoxMark>& marks, const TargetView& view,
                     double ink);

/// The level at a place between pixels; nothing outside the picture.
std::optional<double> level_between(const Image& grey, const Eigen::Vector2d& place);

}  // namespace kambara
