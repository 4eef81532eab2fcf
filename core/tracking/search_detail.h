// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <vector>

#include "core/image/rectangle.h"
#include "core/matching/score_map.h"

namespace kambara {

/// How a target was looked for in one pair of pictures, for whoever wants to watch: what overlays
/// and correlation maps show.
struct SearchDetail {
    Measure measure = Measure::zncc;
    /// The scores in the left picture, by the template's top-left pixel.
    ScoreMap map;
    /// The template as it was drawn for this search.
    Eigen::Vector2i template_size_px = Eigen::Vector2i::Zero();
    /// The cost that means no likeness at all; for measures that are costs.
    double unlike_cost = 1.0;
    /// The epipolar curve of the match, from near to far, in the right picture.
    std::vector<Eigen::Vector2d> epipolar_px;

    /// The part of the left picture that was looked at.
    Rectangle window() const {
        return {map.positions.x, map.positions.y, map.positions.width + template_size_px.x() - 1,
                map.positions.height + template_size_px.y() - 1};
    }
    /// A score as a likeness in [0, 1], comparable between measures.
    double likeness(double score) const {
        return std::clamp(is_cost(measure) ? 1.0 - score / unlike_cost : score, 0.0, 1.0);
    }
};

}  // namespace kambara
