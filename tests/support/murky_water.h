// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "core/camera/rig.h"
#include "core/image/frame.h"
#include "core/image/rectangle.h"
#include "core/matching/match_method.h"

namespace kambara {

/// The simulated target in murky water, up to 3 attenuation lengths away: with particles, a
/// brightness step of 40 % every 3 s, and the seabed swapped every 2 s.
struct MurkyScene {
    Rig rig;
    Rectangle templ;  ///< 0.7 of the target's side, as an operator would draw it
    std::vector<StereoFrame> pairs;
    std::vector<Eigen::Vector3d> truth_in_left_mm;  ///< of the template's centre
    double attenuation_per_m = 0.0;
};

/// What is said of the water and the path in a simulated profile, for an attenuation of 0.5 per m
/// (2 to 5.8 m away) and 1.5 per m (0.9 to 1.9 m).
inline constexpr std::array murky_waters = {"haze=0.5&nearest=2&farthest=5.8",
                                            "haze=1.5&nearest=0.9&farthest=1.9"};

MurkyScene murky_scene(const std::string& water, int seed, double seconds);

/// Counts of frames by attenuation lengths (one way), half a length each.
struct KeptFrames {
    static constexpr double bin_lengths = 0.5;
    static constexpr std::size_t bins = 8;
    static constexpr std::size_t bins_to_3_lengths = 6;
    std::array<int, bins> frames{};
    std::array<int, bins> kept{};   ///< Tracking; left within 2 px, the position within 3 %
    std::array<int, bins> wrong{};  ///< Tracking, but not there
    int refused = 0;                ///< templates

    double kept_to_3_lengths() const;   ///< share; 0 without frames
    double wrong_to_3_lengths() const;  ///< likewise
};

/// Follows the target by the method and adds to the counts.
void follow(const MurkyScene& scene, const MatchMethod& method, KeptFrames& counts);

}  // namespace kambara
