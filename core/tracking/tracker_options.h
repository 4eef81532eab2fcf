// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/stereo/position.h"
#include "core/tracking/epipolar_curve.h"
#include "core/tracking/patch_search.h"

namespace kambara {

struct TrackerOptions {
    PatchSearchOptions search;
    PositionOptions position;
    RangeBounds range;
    int window_radius_px = 24;     ///< left, about the predicted place
    int wide_radius_px = 96;       ///< when the window holds nothing good
    int band_px = 2;               ///< right, on both sides of the epipolar curve
    double right_reach_px = 16.0;  ///< along the curve, about the predicted place
    double good_quality = 0.50;    ///< probably right: Tracking
    /// Beyond doubt: it is not checked whether what was found right leads back to the left.
    double sure_quality = 0.95;
    double back_px = 1.5;                ///< so far off may it lead back
    int slopes_every = 30;               ///< pairs, while no distance is known
    double lost_quality = 0.15;          ///< less than this: Lost
    double found_quality = 0.80;         ///< at least this to take a match far from the prediction
    double unrivalled_quality = 0.65;    ///< at least this where another place in reach looks alike
    double least_distinctness = 0.03;    ///< of a match found without a prediction
    double good_enough_likeness = 0.95;  ///< of a look: no other is tried
    /// Noise takes so much of the likeness that pictures are smoothed before they are compared, if
    /// by zncc; and not any more.
    double dim_clearness = 0.90;
    double clear_clearness = 0.93;
    double update_likeness = 0.93;     ///< a fresh template is cut when what decides fits worse
    double seen_likeness = 0.50;       ///< what is so alike is not lost, however probable
    double blend_share = 0.1;          ///< of a new picture in the mean of what was seen of late
    double update_agreement_px = 3.0;  ///< so far at most may the first template see it elsewhere
    /// How fast a target may cross the picture while its motion is not known.
    double fastest_px_s = 400.0;
    /// How much it may grow and turn from one pair to the next: deviations, against which what is
    /// measured is weighed.
    double growth_sigma = 0.006;
    double turn_sigma_rad = 0.006;
    double farthest_leap = 1.5;  ///< the distance's ratio from one pair to the next
    int doubtful_frames = 30;    ///< that many in a row: Lost
    int give_up_frames = 1800;   ///< lost for that many: back to TemplateSet
    /// The distance taken until the right picture has told it.
    double assumed_range_mm = 1500.0;
    bool automatic_update = true;
    double shown_step_px = 8.0;  ///< between the points of an epipolar curve that is shown
};

}  // namespace kambara
