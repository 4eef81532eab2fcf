// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/patch_search.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "core/matching/match_quality.h"
#include "core/matching/matcher.h"
#include "core/matching/noise.h"
#include "core/matching/peak.h"
#include "core/matching/score_map.h"
#include "core/matching/similarity_fit.h"
#include "core/matching/subpixel.h"
#include "core/matching/texture.h"
#include "core/tracking/rival.h"

namespace kambara {
namespace {

constexpr double chunk_px = 6.0;  // along the curve, between two drawings of the patch
constexpr int most_refinements = 4;
// What drawing a patch and the fit leave without any noise: 0.0014 to 0.0024 px by matches in
// noiseless pictures at 1, 2 and 5 m, in the middle of the field and at its edge.
constexpr double exact_sigma_px = 0.0018;
constexpr double fast_sigma_px = 0.015;         // likewise 0.012 to 0.018 px
constexpr double settled_px = 0.3;              // the fit holds for a patch drawn no farther away
constexpr double farthest_fit_px = 0.5;         // from the peak of the scores
constexpr double preferred_by = 0.1;            // so much less alike may the expected place be
constexpr double hidden_share = 0.02;           // of a patch: something lies before the target
constexpr double farthest_refinement_px = 2.0;  // what wanders farther was another place

// By the noise of the recordings that the quality was fitted to: the model knows of that.
constexpr double usual_kept = 0.95;
constexpr double usual_kept_smoothed = 0.99;
// Nothing can be told of what is next to nothing but noise.
constexpr double least_kept = 0.5;
constexpr int least_judged_px = 12;

struct Found {
    PatchMatch match;
    Eigen::Vector2i shift;  // of the whole-pixel peak from where the patch was drawn
};

// Its working memory is kept from search to search.
Matcher& matcher_for(const MatchMethod& method) {
    thread_local Matcher matcher;
    if (matcher.method() != method) {
        matcher = Matcher(method);
    }
    return matcher;
}

std::optional<RenderedPatch> drawn_for(const MatchMethod& method, const ReferencePatch& patch,
                                       const Camera& left, const Camera& camera,
                                       const Eigen::Vector3d& point_in_rig_mm,
                                       Drawing drawing = Drawing::fast) {
    return render_patch(patch, left, camera, point_in_rig_mm, margin_px(method.transform), drawing);
}

// Scores the drawn patch over shifts of up to (across, down) pixels from where it was drawn.
std::optional<Found> match_drawn(const RenderedPatch& drawn, const Image& grey, int across,
                                 int down, const PatchSearchOptions& options, double reach_px = 0.0,
                                 SearchDetail* detail = nullptr) {
    thread_local ScoreMap map;
    Matcher& matcher = matcher_for(options.method);
    const Rectangle inner = drawn.inner();
    const Rectangle positions{drawn.top_left.x() - across, drawn.top_left.y() - down,
                              2 * across + 1, 2 * down + 1};
    matcher.set_template(drawn.picture, inner, drawn.mask_or_null());
    matcher.scores(grey, positions, map, options.transforms);
    const Measure measure = options.method.measure;
    const int apart = apart_px(inner.width, inner.height);
    const RivalScope scope{drawn.top_left.cast<double>(), reach_px, apart};
    const auto peak = likely_peak(map, matcher, scope, preferred_by);
    if (!peak) {
        return std::nullopt;
    }
    Found found;
    found.match.pixel = Eigen::Vector2d(peak->x, peak->y) + drawn.centre;
    found.match.likeness = matcher.quality(peak->score);
    found.match.on_border = peak->on_border;
    found.match.size_px = {inner.width, inner.height};
    found.shift = Eigen::Vector2i(peak->whole_x, peak->whole_y) - drawn.top_left;
    if (const auto next = runner_up(map, measure, *peak, apart)) {
        found.match.distinctness = found.match.likeness - matcher.quality(*next);
    }
    if (reach_px > 0.0) {
        found.match.rival = rival_quality(map, matcher, *peak, scope);
    }
    if (detail != nullptr) {
        detail->measure = measure;
        detail->map = map;
        detail->template_size_px = found.match.size_px;
        detail->unlike_cost = matcher.unlike();
    }
    return found;
}

// How far, across and down, to look about a sample of the curve: halfway to its neighbours, and the
// band beside it.
Eigen::Vector2i reach_to_neighbours(const std::vector<EpipolarSample>& curve, std::size_t i,
                                    int band_px) {
    Eigen::Vector2d farthest = Eigen::Vector2d::Zero();
    for (const std::size_t j : {i - 1, i + 1}) {
        if (j < curve.size()) {
            const Eigen::Vector2d gap = (curve[j].right_px - curve[i].right_px).cwiseAbs();
            farthest = farthest.cwiseMax(gap.cwiseMin(chunk_px));
        }
    }
    return (0.5 * farthest).array().ceil().cast<int>() + band_px;
}

// Draws the patch where it was found, so that the two differ by a part of a pixel only, and fits
// that part; once more where it has moved. Gives the last drawing that fitted.
std::optional<RenderedPatch> refine(PatchMatch& match, const ReferencePatch& patch,
                                    const Camera& left, const Camera& camera, const Image& grey,
                                    const Eigen::Vector3d& expected_in_rig_mm,
                                    const PatchSearchOptions& options) {
    const Eigen::Vector2d start = match.pixel;
    const double drawing_px = options.refined == Drawing::exact ? exact_sigma_px : fast_sigma_px;
    std::optional<RenderedPatch> last;
    for (int i = 0; i < most_refinements; ++i) {
        const auto place = place_at_depth(camera, match.pixel, expected_in_rig_mm.z());
        auto drawn = place ? drawn_for(options.method, patch, left, camera, *place, options.refined)
                           : std::nullopt;
        const auto found = drawn ? match_drawn(*drawn, grey, 2, 2, options) : std::nullopt;
        if (!found || (found->match.pixel - start).norm() > farthest_refinement_px) {
            return last;
        }
        Eigen::Vector2d pixel = found->match.pixel;
        match.covariance_px2 = match_covariance_px2(
            grey, drawn->picture, drawn->inner(), drawn->top_left.x() + found->shift.x(),
            drawn->top_left.y() + found->shift.y(), options.floor_px);
        const auto fitted =
            refine_match(grey, drawn->picture, drawn->inner(), pixel - drawn->centre);
        if (fitted && (fitted->position_px + drawn->centre - pixel).norm() < farthest_fit_px) {
            pixel = fitted->position_px + drawn->centre;
            match.covariance_px2 = fitted->covariance_px2 +
                                   (drawing_px * drawing_px + options.floor_px * options.floor_px) *
                                       Eigen::Matrix2d::Identity();
            match.covariance_of_picture_px2 = 0.5 * fitted->covariance_px2;
        }
        const double moved = (pixel - match.pixel).norm();
        match.pixel = pixel;
        match.likeness = found->match.likeness;
        match.size_px = found->match.size_px;
        last = std::move(drawn);
        if (moved < settled_px) {
            return last;
        }
    }
    return last;
}

// How the target has turned and grown beside the patch as drawn; and where something hides a part
// of it, the place that the rest of it says.
void measure_change(PatchMatch& match, const RenderedPatch& drawn, const Image& grey) {
    const Rectangle inner = drawn.inner();
    const Eigen::Vector2d middle(0.5 * (inner.width - 1), 0.5 * (inner.height - 1));
    const Eigen::Vector2d start = match.pixel - drawn.centre + middle;
    const auto fit = fit_similarity(grey, drawn.picture, inner, start, drawn.mask_or_null());
    if (!fit) {
        return;
    }
    match.change =
        MeasuredChange{{fit->scale, fit->turn_rad}, fit->scale_sigma, fit->turn_sigma_rad};
    const Eigen::Vector2d moved = fit->centre_px - start;
    if (fit->outlier_share > hidden_share && moved.norm() < farthest_fit_px) {
        match.pixel += moved;
    }
}

// What is said of the likenesses as it would be without the pictures' noise: else a target that is
// only dimly seen would count as another thing.
double freed_of_noise(PatchMatch& match, double whole_pixel_likeness, const RenderedPatch& drawn,
                      const Image& grey, const MatchMethod& method) {
    const Rectangle inner = drawn.inner();
    const Eigen::Vector2d at = match.pixel - drawn.centre;
    const Rectangle place{static_cast<int>(std::lround(at.x())),
                          static_cast<int>(std::lround(at.y())), inner.width, inner.height};
    if (std::min(inner.width, inner.height) < least_judged_px) {
        return whole_pixel_likeness;  // what is left of a patch at the picture's edge
    }
    const auto kept_by = [&](Transform transform) {
        return likeness_kept({method.measure, transform}, drawn.picture, inner, grey, place);
    };
    match.clearness = kept_by(Transform::none);
    const bool smoothed = method.transform != Transform::none;
    const double clear = smoothed ? kept_by(method.transform) : match.clearness;
    const double usual = smoothed ? usual_kept_smoothed : usual_kept;
    if (clear < least_kept) {
        return whole_pixel_likeness;
    }
    // No piece has kept less than it shows: fine texture is taken for noise by some part.
    const double kept =
        std::min(1.0, std::max({clear / usual, match.likeness, whole_pixel_likeness}));
    if (match.distinctness < 1.0) {
        match.distinctness /= kept;
    }
    if (match.rival) {
        *match.rival /= kept;
    }
    match.likeness /= kept;
    match.likeness_kept = kept;
    return whole_pixel_likeness / kept;
}

// The quality of a refined match, whose rivals were seen when it was known to whole pixels.
void weigh(PatchMatch& match, double whole_pixel_likeness, const MatchMethod& method) {
    MatchEvidence evidence{match.likeness, std::nullopt};
    if (match.distinctness < 1.0) {
        evidence.runner_up = whole_pixel_likeness - match.distinctness;
    }
    match.quality = match_probability(method, evidence);
    match.distinctness += match.likeness - whole_pixel_likeness;
    match.likeness = std::min(match.likeness, 1.0);
    if (match.rival) {
        match.unrivalled = match_probability(method, {match.likeness, match.rival});
    }
}

// At each sample of the curve the patch is drawn for the distance there: carried to it from where
// it was cut, or, of the same instant, cut at that distance.
std::optional<PatchMatch> search_curve(const std::vector<EpipolarSample>& curve,
                                       const ReferencePatch& patch, bool same_instant,
                                       const Rig& rig, const Image& right_grey, int band_px,
                                       const PatchSearchOptions& options) {
    std::optional<PatchMatch> best;
    Eigen::Vector3d best_place = Eigen::Vector3d::Zero();
    std::vector<std::pair<Eigen::Vector2d, double>> rivals;
    ReferencePatch tried = patch;
    for (std::size_t i = 0; i < curve.size(); ++i) {
        const EpipolarSample& sample = curve[i];
        if (same_instant) {
            tried.point_in_rig_mm = sample.point_in_rig_mm;
        }
        const auto drawn =
            drawn_for(options.method, tried, rig.left, *rig.right, sample.point_in_rig_mm);
        const Eigen::Vector2i reach = reach_to_neighbours(curve, i, band_px);
        const auto found =
            drawn ? match_drawn(*drawn, right_grey, reach.x(), reach.y(), options) : std::nullopt;
        if (!found) {
            continue;
        }
        rivals.emplace_back(found->match.pixel, found->match.likeness);
        if (!best || found->match.likeness > best->likeness) {
            best = found->match;
            best_place = sample.point_in_rig_mm;
        }
    }
    if (!best) {
        return std::nullopt;
    }
    const double apart = std::max(3.0, patch.size_px.minCoeff() / 3.0);
    best->distinctness = 1.0;
    for (const auto& [pixel, likeness] : rivals) {
        if ((pixel - best->pixel).norm() > apart) {
            best->distinctness = std::min(best->distinctness, best->likeness - likeness);
        }
    }
    best->on_border = false;
    if (same_instant) {
        tried.point_in_rig_mm = best_place;
    }
    double whole_pixel_likeness = best->likeness;
    const auto last = refine(*best, tried, rig.left, *rig.right, right_grey, best_place, options);
    if (last) {
        whole_pixel_likeness =
            freed_of_noise(*best, whole_pixel_likeness, *last, right_grey, options.method);
    }
    weigh(*best, whole_pixel_likeness, options.method);
    return best;
}

}  // namespace

std::optional<PatchMatch> search_window(const ReferencePatch& patch, const Camera& left,
                                        const Camera& camera, const Image& grey,
                                        const WindowScope& scope, const PatchSearchOptions& options,
                                        SearchDetail* detail) {
    const auto drawn = drawn_for(options.method, patch, left, camera, scope.expected_in_rig_mm);
    if (!drawn) {
        return std::nullopt;
    }
    auto found = match_drawn(*drawn, grey, scope.radius_px, scope.radius_px, options,
                             scope.reach_px, detail);
    if (!found) {
        return std::nullopt;
    }
    PatchMatch& match = found->match;
    double whole_pixel_likeness = match.likeness;
    const auto last = refine(match, patch, left, camera, grey, scope.expected_in_rig_mm, options);
    if (last && options.measure_change) {
        measure_change(match, *last, grey);
    }
    if (last) {
        whole_pixel_likeness =
            freed_of_noise(match, whole_pixel_likeness, *last, grey, options.method);
    }
    weigh(match, whole_pixel_likeness, options.method);
    return match;
}

std::optional<PatchMatch> search_epipolar(const ReferencePatch& patch, const Rig& rig,
                                          const Image& right_grey, const RangeBounds& bounds,
                                          int band_px, const PatchSearchOptions& options) {
    const auto curve = epipolar_curve(rig, patch.centre_px, bounds, chunk_px);
    return search_curve(curve, patch, true, rig, right_grey, band_px, options);
}

std::optional<PatchMatch> search_epipolar_for(const ReferencePatch& look,
                                              const Eigen::Vector2d& left_px, const Rig& rig,
                                              const Image& right_grey, const RangeBounds& bounds,
                                              int band_px, const PatchSearchOptions& options) {
    const auto curve = epipolar_curve(rig, left_px, bounds, chunk_px);
    return search_curve(curve, look, false, rig, right_grey, band_px, options);
}

}  // namespace kambara
