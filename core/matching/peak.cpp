// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/matching/peak.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace kambara {
namespace {

// Vertex of the parabola through (-1, a), (0, b), (1, c), b being the extremum of the three.
double vertex(double a, double b, double c) {
    const double bend = a - 2.0 * b + c;
    return bend == 0.0 ? 0.0 : std::clamp(0.5 * (a - c) / bend, -0.5, 0.5);
}

}  // namespace

std::optional<Peak> best_peak(const ScoreMap& map, Measure measure) {
    if (map.empty()) {
        return std::nullopt;
    }
    const Rectangle& r = map.positions;
    Peak peak;
    peak.whole_x = r.x;
    peak.whole_y = r.y;
    peak.score = map.scores.front();
    for (int y = r.y; y < r.y + r.height; ++y) {
        for (int x = r.x; x < r.x + r.width; ++x) {
            if (better(measure, map.at(x, y), peak.score)) {
                peak.score = map.at(x, y);
                peak.whole_x = x;
                peak.whole_y = y;
            }
        }
    }
    const int x = peak.whole_x;
    const int y = peak.whole_y;
    const bool inside_x = x > r.x && x + 1 < r.x + r.width;
    const bool inside_y = y > r.y && y + 1 < r.y + r.height;
    peak.x = x + (inside_x ? vertex(map.at(x - 1, y), map.at(x, y), map.at(x + 1, y)) : 0.0);
    peak.y = y + (inside_y ? vertex(map.at(x, y - 1), map.at(x, y), map.at(x, y + 1)) : 0.0);
    peak.on_border = !inside_x || !inside_y;
    return peak;
}

std::optional<double> runner_up(const ScoreMap& map, Measure measure, const Peak& peak,
                                int distance) {
    const Rectangle& r = map.positions;
    std::optional<double> best;
    for (int y = r.y; y < r.y + r.height; ++y) {
        for (int x = r.x; x < r.x + r.width; ++x) {
            if (std::abs(x - peak.whole_x) <= distance && std::abs(y - peak.whole_y) <= distance) {
                continue;
            }
            if (!best || better(measure, map.at(x, y), *best)) {
                best = map.at(x, y);
            }
        }
    }
    return best;
}

double quality(Measure measure, double score, const Image& templ) {
    if (measure != Measure::sad) {
        return std::clamp(score, 0.0, 1.0);
    }
    const auto channels = static_cast<std::size_t>(templ.channels());
    double flat = 0.0;
    for (std::size_t channel = 0; channel < channels; ++channel) {
        double sum = 0.0;
        for (int y = 0; y < templ.height(); ++y) {
            for (std::size_t i = channel; i < templ.row_bytes(); i += channels) {
                sum += templ.row(y)[i];
            }
        }
        const double mean = sum / (static_cast<double>(templ.width()) * templ.height());
        for (int y = 0; y < templ.height(); ++y) {
            for (std::size_t i = channel; i < templ.row_bytes(); i += channels) {
                flat += std::abs(templ.row(y)[i] - mean);
            }
        }
    }
    return flat > 0.0 ? std::clamp(1.0 - score / flat, 0.0, 1.0) : 0.0;
}

}  // namespace kambara
