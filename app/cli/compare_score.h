// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "app/cli/compare_run.h"
#include "app/cli/compare_scene.h"

namespace kambara::cli {

/// On the target: no farther than this from the reference, in every picture.
inline constexpr double on_target_within_px = 3.0;

/// The truth, or where there is none the median of what the methods say of each frame, as far as at
/// least three say anything.
std::vector<std::optional<Sighting>> reference_of(const CompareScene& scene,
                                                  const std::vector<CompareRun>& runs);

/// Shares of the frames: of those with a truth, or of all where there is no truth at all. Means are
/// over the frames on target, and NaN where there is none.
struct CompareScore {
    double kept = 0.0;        ///< said to be tracked
    double on_target = 0.0;   ///< and on the reference
    double off_target = 0.0;  ///< and away from it
    /// Followed forward and back within on_target_within_px; only of recordings without a truth.
    std::optional<double> there_and_back;
    /// The place given in the left picture, Tracking or Doubtful, is on the reference.
    double found = 0.0;
    double error_px = 0.0;         ///< mean distance from the reference in the left picture
    double range_error_pct = 0.0;  ///< mean, of the reference's range; NaN with one camera
};

CompareScore score_of(const CompareScene& scene, const CompareRun& run,
                      const std::vector<std::optional<Sighting>>& reference);

/// What came of one scene.
struct SceneResult {
    CompareScene scene;  // without its pictures
    std::size_t frames = 0;
    std::vector<CompareRun> runs;  ///< the same methods in every scene
    std::vector<CompareScore> scores;
};

/// Frames on target between two numbers of attenuation lengths.
struct AttenuationBin {
    double from_lengths = 0.0;
    std::size_t frames = 0;
    std::size_t on_target = 0;

    double share() const;
};
inline constexpr double attenuation_bin_lengths = 0.5;

/// One method's frames in all simulated water, by attenuation lengths, up to the farthest there is.
std::vector<AttenuationBin> bins_of(const std::vector<SceneResult>& results, std::size_t method);

/// One method's frames up to so many lengths, in water that is disturbed in every way.
AttenuationBin disturbed_up_to(const std::vector<SceneResult>& results, std::size_t method,
                               double lengths);

}  // namespace kambara::cli
