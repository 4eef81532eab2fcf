// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>

#include "core/stereo/ray_pair.h"
#include "core/tracking/patch_search.h"

namespace kambara {
namespace {

constexpr double grid_slope = 0.7;
constexpr double first_step = 0.35;
constexpr double last_step = 0.04;
constexpr double steepest = 1.5;
constexpr double bounds_ratio = 1.06;  // about the distance found, while the slope is refined
constexpr double least_parallax_rad = 3.5e-4;
constexpr double worth_refining = 0.3;  // likeness: less than this is no start

// The distance at which the left pixel's ray passes the match.
std::optional<double> range_of(const Rig& rig, const Eigen::Vector2d& left_px,
                               const PatchMatch& match) {
    const auto rays = ray_pair(rig, left_px, match.pixel, least_parallax_rad);
    if (!rays) {
        return std::nullopt;
    }
    return (rays->meeting.midpoint_mm - rays->left.origin_mm).norm();
}

}  // namespace

std::optional<PatchMatch> search_leaning(const ReferencePatch& patch, const Rig& rig,
                                         const Image& right_grey, const RangeBounds& bounds,
                                         int band_px, const PatchSearchOptions& options) {
    std::optional<PatchMatch> best;
    const auto attempt = [&](const Eigen::Vector2d& slope, const RangeBounds& within) {
        ReferencePatch leaning = patch;
        leaning.slope = slope;
        auto found = search_epipolar(leaning, rig, right_grey, within, band_px, options);
        if (!found || (best && found->likeness <= best->likeness)) {
            return false;
        }
        found->slope = slope;
        best = std::move(found);
        return true;
    };
    for (const double across : {-grid_slope, 0.0, grid_slope}) {
        for (const double down : {-grid_slope, 0.0, grid_slope}) {
            attempt({across, down}, bounds);
        }
    }
    const auto range_mm = best ? range_of(rig, patch.centre_px, *best) : std::nullopt;
    if (!range_mm || best->likeness < worth_refining) {
        return best;
    }
    const RangeBounds near_by{std::max(bounds.nearest_mm, *range_mm / bounds_ratio),
                              std::min(bounds.farthest_mm, *range_mm * bounds_ratio)};
    for (double step = first_step; step > last_step;) {
        bool better = false;
        const Eigen::Vector2d from = *best->slope;
        for (const Eigen::Vector2d& way :
             {Eigen::Vector2d(step, 0.0), Eigen::Vector2d(-step, 0.0), Eigen::Vector2d(0.0, step),
              Eigen::Vector2d(0.0, -step)}) {
            const Eigen::Vector2d slope = from + way;
            better = (slope.norm() <= steepest && attempt(slope, near_by)) || better;
        }
        step *= better ? 1.0 : 0.5;
    }
    // What else looks like it must be seen over all distances, with the slope found.
    const Eigen::Vector2d slope = *best->slope;
    ReferencePatch leaning = patch;
    leaning.slope = slope;
    auto over_all = search_epipolar(leaning, rig, right_grey, bounds, band_px, options);
    if (over_all) {
        over_all->slope = slope;
        return over_all;
    }
    return best;
}

}  // namespace kambara
