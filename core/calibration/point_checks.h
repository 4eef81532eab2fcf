// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/base/error.h"
#include "core/calibration/seen_point.h"

namespace kambara {

/// Why points can't calibrate a camera, whatever the camera: too few, not finite, given twice, on
/// one line, on one plane (or not on one, as asked). `labels` names the points; from 1 where empty.
std::optional<Error> fault_of(const std::vector<SeenPoint>& points, bool coplanar,
                              const std::vector<int>& labels);

}  // namespace kambara
