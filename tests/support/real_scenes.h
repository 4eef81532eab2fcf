// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "tests/support/real_searches.h"

namespace kambara::testing_support {

/// A desk mat at rest, over which a hand passes and covers it: what was on the mat is where it was.
Result<SearchSet> searches_on_the_mat(const std::filesystem::path& data, int per_half);
/// The same desk by the other camera.
Result<SearchSet> searches_on_the_mat_from_aside(const std::filesystem::path& data, int per_half);
/// A wall at rest, before which a target moves.
Result<SearchSet> searches_on_the_wall(const std::filesystem::path& data, int per_half);
/// That target, in either picture and from the left to the right one, by its exact truth.
Result<SearchSet> searches_for_the_target(const std::filesystem::path& data, int per_half);
/// A chessboard's corners from the left picture to the right: each looks like many others.
Result<SearchSet> searches_on_the_chessboard(const std::filesystem::path& data, int per_half);
/// Standing things seen from a moving car, by their disparity and the car's poses.
Result<SearchSet> searches_from_the_car(const std::filesystem::path& data, int per_half);

/// The pictures of a recording in grey, from frame `start` on.
Result<std::vector<ImagePtr>> grey_pictures(const std::string& source, int start = 0);

/// One try at a search among the frames [first, end).
using Try = std::function<std::optional<Search>(int first, int end, Random& random)>;
/// Tries until there are `per_half` in each half of the frames, or that often in vain.
SearchSet both_halves(std::string name, const Try& one_try, int frames, int per_half,
                      std::uint64_t seed);

inline constexpr Result<SearchSet> (*real_scenes[])(const std::filesystem::path&, int) = {
    searches_on_the_mat,     searches_on_the_mat_from_aside, searches_on_the_wall,
    searches_for_the_target, searches_on_the_chessboard,     searches_from_the_car,
};

}  // namespace kambara::testing_support
