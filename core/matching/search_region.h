// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "core/image/image.h"
#include "core/image/rectangle.h"
#include "core/matching/matcher.h"
#include "core/matching/score_map.h"

namespace kambara {

/// Where a search looks (correspondence: search strategies): positions of the top-left pixel of
/// what is compared, as rectangles that share no position. They may reach beyond the picture; what
/// lies there is not searched. The region along an epipolar curve is made in core/tracking.
struct SearchRegion {
    std::vector<Rectangle> positions;

    /// The least rectangle of positions about them all.
    Rectangle bounds() const;
};

/// All positions of a picture.
SearchRegion full_region(const Image& picture);

/// The positions at which the centre of a template of width x height pixels is at most `radius_px`
/// from a pixel, in x and in y, after rounding.
SearchRegion window_region(const Eigen::Vector2d& centre_px, int radius_px, int width, int height);

/// The top-left pixel of a template of width x height pixels whose centre is at `centre_px`,
/// rounded.
Eigen::Vector2i top_left_for(const Eigen::Vector2d& centre_px, int width, int height);

/// The scores over a region: transforms and compares within its rectangles and nowhere else. The
/// map covers the region's bounds, clipped to the positions where something could be searched;
/// positions between the rectangles are not_searched(). An empty map where the template fits
/// nowhere in the region.
void scores_within(Matcher& matcher, const Image& picture, const SearchRegion& region,
                   ScoreMap& map);

}  // namespace kambara
