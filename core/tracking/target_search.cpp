// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/target_search.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <string>
#include <utility>

#include "core/tracking/match_pair.h"

namespace kambara {
namespace {

std::string metres(double length_mm) {
    std::ostringstream text;
    text << std::fixed << std::setprecision(2) << length_mm * 1e-3;
    return text.str();
}

bool is_clear(const TrackerOptions& options, const PatchMatch& found) {
    return found.quality >= options.found_quality &&
           found.distinctness >= options.least_distinctness;
}

std::optional<PatchMatch> find_left(const Rig& rig, const TrackerOptions& options,
                                    const ReferencePatch& patch, const Image& grey,
                                    const SearchScope& scope, SearchDetail* detail) {
    const auto look = [&](int radius_px) {
        return search_window(patch, rig.left, rig.left, grey,
                             {scope.expected_in_rig_mm, radius_px, scope.reach_px}, options.search,
                             detail);
    };
    const auto only_if_clear = [&](std::optional<PatchMatch> found) {
        return found && is_clear(options, *found) ? found : std::nullopt;
    };
    // Once lost, a likeness near by is no reason not to look for a better one elsewhere; and once
    // it may be anywhere, only a look everywhere can tell it from its likes.
    if (scope.lost && scope.everywhere) {
        return only_if_clear(look(std::max(grey.width(), grey.height())));
    }
    if (scope.lost && scope.reach_px > options.wide_radius_px) {
        return std::nullopt;
    }
    const double reach_px = std::min(scope.reach_px, static_cast<double>(options.wide_radius_px));
    auto near_by = look(std::max(options.window_radius_px, static_cast<int>(std::ceil(reach_px))));
    if (scope.lost) {
        return only_if_clear(near_by);
    }
    // A best place on the window's edge is a sign of a better one beyond.
    if (near_by && near_by->quality >= options.good_quality && !near_by->on_border) {
        return near_by;
    }
    // Beyond the window no prediction tells the target from its likes: it must be a clear case.
    const auto farther = only_if_clear(look(options.wide_radius_px));
    return farther ? farther : near_by;
}

// Why a match in the left picture may not be the target; empty where it may well be.
std::string doubt_of(const Rig& rig, const TrackerOptions& options, const PatchMatch& left,
                     const SearchScope& scope) {
    if (left.unrivalled < options.unrivalled_quality) {
        return "another place where it may be looks the same";
    }
    const auto expected = rig.left.project(scope.expected_in_rig_mm);
    const bool beyond_reach = expected && (left.pixel - *expected).norm() > scope.reach_px;
    if (beyond_reach && !scope.lost && !is_clear(options, left)) {
        return "what looks most like it is not where it may be";
    }
    if (beyond_reach && scope.lost && !scope.anywhere) {
        return "what looks like it is farther away than it can have gone";
    }
    return {};
}

// The distances whose right pixels lie within reach of the one expected.
RangeBounds bounds_about(const Rig& rig, const TrackerOptions& options,
                         const Eigen::Vector2d& left_px, double range_mm) {
    const auto ray = rig.left.unproject(left_px);
    constexpr double step = 1.01;
    const auto here = ray ? rig.right->project(ray->at(range_mm)) : std::nullopt;
    const auto nearer = ray ? rig.right->project(ray->at(range_mm / step)) : std::nullopt;
    if (!here || !nearer) {
        return options.range;
    }
    const double inverse = 1.0 / range_mm;
    const double px_by_inverse = (*nearer - *here).norm() / (inverse * (step - 1.0));
    if (px_by_inverse <= 0.0) {
        return options.range;
    }
    const double reach = options.right_reach_px / px_by_inverse;
    RangeBounds bounds;
    bounds.nearest_mm = std::max(options.range.nearest_mm, 1.0 / (inverse + reach));
    bounds.farthest_mm = std::min(options.range.farthest_mm,
                                  1.0 / std::max(inverse - reach, 1.0 / options.range.farthest_mm));
    return bounds;
}

// A target that is followed does not change its distance at a stroke: another place in the right
// picture was taken for it.
std::optional<std::string> leapt(const Rig& rig, const TrackerOptions& options,
                                 const SearchScope& scope, const Position& position) {
    const double range_mm = position.point_in_left_mm.norm();
    const double expected_mm =
        (scope.expected_in_rig_mm - rig.left.T_camera_from_rig.centre_mm()).norm();
    const double ratio = range_mm / expected_mm;
    if (!scope.range_known || scope.lost || std::max(ratio, 1.0 / ratio) <= options.farthest_leap) {
        return std::nullopt;
    }
    return "its distance would have leapt from " + metres(expected_mm) + " to " + metres(range_mm) +
           " m";
}

bool leaps(const Rig& rig, const TrackerOptions& options, const SearchScope& scope,
           const PatchMatch& left, const PatchMatch& right) {
    const auto position = position_from_pair(rig, pair_of(rig, left, right), options.position);
    return !position || leapt(rig, options, scope, *position);
}

// The patch is cut anew from the left picture: both pictures show the same instant, so the two
// sides differ by the change of view alone, and what the left match may be off by, the right one
// is off by as well.
std::optional<PatchMatch> find_right(const Rig& rig, const TrackerOptions& options,
                                     const ReferencePatch* look, const StereoFrame& frame,
                                     const PatchMatch& left, const SearchScope& scope) {
    ReferencePatch patch{frame.left.picture, left.pixel, left.size_px, scope.expected_in_rig_mm};
    if (look != nullptr) {
        patch.slope = look->slope_now();
    }
    const Image& grey = *frame.right.picture;
    const auto by_left = [](std::optional<PatchMatch> match) {
        if (match) {
            match->by_other_match = true;
        }
        return match;
    };
    std::optional<PatchMatch> best;
    if (scope.range_known) {
        const double range_mm =
            (scope.expected_in_rig_mm - rig.left.T_camera_from_rig.centre_mm()).norm();
        const RangeBounds near_by = bounds_about(rig, options, left.pixel, range_mm);
        best = by_left(search_epipolar(patch, rig, grey, near_by, options.band_px, options.search));
        if (best && best->quality >= options.good_quality) {
            return best;
        }
        // Two dim pictures may have too little in common where a look freed of noise has enough.
        if (look != nullptr && left.clearness < options.clear_clearness) {
            auto by_look = search_epipolar_for(*look, left.pixel, rig, grey, near_by,
                                               options.band_px, options.search);
            if (by_look && (!best || by_look->quality > best->quality)) {
                best = std::move(by_look);
            }
            if (best && best->quality >= options.good_quality) {
                return best;
            }
        }
    }
    auto anywhere =
        by_left(search_epipolar(patch, rig, grey, options.range, options.band_px, options.search));
    // How it leans is found once, while all else is new as well.
    if (scope.try_slopes && !scope.range_known) {
        if (!(anywhere && is_clear(options, *anywhere))) {
            auto leaning = by_left(
                search_leaning(patch, rig, grey, options.range, options.band_px, options.search));
            if (leaning && (!anywhere || leaning->quality > anywhere->quality)) {
                anywhere = std::move(leaning);
            }
        } else {
            settle_slope(patch, rig, grey, options.search, *anywhere);
        }
    }
    if (!best || (anywhere && anywhere->quality > best->quality &&
                  (best->likeness < options.seen_likeness ||
                   !leaps(rig, options, scope, left, *anywhere)))) {
        return anywhere;
    }
    return best;
}

// Left-right consistency (COR-8): a patch of the right picture, looked for in the left one, is
// found where it came from. A match beyond doubt is spared the effort.
bool leads_back(const Rig& rig, const TrackerOptions& options, const ReferencePatch* look,
                const StereoFrame& frame, const PatchMatch& left, const PatchMatch& right) {
    if (right.quality >= options.sure_quality && !right.slope) {
        return true;
    }
    const auto position = position_from_pair(rig, pair_of(rig, left, right), options.position);
    if (!position) {
        return true;  // refused for that
    }
    const Eigen::Vector3d point_in_rig_mm =
        rig.left.T_camera_from_rig.inverse() * position->point_in_left_mm;
    ReferencePatch patch{frame.right.picture, right.pixel, right.size_px, point_in_rig_mm};
    patch.slope = right.slope       ? *right.slope
                  : look != nullptr ? look->slope_now()
                                    : Eigen::Vector2d::Zero();
    PatchSearchOptions search = options.search;
    search.measure_change = false;
    const int radius_px = static_cast<int>(std::ceil(2.0 * options.back_px));
    const auto back = search_window(patch, *rig.right, rig.left, *frame.left.picture,
                                    {point_in_rig_mm, radius_px, 0.0}, search);
    return !back || (back->pixel - left.pixel).norm() <= options.back_px;  // cut off: not told
}

struct RightMatch {
    std::optional<PatchMatch> match;
    bool leads_back = true;
};

// What was found near the expected distance and does not lead back was taken for the target: it is
// looked for at all distances.
RightMatch find_right_and_back(const Rig& rig, const TrackerOptions& options,
                               const ReferencePatch* look, const StereoFrame& frame,
                               const PatchMatch& left, SearchScope scope) {
    RightMatch found;
    for (;;) {
        found.match = find_right(rig, options, look, frame, left, scope);
        found.leads_back = !found.match || says_nothing(options, *found.match) ||
                           leads_back(rig, options, look, frame, left, *found.match);
        if (found.leads_back || !scope.range_known) {
            return found;
        }
        scope.range_known = false;
        scope.try_slopes = false;
    }
}

}  // namespace

bool says_nothing(const TrackerOptions& options, const PatchMatch& match) {
    return match.quality < options.lost_quality && match.likeness < options.seen_likeness;
}

TargetMeasurement complete_from_left(const Rig& rig, const TrackerOptions& options,
                                     const ReferencePatch* look, const StereoFrame& frame,
                                     const SearchScope& scope, const PatchMatch& left,
                                     SearchDetail* detail) {
    TargetMeasurement result;
    result.left = left;
    result.quality = left.quality;
    result.point_in_rig_mm = scope.expected_in_rig_mm;
    if (const auto ray = rig.left.unproject(left.pixel)) {
        const Eigen::Vector3d eye = rig.left.T_camera_from_rig.centre_mm();
        result.point_in_rig_mm = ray->at((scope.expected_in_rig_mm - eye).norm());
    }
    result.fault = doubt_of(rig, options, left, scope);
    if (!result.fault.empty()) {
        result.ambiguous = true;
        return result;
    }
    if (!rig.right || !frame.right.picture) {
        return result;  // one camera alone gives a direction, and that is no fault
    }
    if (detail != nullptr) {
        for (const auto& sample :
             epipolar_curve(rig, left.pixel, options.range, options.shown_step_px)) {
            detail->epipolar_px.push_back(sample.right_px);
        }
    }
    RightMatch found = find_right_and_back(rig, options, look, frame, left, scope);
    result.right = std::move(found.match);
    if (!result.right || says_nothing(options, *result.right)) {
        result.right.reset();
        result.fault = "not found in the right picture";
        return result;
    }
    result.quality = std::min(left.quality, result.right->quality);
    if (result.right->distinctness < options.least_distinctness) {
        result.fault = "the right picture holds another place that looks the same";
        return result;
    }
    const auto position =
        position_from_pair(rig, pair_of(rig, left, *result.right), options.position);
    if (!position) {
        result.fault = "no position: " + position.error().cause;
        return result;
    }
    if (!found.leads_back) {
        result.fault = "what was found in the right picture leads back to another place";
        return result;
    }
    if (const auto leap = leapt(rig, options, scope, *position)) {
        result.fault = *leap;
        return result;
    }
    result.position = *position;
    result.point_in_rig_mm = rig.left.T_camera_from_rig.inverse() * position->point_in_left_mm;
    return result;
}

std::optional<TargetMeasurement> search_target(const Rig& rig, const TrackerOptions& options,
                                               const ReferencePatch& patch,
                                               const StereoFrame& frame, const SearchScope& scope,
                                               SearchDetail* detail, double to_beat) {
    const auto left = find_left(rig, options, patch, *frame.left.picture, scope, detail);
    if (!left) {
        return std::nullopt;
    }
    if (left->quality <= to_beat) {
        TargetMeasurement no_better;
        no_better.left = *left;
        no_better.quality = left->quality;
        no_better.point_in_rig_mm = scope.expected_in_rig_mm;
        return no_better;
    }
    return complete_from_left(rig, options, &patch, frame, scope, *left, detail);
}

}  // namespace kambara
