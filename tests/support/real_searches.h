// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/image/image.h"
#include "core/image/rectangle.h"
#include "core/matching/match_method.h"
#include "core/matching/match_quality.h"

namespace kambara::testing_support {

/// A template of one real picture, to be looked for in another, with the place where it truly is.
struct Search {
    ImagePtr from;
    Rectangle templ;
    ImagePtr in;
    Eigen::Vector2d truth_px = Eigen::Vector2d::Zero();  ///< of the template's top-left pixel
    Rectangle positions;                                 ///< where to look
};

/// The searches in one recording: those of its first half in time, and those of its second.
struct SearchSet {
    std::string name;
    std::vector<Search> fit;
    std::vector<Search> held_out;
};

/// `per_half` searches at the most in each half of each recording in the folder, the same on every
/// run, the first of more being the same as fewer. Templates are squares of 11 to 41 px at random
/// textured places; the windows have a radius of 12 to 96 px, about a place up to 1.1 radii from
/// the true one in x and in y, so that one in six does not hold it.
Result<std::vector<SearchSet>> real_searches(const std::filesystem::path& data, int per_half);

/// Random numbers that are the same everywhere.
class Random {
  public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}
    int below(int end) { return static_cast<int>(engine_() % static_cast<std::uint64_t>(end)); }
    double between(double low, double high) {
        return low + (high - low) * static_cast<double>(engine_() >> 11U) * 0x1p-53;
    }

  private:
    std::mt19937_64 engine_;
};

/// A search for the square about `point_px`, which truly is at `truth_px` in the other picture;
/// empty where there is no texture, or where either place is not wholly inside.
std::optional<Search> search_about(const ImagePtr& from, const Eigen::Vector2d& point_px,
                                   const ImagePtr& in, const Eigen::Vector2d& truth_px,
                                   Random& random);

struct MatchSample {
    MatchEvidence evidence;
    bool right = false;  ///< within 2 px of the truth
};

/// What a method finds; searches whose region holds no position are left out.
std::vector<MatchSample> samples_of(const MatchMethod& method, const std::vector<Search>& searches);

}  // namespace kambara::testing_support
