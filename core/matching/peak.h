// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <optional>

#include "core/image/image.h"
#include "core/matching/score_map.h"

namespace kambara {

/// The best position of a map, as a position of the template's top-left pixel.
struct Peak {
    double x = 0.0;  ///< to sub-pixel where the best position has neighbours on both sides
    double y = 0.0;
    int whole_x = 0;  ///< the best whole position
    int whole_y = 0;
    double score = 0.0;      ///< at the whole position
    bool on_border = false;  ///< the best may lie outside the region searched
};

/// The best position; of equal ones the nearest to the one expected, then the first in reading
/// order. Sub-pixel by the extremum of the quadratic through the best score and its eight
/// neighbours, less than a pixel away. Empty for a map in which nothing was searched.
std::optional<Peak> best_peak(const ScoreMap& map, Measure measure,
                              std::optional<Eigen::Vector2d> expected = std::nullopt);

/// The best score farther than `distance` positions (in x or in y) from the peak: what the match
/// must be told apart from. Empty where the map holds no such position.
std::optional<double> runner_up(const ScoreMap& map, Measure measure, const Peak& peak,
                                int distance);

/// So far from a peak begin other peaks: what is nearer is the template laid over itself.
constexpr int apart_px(int width, int height) {
    return std::max(3, std::min(width, height) / 3);
}

/// Whether none of a position's neighbours betters it.
bool is_peak(const ScoreMap& map, Measure measure, int x, int y);

/// The score of the best other peak: the best position farther than `distance` from the peak (in x
/// or in y) that none of its neighbours betters, so that the slope of the peak itself is none.
/// Empty where there is no such position.
std::optional<double> second_peak(const ScoreMap& map, Measure measure, const Peak& peak,
                                  int distance);

/// The normalised quality in [0, 1] of a score, 1 for a perfect match: the score itself for the
/// correlations (negative ones give 0); for SAD 1 - SAD / sum(abs(T - mean T)), 0 where no better
/// than a flat patch of the template's mean.
double quality(Measure measure, double score, const Image& templ);

}  // namespace kambara
