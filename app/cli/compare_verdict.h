// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/compare_score.h"

namespace kambara::cli {

/// Robustness counts as equal within this.
inline constexpr double equal_shares = 0.005;
/// What is asked of the default method in disturbed water, and up to which distance.
inline constexpr double asked_share = 0.99;
inline constexpr double asked_up_to_lengths = 3.0;

/// What ranks a method in a scene: the frames on target, where there is a truth; else those that
/// are followed there and back.
double robustness(const SceneResult& result, std::size_t method);

/// A method's mean over the scenes.
struct Standing {
    std::size_t method = 0;
    double robustness = 0.0;
    double worst = 0.0;       ///< of the scenes
    double off_target = 0.0;  ///< mean of the scenes that have a truth; NaN if none
    double ms = 0.0;          ///< mean of those where it was Tracking
};

/// All methods, the best first: by robustness, then (where equal) by what is off target, then by
/// time.
std::vector<Standing> standings(const std::vector<SceneResult>& results);

/// Which of the runs has this method.
std::optional<std::size_t> index_of(const std::vector<SceneResult>& results,
                                    const MatchMethod& method);

/// What the numbers of this run say of the method that is shipped: first over all scenes, then a
/// sentence a scene, then by attenuation lengths. Empty without results.
std::vector<std::string> verdict_on(const std::vector<SceneResult>& results,
                                    const MatchMethod& shipped);

}  // namespace kambara::cli
