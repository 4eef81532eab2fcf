// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/epipolar_region.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace kambara {
namespace {

constexpr double step_px = 0.5;  // no whole position along the curve is missed

struct Extent {
    int least;
    int most;
    bool operator==(const Extent&) const = default;
};

// How far the band reaches across at one place along; empty where the curve does not pass.
using Extents = std::vector<std::optional<Extent>>;

void widen(std::optional<Extent>& extent, int across, int band_px) {
    const Extent here{across - band_px, across + band_px};
    extent = extent ? Extent{std::min(extent->least, here.least), std::max(extent->most, here.most)}
                    : here;
}

// Neighbours with the same extent make one rectangle.
std::vector<Rectangle> rectangles_of(const Extents& extents, int first, bool steep) {
    std::vector<Rectangle> rectangles;
    for (std::size_t i = 0; i < extents.size();) {
        std::size_t end = i + 1;
        while (end < extents.size() && extents[end] == extents[i]) {
            ++end;
        }
        if (extents[i]) {
            const int along = first + static_cast<int>(i);
            const int length = static_cast<int>(end - i);
            const int breadth = extents[i]->most - extents[i]->least + 1;
            rectangles.push_back(steep ? Rectangle{extents[i]->least, along, breadth, length}
                                       : Rectangle{along, extents[i]->least, length, breadth});
        }
        i = end;
    }
    return rectangles;
}

}  // namespace

SearchRegion epipolar_region(const Rig& rig, const Eigen::Vector2d& left_px,
                             const RangeBounds& bounds, int band_px, int width, int height) {
    std::vector<Eigen::Vector2i> places;
    for (const auto& sample : epipolar_curve(rig, left_px, bounds, step_px, band_px)) {
        places.push_back(top_left_for(sample.right_px, width, height));
    }
    if (places.empty()) {
        return {};
    }
    Eigen::Vector2i least = places.front();
    Eigen::Vector2i most = least;
    for (const Eigen::Vector2i& place : places) {
        least = least.cwiseMin(place);
        most = most.cwiseMax(place);
    }
    const bool steep = (most - least).y() > (most - least).x();
    const Eigen::Index along = steep ? 1 : 0;
    const int first = least[along] - band_px;
    Extents extents(static_cast<std::size_t>(most[along] + band_px - first + 1));
    for (const Eigen::Vector2i& place : places) {
        for (int reach = -band_px; reach <= band_px; ++reach) {
            widen(extents[static_cast<std::size_t>(place[along] + reach - first)], place[1 - along],
                  band_px);
        }
    }
    return {rectangles_of(extents, first, steep)};
}

}  // namespace kambara
