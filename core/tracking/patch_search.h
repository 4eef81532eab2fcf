// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>

#include "core/matching/match_method.h"
#include "core/matching/transform_cache.h"
#include "core/tracking/epipolar_curve.h"
#include "core/tracking/patch.h"
#include "core/tracking/search_detail.h"

namespace kambara {

/// A planar change with its standard deviations.
struct MeasuredChange {
    PlanarChange value;
    double scale_sigma = 0.0;
    double turn_sigma_rad = 0.0;
};

/// Where a patch was found in a picture.
struct PatchMatch {
    Eigen::Vector2d pixel = Eigen::Vector2d::Zero();  ///< of the reference point, sub-pixel
    Eigen::Matrix2d covariance_px2 = Eigen::Matrix2d::Identity();
    /// The part of it that the noise of the searched picture makes; the rest is the patch's.
    Eigen::Matrix2d covariance_of_picture_px2 = Eigen::Matrix2d::Zero();
    /// Found by a patch cut from the other picture of the same instant, at the match there: errs
    /// with it.
    bool by_other_match = false;
    double likeness = 0.0;        ///< in [0, 1], by the measure alone, as if without noise
    double likeness_kept = 1.0;   ///< by the noise, of what it would be (noise.h)
    double clearness = 1.0;       ///< the same for pictures that are not transformed
    double quality = 0.0;         ///< the probability that it is right (match_quality.h)
    double distinctness = 1.0;    ///< likeness less that of the next best place; 1 if there is none
    std::optional<double> rival;  ///< likeness of another place in reach (rival.h), if any
    double unrivalled = 1.0;      ///< the probability that it is right rather than the rival
    bool on_border = false;       ///< the best may lie outside the region searched
    Eigen::Vector2i size_px = Eigen::Vector2i::Zero();  ///< of the patch as drawn there
    /// How the target has turned and grown beside the patch as it was drawn, where that was asked
    /// for and could be told.
    std::optional<MeasuredChange> change;
    /// How the target's plane leans, where that was searched for (ReferencePatch::slope).
    std::optional<Eigen::Vector2d> slope;

    /// As the pictures have it, noise included.
    double likeness_in_noise() const { return likeness * likeness_kept; }
};

struct PatchSearchOptions {
    MatchMethod method;
    /// Standard deviation added to every match for what drawing the patch and the fit leave without
    /// any noise beyond the rounding of grey levels.
    double floor_px = 0.001;
    /// How a patch is drawn where a match is refined.
    Drawing refined = Drawing::exact;
    bool measure_change = true;  ///< in window searches: how the target has turned and grown
    /// What other searches of the same pictures have transformed; may be null.
    TransformCache* transforms = nullptr;
};

/// Where to look in a window.
struct WindowScope {
    Eigen::Vector3d expected_in_rig_mm;  ///< the reference point as predicted
    int radius_px = 24;                  ///< about where that is seen
    double reach_px = 24.0;              ///< how far off the prediction may well be
};

/// Looks for the patch in a window, then refines: the patch is drawn again at the place found,
/// until it no longer moves, so that the sub-pixel peak is sought around zero shift. `grey` is the
/// picture of `camera`. The distance along the ray is kept as expected. Empty where there is no
/// place to look at. `detail`, where there is one, gets the scores of the window.
std::optional<PatchMatch> search_window(const ReferencePatch& patch, const Camera& left,
                                        const Camera& camera, const Image& grey,
                                        const WindowScope& scope, const PatchSearchOptions& options,
                                        SearchDetail* detail = nullptr);

/// Looks for the patch in the right picture along the epipolar curve of its centre, in a band of
/// `band_px` on both sides and between the bounds. `patch` was cut from the left picture of the
/// same instant: its own distance is the one tried. It is drawn anew every few pixels for the
/// distance that belongs there, and refined as above.
std::optional<PatchMatch> search_epipolar(const ReferencePatch& patch, const Rig& rig,
                                          const Image& right_grey, const RangeBounds& bounds,
                                          int band_px, const PatchSearchOptions& options);

/// Likewise along the curve of `left_px` for a look cut earlier, which is carried from its own
/// place: with less noise than a patch of the same instant where it is the mean of many.
std::optional<PatchMatch> search_epipolar_for(const ReferencePatch& look,
                                              const Eigen::Vector2d& left_px, const Rig& rig,
                                              const Image& right_grey, const RangeBounds& bounds,
                                              int band_px, const PatchSearchOptions& options);

/// As search_epipolar, for a target whose plane may lean and cameras that see it from very
/// different sides: tried over a grid of slopes (up to 35 degrees), then the plane is fitted from
/// where the likest ones were found (plane_fit.h). About as costly as ten searches: for a target
/// that is new, not for every pair. Empty where no plane fits.
std::optional<PatchMatch> search_leaning(const ReferencePatch& patch, const Rig& rig,
                                         const Image& right_grey, const RangeBounds& bounds,
                                         int band_px, const PatchSearchOptions& options);

/// Fits the plane where a match was found; where that leans more than noise explains, the match
/// gets its place, covariance and slope.
void settle_slope(const ReferencePatch& patch, const Rig& rig, const Image& right_grey,
                  const PatchSearchOptions& options, PatchMatch& match);

}  // namespace kambara
