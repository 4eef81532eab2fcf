// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

namespace kambara {

/// Distance along z of a point seen by two parallel pinhole cameras side by side:
/// range = baseline f / (disparity pixel size), disparity = left column - right column. For
/// comparison only (geometry: position). Refuses a disparity that is not positive.
Result<double> parallel_range_mm(double baseline_mm, double f_mm, double disparity_px,
                                 double pixel_size_mm);

}  // namespace kambara
