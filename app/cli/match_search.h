// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <string>

#include "core/base/result.h"
#include "core/image/image.h"
#include "core/matching/search_region.h"

namespace kambara::cli {

/// Where `match` looks, as the command line says it; what is not given is empty.
struct MatchSearchOptions {
    std::string strategy = "full";
    std::string near_px;  ///< X,Y
    std::optional<int> radius_px;
    std::optional<int> step;
    std::string rig;
    std::string left_point_px;  ///< X,Y
    std::optional<int> band_px;
    std::optional<double> nearest_mm;
    std::optional<double> farthest_mm;
};

/// The same, understood.
struct MatchSearch {
    bool window = false;
    bool epipolar = false;
    int step = 1;
    std::optional<Eigen::Vector2d> expected_px;
    Eigen::Vector2d left_point_px = Eigen::Vector2d::Zero();
};

/// Refuses an unknown strategy, options that do not belong to it, and one without what it needs:
/// wrong usage, all of it.
Result<MatchSearch> parse_search(const MatchSearchOptions& options);

/// The region for a template of width x height pixels in the picture. Reads the rig file where the
/// search is along the epipolar curve, and scales it to the picture.
Result<SearchRegion> region_of(const MatchSearchOptions& options, const MatchSearch& search,
                               const Image& picture, int width, int height);

}  // namespace kambara::cli
