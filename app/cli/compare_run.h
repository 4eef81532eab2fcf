// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cli/compare_scene.h"
#include "core/matching/match_method.h"

namespace kambara::cli {

/// Every measure after every transform that goes with it.
std::vector<MatchMethod> all_methods();
/// What the tracker is shipped with.
MatchMethod default_method();
/// Such as "zncc after gradient, every 2nd px".
std::string label_of(const MatchMethod& method);

/// What a method said of a scene, frame by frame.
struct CompareRun {
    MatchMethod method;
    std::vector<std::optional<Sighting>> seen;  ///< while Tracking
    /// The place given in the left picture, Tracking or Doubtful.
    std::vector<std::optional<Eigen::Vector2d>> best_left_px;
    std::optional<Error> refused;  ///< the template could not be taken
    /// Of a recording without a truth: followed back from where it was last seen, as in `seen`.
    std::vector<std::optional<Sighting>> seen_back;
    double ms_median = 0.0;  ///< processor time of a pair while Tracking; NaN where it never was
};

/// Follows the scene's target; back as well where there is no truth. Any thread.
CompareRun run_method(const CompareScene& scene, const MatchMethod& method);

/// The median processor time of a pair, among the scene's first ones in which it is Tracking. To be
/// called while the program does nothing else.
double time_of_method_ms(const CompareScene& scene, const MatchMethod& method);

}  // namespace kambara::cli
