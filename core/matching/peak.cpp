// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/matching/peak.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "core/matching/kernels/kernels.h"

namespace kambara {
namespace {

constexpr double farthest_vertex = 0.75;  // beyond, the nine scores are no quadratic

// The extremum of the quadratic through the nine scores about a whole-pixel peak: differences of
// second order, with the mixed one, since a template's peak is seldom upright.
std::optional<std::pair<double, double>> vertex(const ScoreMap& map, int x, int y) {
    const auto f = [&](int dx, int dy) { return map.at(x + dx, y + dy); };
    const double gx = 0.5 * (f(1, 0) - f(-1, 0));
    const double gy = 0.5 * (f(0, 1) - f(0, -1));
    const double xx = f(1, 0) - 2.0 * f(0, 0) + f(-1, 0);
    const double yy = f(0, 1) - 2.0 * f(0, 0) + f(0, -1);
    const double xy = 0.25 * (f(1, 1) - f(1, -1) - f(-1, 1) + f(-1, -1));
    const double determinant = xx * yy - xy * xy;
    if (!(determinant > 0.0)) {
        return std::nullopt;  // a ridge, a saddle or a plateau
    }
    const double dx = (xy * gy - yy * gx) / determinant;
    const double dy = (xy * gx - xx * gy) / determinant;
    return std::pair(std::clamp(dx, -farthest_vertex, farthest_vertex),
                     std::clamp(dy, -farthest_vertex, farthest_vertex));
}

// The best score of a run of positions.
double best_of(const ScoreMap& map, Measure measure, int x, int y, int count) {
    const std::size_t first = map.index(x, y);
    return is_cost(measure)
               ? static_cast<double>(best_kernels().smallest(map.costs.data() + first, count))
               : static_cast<double>(best_kernels().largest(map.scores.data() + first, count));
}

}  // namespace

std::optional<Peak> best_peak(const ScoreMap& map, Measure measure,
                              std::optional<Eigen::Vector2d> expected) {
    if (map.empty()) {
        return std::nullopt;
    }
    const Rectangle& r = map.positions;
    Peak peak;
    double nearest = 0.0;
    bool found = false;
    for (int y = r.y; y < r.y + r.height; ++y) {
        const double best = best_of(map, measure, r.x, y, r.width);
        if (found && !better(measure, best, peak.score) && best != peak.score) {
            continue;
        }
        for (int x = r.x; x < r.x + r.width; ++x) {
            if (map.at(x, y) != best) {
                continue;
            }
            const double distance =
                expected ? (Eigen::Vector2d(x, y) - *expected).squaredNorm() : 0.0;
            if (!found || better(measure, best, peak.score) || distance < nearest) {
                found = true;
                peak.score = best;
                peak.whole_x = x;
                peak.whole_y = y;
                nearest = distance;
            }
        }
    }
    const int x = peak.whole_x;
    const int y = peak.whole_y;
    const bool inside_x = x > r.x && x + 1 < r.x + r.width;
    const bool inside_y = y > r.y && y + 1 < r.y + r.height;
    peak.x = x;
    peak.y = y;
    if (const auto part = inside_x && inside_y ? vertex(map, x, y) : std::nullopt) {
        peak.x += part->first;
        peak.y += part->second;
    }
    peak.on_border = !inside_x || !inside_y;
    return peak;
}

std::optional<double> runner_up(const ScoreMap& map, Measure measure, const Peak& peak,
                                int distance) {
    const Rectangle& r = map.positions;
    std::optional<double> best;
    const auto look = [&](int x, int y, int count) {
        if (count <= 0) {
            return;
        }
        const double here = best_of(map, measure, x, y, count);
        if (!best || better(measure, here, *best)) {
            best = here;
        }
    };
    for (int y = r.y; y < r.y + r.height; ++y) {
        if (std::abs(y - peak.whole_y) > distance) {
            look(r.x, y, r.width);
            continue;
        }
        const int beyond = std::max(r.x, peak.whole_x + distance + 1);
        look(r.x, y, std::min(r.width, peak.whole_x - distance - r.x));
        look(beyond, y, r.x + r.width - beyond);
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
