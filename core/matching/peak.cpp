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

template <class Visit>
void for_neighbours(const ScoreMap& map, int x, int y, const Visit& visit) {
    const Rectangle& r = map.positions;
    for (int v = std::max(y - 1, r.y); v <= std::min(y + 1, r.y + r.height - 1); ++v) {
        for (int u = std::max(x - 1, r.x); u <= std::min(x + 1, r.x + r.width - 1); ++u) {
            visit(u, v);
        }
    }
}

// Whether all nine scores about a position, its own included, are there.
bool surrounded(const ScoreMap& map, int x, int y) {
    int there = 0;
    for_neighbours(map, x, y, [&](int u, int v) { there += map.searched(u, v) ? 1 : 0; });
    return there == 9;
}

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
    const Rectangle& r = map.positions;
    Peak peak;
    // First in which rows the best score is: few of them are then looked through.
    int first = r.y;
    int last = r.y - 1;
    for (int y = r.y; y < r.y + r.height && r.width > 0; ++y) {
        const double best = best_of(map, measure, r.x, y, r.width);
        const bool best_so_far = last < first || better(measure, best, peak.score);
        if (best_so_far || best == peak.score) {
            peak.score = best;
            first = best_so_far ? y : first;
            last = y;
        }
    }
    double nearest = 0.0;
    bool found = false;
    for (int y = first; y <= last; ++y) {
        if (first < last && best_of(map, measure, r.x, y, r.width) != peak.score) {
            continue;
        }
        for (int x = r.x; x < r.x + r.width; ++x) {
            if (map.at(x, y) != peak.score || !map.searched(x, y)) {
                continue;
            }
            const double distance =
                expected ? (Eigen::Vector2d(x, y) - *expected).squaredNorm() : 0.0;
            if (!found || distance < nearest) {
                found = true;
                peak.whole_x = x;
                peak.whole_y = y;
                nearest = distance;
            }
        }
    }
    if (!found) {
        return std::nullopt;
    }
    peak.x = peak.whole_x;
    peak.y = peak.whole_y;
    peak.on_border = !surrounded(map, peak.whole_x, peak.whole_y);
    if (const auto part = peak.on_border ? std::nullopt : vertex(map, peak.whole_x, peak.whole_y)) {
        peak.x += part->first;
        peak.y += part->second;
    }
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

bool is_peak(const ScoreMap& map, Measure measure, int x, int y) {
    const double score = map.at(x, y);
    bool bettered = false;
    for_neighbours(map, x, y, [&](int u, int v) {
        bettered = bettered || better(measure, map.at(u, v), score);
    });
    return !bettered;
}

std::optional<double> second_peak(const ScoreMap& map, Measure measure, const Peak& peak,
                                  int distance) {
    const Rectangle& r = map.positions;
    std::optional<double> best;
    for (int y = r.y; y < r.y + r.height; ++y) {
        const bool near_row = std::abs(y - peak.whole_y) <= distance;
        if (best && !better(measure, best_of(map, measure, r.x, y, r.width), *best)) {
            continue;
        }
        for (int x = r.x; x < r.x + r.width; ++x) {
            const double score = map.at(x, y);
            const bool apart = !near_row || std::abs(x - peak.whole_x) > distance;
            if (apart && (!best || better(measure, score, *best)) && map.searched(x, y) &&
                is_peak(map, measure, x, y)) {
                best = score;
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
