// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/image/image.h"
#include "core/image/rectangle.h"
#include "core/matching/measure.h"

namespace kambara {

/// What a map holds where nothing was compared: worse than any score.
inline constexpr float not_searched_score = std::numeric_limits<float>::lowest();
inline constexpr std::uint32_t not_searched_cost = std::numeric_limits<std::uint32_t>::max();

/// The scores of a template at every position of a rectangle of positions. A position is the
/// picture's pixel under the template's top-left pixel; only full overlap counts.
struct ScoreMap {
    Rectangle positions;        ///< of the template's top-left pixel, in the picture
    std::vector<float> scores;  ///< correlations: positions.height rows of positions.width
    std::vector<std::uint32_t>
        costs;  ///< likewise for SAD and Hamming, exact; one of them is empty

    std::size_t size() const { return scores.size() + costs.size(); }
    bool empty() const { return size() == 0; }
    double value(std::size_t i) const {
        return scores.empty() ? static_cast<double>(costs[i]) : static_cast<double>(scores[i]);
    }
    std::size_t index(int x, int y) const {  ///< by position in the picture
        return static_cast<std::size_t>(y - positions.y) *
                   static_cast<std::size_t>(positions.width) +
               static_cast<std::size_t>(x - positions.x);
    }
    double at(int x, int y) const { return value(index(x, y)); }
    bool searched(std::size_t i) const {
        return scores.empty() ? costs[i] != not_searched_cost : scores[i] != not_searched_score;
    }
    bool searched(int x, int y) const { return searched(index(x, y)); }
};

/// The score of one position, from integer sums: exact up to the last division. Both pictures have
/// the same number of channels; the sums run over all of them. Needs full overlap.
double score_at(Measure measure, const Image& picture, const Image& templ, int x, int y);

/// The largest width and height of a template.
inline constexpr int largest_template_px = 255;

/// The map over `positions`, clipped to where the template fits wholly inside the picture; empty
/// where it fits nowhere.
ScoreMap score_map(Measure measure, const Image& picture, const Image& templ,
                   const Rectangle& positions);

/// All positions at which a template fits: (W - w + 1) x (H - h + 1) of them, or none.
Rectangle all_positions(const Image& picture, const Image& templ);

}  // namespace kambara
