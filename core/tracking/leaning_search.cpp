// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>
#include <vector>

#include "core/stereo/ray_pair.h"
#include "core/tracking/mean_slope.h"
#include "core/tracking/patch_search.h"
#include "core/tracking/plane_fit.h"

namespace kambara {
namespace {

constexpr double grid_slope = 0.7;
constexpr double least_parallax_rad = 3.5e-4;
constexpr double worth_fitting = 0.3;  // likeness: less than this is no start
constexpr std::size_t most_starts = 3;
constexpr double same_place_px = 3.0;

// From the distance at which the left pixel's ray passes the match.
std::optional<PlaneFit> fit_from(const ReferencePatch& patch, const Rig& rig,
                                 const Image& right_grey, const PatchMatch& match) {
    const auto rays = ray_pair(rig, patch.centre_px, match.pixel, least_parallax_rad);
    return rays ? fit_plane(patch, rig, right_grey, rays->meeting.distance_a_mm) : std::nullopt;
}

void take(const PlaneFit& fit, const PatchSearchOptions& options, PatchMatch& match) {
    match.slope = fit.slope;
    match.pixel = fit.right_px;
    match.covariance_px2 =
        fit.covariance_px2 + options.floor_px * options.floor_px * Eigen::Matrix2d::Identity();
    match.covariance_of_picture_px2 = 0.5 * fit.covariance_px2;  // both pictures' noise is alike
}

}  // namespace

std::optional<PatchMatch> search_leaning(const ReferencePatch& patch, const Rig& rig,
                                         const Image& right_grey, const RangeBounds& bounds,
                                         int band_px, const PatchSearchOptions& options) {
    std::vector<PatchMatch> starts;
    ReferencePatch leaning = patch;
    for (const double across : {-grid_slope, 0.0, grid_slope}) {
        for (const double down : {-grid_slope, 0.0, grid_slope}) {
            leaning.slope = {across, down};
            auto found = search_epipolar(leaning, rig, right_grey, bounds, band_px, options);
            if (found && found->likeness >= worth_fitting) {
                found->slope = leaning.slope;
                starts.push_back(std::move(*found));
            }
        }
    }
    std::sort(starts.begin(), starts.end(),
              [](const auto& a, const auto& b) { return a.likeness > b.likeness; });
    starts.resize(std::min(starts.size(), most_starts));
    std::optional<PlaneFit> fit;
    for (const PatchMatch& start : starts) {
        leaning.slope = *start.slope;
        auto plane = fit_from(leaning, rig, right_grey, start);
        if (plane && (!fit || plane->likeness > fit->likeness)) {
            fit = std::move(plane);
        }
    }
    if (!fit) {
        return std::nullopt;
    }
    // What else looks like it must be seen over all distances, with the slope found.
    leaning.slope = fit->slope;
    auto match = search_epipolar(leaning, rig, right_grey, bounds, band_px, options);
    if (!match) {
        return std::nullopt;
    }
    match->slope = fit->slope;
    if ((match->pixel - fit->right_px).norm() < same_place_px) {
        take(*fit, options, *match);
    }
    return match;
}

void settle_slope(const ReferencePatch& patch, const Rig& rig, const Image& right_grey,
                  const PatchSearchOptions& options, PatchMatch& match) {
    const auto fit = fit_from(patch, rig, right_grey, match);
    if (fit && fit->likeness >= match.likeness_in_noise() &&
        leans_otherwise(fit->slope, patch.slope, fit->slope_covariance)) {
        take(*fit, options, match);
    }
}

}  // namespace kambara
