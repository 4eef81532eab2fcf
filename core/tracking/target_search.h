// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "core/camera/rig.h"
#include "core/image/frame.h"
#include "core/stereo/position.h"
#include "core/tracking/patch.h"
#include "core/tracking/patch_search.h"
#include "core/tracking/tracker_options.h"

namespace kambara {

/// What one patch gave in one pair of pictures.
struct TargetMeasurement {
    PatchMatch left;
    std::optional<PatchMatch> right;
    std::optional<Position> position;
    Eigen::Vector3d point_in_rig_mm;  ///< from the position, or at the expected distance
    std::string fault;                ///< why it is doubtful, or there is no position
    bool ambiguous = false;           ///< the left match may be another thing than the target
    double quality = 0.0;             ///< the weaker of both pictures'
};

struct SearchScope {
    Eigen::Vector3d expected_in_rig_mm;  ///< where the target is thought to be
    /// The distance is a measured one; else it is looked for from near to far.
    bool range_known = false;
    bool lost = false;        ///< nothing is known of late: only a clear match counts
    bool everywhere = false;  ///< when lost: look over the whole left picture
    bool anywhere = false;    ///< when lost: nothing says how far it may have gone
    double reach_px = 24.0;   ///< how far off the expected place may be in the left picture
    bool try_slopes = false;  ///< while the distance is not known: how it leans, which takes time
};

/// Whether a match says nothing of the target: improbable, and little alike as well, since of a
/// place that was predicted likeness alone says something.
bool says_nothing(const TrackerOptions& options, const PatchMatch& match);

/// Looks for a patch: left in a window about the expected place (then in a wider one; once lost,
/// everywhere if so told), right along the epipolar curve, then the position of both. Empty where
/// the expected place can't be seen. A left match of no more than the quality `to_beat` is given
/// as it is, without a look to the right. `detail`, where there is one, is told how it was looked
/// for. Any thread.
std::optional<TargetMeasurement> search_target(const Rig& rig, const TrackerOptions& options,
                                               const ReferencePatch& patch,
                                               const StereoFrame& frame, const SearchScope& scope,
                                               SearchDetail* detail = nullptr,
                                               double to_beat = 0.0);

/// The second half of the above, for a left match that is known already; `look` is what was found
/// there, null where it was cut there.
TargetMeasurement complete_from_left(const Rig& rig, const TrackerOptions& options,
                                     const ReferencePatch* look, const StereoFrame& frame,
                                     const SearchScope& scope, const PatchMatch& left,
                                     SearchDetail* detail = nullptr);

}  // namespace kambara
