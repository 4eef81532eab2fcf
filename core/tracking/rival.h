// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>

#include "core/matching/matcher.h"
#include "core/matching/peak.h"
#include "core/matching/score_map.h"

namespace kambara {

/// Where another place is looked for that might be taken for the target.
struct RivalScope {
    Eigen::Vector2d expected;  ///< the template's top-left position as predicted
    double reach_px = 0.0;     ///< how far off the prediction may be
    int apart_px = 3;          ///< nearer than this to the peak is the same place
};

/// Of two places that look about the same, the one that the prediction allows: the best peak of a
/// map, or where that lies beyond the scope's reach, the best within it if its quality is less by
/// no more than `preferred_by`. Empty for an empty map.
std::optional<Peak> likely_peak(const ScoreMap& map, const Matcher& matcher,
                                const RivalScope& scope, double preferred_by);

/// The quality of the likest other place of a map that the prediction does not rule out: a peak of
/// its own, with a valley between it and the best one, no farther from the expected position than
/// its reach (or than the best one is). Empty where there is none: the slopes of a broad peak are
/// no rivals.
std::optional<double> rival_quality(const ScoreMap& map, const Matcher& matcher, const Peak& peak,
                                    const RivalScope& scope);

}  // namespace kambara
