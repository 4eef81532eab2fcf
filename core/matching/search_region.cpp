// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/matching/search_region.h"

#include <algorithm>
#include <cmath>

namespace kambara {
namespace {

Rectangle about_both(const Rectangle& a, const Rectangle& b) {
    const int left = std::min(a.x, b.x);
    const int top = std::min(a.y, b.y);
    return {left, top, std::max(a.x + a.width, b.x + b.width) - left,
            std::max(a.y + a.height, b.y + b.height) - top};
}

template <class T>
void lay_into(const std::vector<T>& from, const Rectangle& part, std::vector<T>& to,
              const Rectangle& whole) {
    for (int y = 0; y < part.height && !from.empty(); ++y) {
        const auto first = static_cast<std::ptrdiff_t>(y) * part.width;
        const auto there =
            static_cast<std::ptrdiff_t>(part.y + y - whole.y) * whole.width + (part.x - whole.x);
        std::copy_n(from.begin() + first, part.width, to.begin() + there);
    }
}

}  // namespace

Rectangle SearchRegion::bounds() const {
    Rectangle all;
    for (const Rectangle& part : positions) {
        all = all.width == 0 ? part : about_both(all, part);
    }
    return all;
}

SearchRegion full_region(const Image& picture) {
    return {{{0, 0, picture.width(), picture.height()}}};
}

Eigen::Vector2i top_left_for(const Eigen::Vector2d& centre_px, int width, int height) {
    return {static_cast<int>(std::lround(centre_px.x() - 0.5 * (width - 1))),
            static_cast<int>(std::lround(centre_px.y() - 0.5 * (height - 1)))};
}

SearchRegion window_region(const Eigen::Vector2d& centre_px, int radius_px, int width, int height) {
    const Eigen::Vector2i middle = top_left_for(centre_px, width, height);
    return {
        {{middle.x() - radius_px, middle.y() - radius_px, 2 * radius_px + 1, 2 * radius_px + 1}}};
}

void scores_within(Matcher& matcher, const Image& picture, const SearchRegion& region,
                   ScoreMap& map) {
    if (region.positions.size() == 1) {
        matcher.scores(picture, region.positions.front(), map);
        return;
    }
    std::vector<ScoreMap> parts(region.positions.size());
    Rectangle whole;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        matcher.scores(picture, region.positions[i], parts[i]);
        if (!parts[i].empty()) {
            whole = whole.width == 0 ? parts[i].positions : about_both(whole, parts[i].positions);
        }
    }
    const auto size =
        static_cast<std::size_t>(whole.width) * static_cast<std::size_t>(whole.height);
    const bool cost = is_cost(matcher.method().measure);
    map.positions = whole;
    map.costs.assign(cost ? size : 0, not_searched_cost);
    map.scores.assign(cost ? 0 : size, not_searched_score);
    for (const ScoreMap& part : parts) {
        lay_into(part.costs, part.positions, map.costs, whole);
        lay_into(part.scores, part.positions, map.scores, whole);
    }
}

}  // namespace kambara
