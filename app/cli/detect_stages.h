// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "core/base/result.h"
#include "core/calibration/box_detector.h"
#include "core/image/image.h"

namespace kambara::cli {

/// Writes a picture of every stage of finding boxes into a folder: 1-edges, 2-chains, 3-centroids,
/// 4-sliding-mean (the method of 1999, to compare), 5-lines, 6-corners, 7-order (.png).
Result<Done> write_box_stages(const std::filesystem::path& folder, const Image& grey,
                              const BoxStages& stages, int boxes);

/// Writes corners with their numbers as 7-order.png.
Result<Done> write_order(const std::filesystem::path& folder, const Image& grey,
                         const DetectedCorners& corners);

}  // namespace kambara::cli
