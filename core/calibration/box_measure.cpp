// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/box_measure.h"

#include <algorithm>
#include <cmath>

namespace kambara {
namespace {

constexpr double broad_px = 16.0;  // from here on, sides have rows enough of their own
constexpr int rounds = 2;

}  // namespace

double breadth_px(const Quadrilateral& box) {
    const Eigen::Vector2d across = 0.5 * (box[1] - box[0] + box[2] - box[3]);
    const Eigen::Vector2d down = 0.5 * (box[3] - box[0] + box[2] - box[1]);
    const double area = std::abs(across.x() * down.y() - across.y() * down.x());
    return area / std::max({1e-9, across.norm(), down.norm()});
}

std::vector<std::optional<FittedBox>> BoxMeasure::each(
    const std::vector<Quadrilateral>& starts) const {
    std::vector<std::optional<FittedBox>> boxes;
    std::vector<Quadrilateral> corners = starts;
    BoxCoverage all(grey_.width(), grey_.height(), options_.blur_px);
    for (std::size_t i = 0; i < starts.size(); ++i) {
        boxes.push_back(fit_sides(grey_, light_, starts[i], options_));
        if (boxes[i]) {
            corners[i] = boxes[i]->corners_px;
        }
        if (breadth_px(corners[i]) < broad_px) {
            all.add(corners[i], {}, 1.0);
        }
    }
    // Those without rows of their own, by all their pixels; again where a neighbour stood wrong.
    for (int round = 0; round < rounds; ++round) {
        for (std::size_t i = 0; i < starts.size(); ++i) {
            if (boxes[i] || breadth_px(corners[i]) >= broad_px) {
                continue;
            }
            all.add(corners[i], {}, -1.0);
            boxes[i] = fit_area(grey_, light_, corners[i], options_, all);
            if (boxes[i]) {
                corners[i] = boxes[i]->corners_px;
            }
            all.add(corners[i], {}, 1.0);
        }
    }
    return boxes;
}

std::vector<std::optional<FittedBox>> BoxMeasure::together(const std::vector<Quadrilateral>& starts,
                                                           const Straightener& straightener) const {
    std::vector<std::optional<FittedBox>> boxes(starts.size());
    std::vector<Quadrilateral> corners = starts;
    for (int round = 0; round < rounds; ++round) {
        BoxCoverage all(grey_.width(), grey_.height(), options_.blur_px);
        for (const Quadrilateral& c : corners) {
            all.add(c, straightener, 1.0);
        }
        for (std::size_t i = 0; i < corners.size(); ++i) {
            if (breadth_px(corners[i]) >= broad_px) {
                if (round == 0) {
                    boxes[i] = fit_sides(grey_, light_, corners[i], options_, straightener);
                }
                continue;
            }
            all.add(corners[i], straightener, -1.0);
            boxes[i] = fit_area(grey_, light_, corners[i], options_, all, straightener);
            if (boxes[i]) {
                corners[i] = boxes[i]->corners_px;
            }
            all.add(corners[i], straightener, 1.0);
        }
    }
    return boxes;
}

}  // namespace kambara
