// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/rival.h"

#include <algorithm>
#include <cmath>

namespace kambara {
namespace {

constexpr double valley_depth = 0.02;  // below the lower peak: less may be noise

// Whether the straight way between two places leads through worse ones.
bool valley_between(const ScoreMap& map, const Matcher& matcher, const Eigen::Vector2d& from,
                    const Eigen::Vector2d& to, double quality) {
    const int steps = static_cast<int>(std::ceil((to - from).cwiseAbs().maxCoeff()));
    for (int i = 1; i < steps; ++i) {
        const Eigen::Vector2d at = from + (to - from) * i / steps;
        const double here = matcher.quality(
            map.at(static_cast<int>(std::lround(at.x())), static_cast<int>(std::lround(at.y()))));
        if (here < quality - valley_depth) {
            return true;
        }
    }
    return false;
}

}  // namespace

std::optional<Peak> likely_peak(const ScoreMap& map, const Matcher& matcher,
                                const RivalScope& scope, double preferred_by) {
    const Measure measure = matcher.method().measure;
    const auto best = best_peak(map, measure, scope.expected);
    if (!best || scope.reach_px <= 0.0 ||
        (Eigen::Vector2d(best->whole_x, best->whole_y) - scope.expected).norm() <= scope.reach_px) {
        return best;
    }
    const Rectangle& r = map.positions;
    std::optional<Peak> likely;
    double to_beat = matcher.quality(best->score) - preferred_by;
    for (int y = r.y; y < r.y + r.height; ++y) {
        for (int x = r.x; x < r.x + r.width; ++x) {
            const double quality = matcher.quality(map.at(x, y));
            if (quality > to_beat &&
                (Eigen::Vector2d(x, y) - scope.expected).norm() <= scope.reach_px &&
                is_peak(map, measure, x, y)) {
                to_beat = quality;
                likely = Peak{};
                likely->x = likely->whole_x = x;
                likely->y = likely->whole_y = y;
                likely->score = map.at(x, y);
                likely->on_border =
                    x == r.x || y == r.y || x == r.x + r.width - 1 || y == r.y + r.height - 1;
            }
        }
    }
    return likely ? likely : best;
}

std::optional<double> rival_quality(const ScoreMap& map, const Matcher& matcher, const Peak& peak,
                                    const RivalScope& scope) {
    const Measure measure = matcher.method().measure;
    const Rectangle& r = map.positions;
    const Eigen::Vector2d best(peak.whole_x, peak.whole_y);
    const double reach = std::max(scope.reach_px, (best - scope.expected).norm());
    std::optional<double> likest;
    for (int y = r.y; y < r.y + r.height; ++y) {
        for (int x = r.x; x < r.x + r.width; ++x) {
            const Eigen::Vector2d place(x, y);
            if ((place - scope.expected).norm() > reach ||
                (place - best).cwiseAbs().maxCoeff() <= scope.apart_px) {
                continue;
            }
            const double quality = matcher.quality(map.at(x, y));
            if ((!likest || quality > *likest) && is_peak(map, measure, x, y) &&
                valley_between(map, matcher, best, place, quality)) {
                likest = quality;
            }
        }
    }
    return likest;
}

}  // namespace kambara
