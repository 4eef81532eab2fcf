// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/cli/compare_command.h"
#include "core/base/result.h"
#include "core/camera/rig.h"
#include "core/image/frame.h"
#include "core/image/rectangle.h"
#include "core/matching/match_method.h"
#include "core/matching/temporal_filter.h"

namespace kambara::cli {

/// What all methods are tried on: pictures in memory, a template in the first of them.
struct CompareScene {
    std::string name;
    Rig rig;
    std::vector<StereoFrame> pairs;  ///< grey
    Rectangle templ;
    std::vector<std::optional<Eigen::Vector3d>>
        truth_in_left_mm;                   ///< a pair each; empty: not known
    double attenuation_lengths_most = 0.0;  ///< one way, camera to target
};

Result<CompareScene> simulated_scene(const std::string& profile, int frames, int template_px);
Result<CompareScene> recorded_scene(const CompareOptions& options);

/// Filters the pictures over time, left and right each, as `track --temporal` does; the name says
/// it.
void low_pass(CompareScene& scene, const TemporalOptions& options);

/// How one method did on one scene, frame by frame.
struct CompareRun {
    MatchMethod method;
    std::vector<std::optional<Eigen::Vector3d>> tracked_in_left_mm;  ///< while Tracking
    double ms_median = 0.0;
    std::optional<Error> refused;  ///< the template could not be taken
};

CompareRun run_method(const CompareScene& scene, const MatchMethod& method);

/// Every measure after every transform that goes with it.
std::vector<MatchMethod> all_methods();

/// The truth, or where there is none the median of what the methods say of each frame, as far as at
/// least three say anything.
std::vector<std::optional<Eigen::Vector3d>> reference_of(const CompareScene& scene,
                                                         const std::vector<CompareRun>& runs);

struct CompareScore {
    double right = 0.0;  ///< share of the frames that have a reference: within 1 % of range of it
    double wrong = 0.0;  ///< likewise: said to be tracked, but farther away than that
    double error_mean_pct = 0.0;  ///< of range, of those that are right; NaN where none is
};

CompareScore score_of(const CompareRun& run,
                      const std::vector<std::optional<Eigen::Vector3d>>& reference);

}  // namespace kambara::cli
