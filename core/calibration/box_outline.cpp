// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/box_outline.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

namespace kambara {
namespace {

constexpr double least_share_of_hull = 0.69;   // a disc's largest quadrilateral has 0.64
constexpr double least_share_of_chain = 0.75;  // of the hull's area: what a chain may lack to it

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
}

template <class Points>
double area_of(const Points& points) {
    double twice = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        twice += cross(points[i], points[(i + 1) % points.size()]);
    }
    return 0.5 * twice;
}

// Andrew's monotone chain; clockwise on the screen.
std::vector<Eigen::Vector2d> convex_hull(const EdgeChain& chain) {
    std::vector<Eigen::Vector2d> points;
    points.reserve(chain.size());
    for (const auto& p : chain) {
        points.push_back(p.cast<double>());
    }
    std::sort(points.begin(), points.end(), [](const auto& a, const auto& b) {
        return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
    });
    std::vector<Eigen::Vector2d> hull;
    const auto grow = [&](const auto first, const auto last) {
        const std::size_t base = hull.size();
        for (auto p = first; p != last; ++p) {
            while (hull.size() >= base + 2 &&
                   cross(hull.back() - hull[hull.size() - 2], *p - hull.back()) <= 0.0) {
                hull.pop_back();
            }
            hull.push_back(*p);
        }
        hull.pop_back();
    };
    grow(points.begin(), points.end());
    grow(points.rbegin(), points.rend());
    return hull;
}

// For every diagonal, the farthest vertex on either side of it.
Quadrilateral largest_quadrilateral(const std::vector<Eigen::Vector2d>& hull) {
    const std::size_t n = hull.size();
    double best = -1.0;
    Quadrilateral quad{};
    for (std::size_t i = 0; i + 2 < n; ++i) {
        std::size_t right = i + 1;
        for (std::size_t j = i + 2; j < n; ++j) {
            const Eigen::Vector2d diagonal = hull[j] - hull[i];
            const auto distance = [&](std::size_t k) {
                return std::abs(cross(diagonal, hull[k] - hull[i]));
            };
            right = std::max(right, i + 1);
            while (right + 1 < j && distance(right + 1) >= distance(right)) {
                ++right;
            }
            std::size_t left = j;
            for (std::size_t k = j + 1; k < n + i; ++k) {
                if (distance(k % n) > distance(left % n)) {
                    left = k;
                }
            }
            const double area = distance(right) + distance(left % n);
            if (area > best) {
                best = area;
                quad = {hull[i], hull[right], hull[j], hull[left % n]};
            }
        }
    }
    return quad;
}

// Every side moved outward (or, where negative, inward).
std::optional<Quadrilateral> grown(const Quadrilateral& box, double by_px) {
    std::array<Eigen::Vector3d, 4> lines;
    for (std::size_t i = 0; i < 4; ++i) {
        const Eigen::Vector2d along = (box[(i + 1) % 4] - box[i]).normalized();
        const Eigen::Vector2d out(along.y(), -along.x());
        lines[i] = {out.x(), out.y(), -out.dot(box[i]) - by_px};
    }
    Quadrilateral result;
    for (std::size_t i = 0; i < 4; ++i) {
        const Eigen::Vector3d meet = lines[(i + 3) % 4].cross(lines[i]);
        if (std::abs(meet.z()) < 0.1) {
            return std::nullopt;  // sides within six degrees of each other: no corner
        }
        result[i] = meet.head<2>() / meet.z();
    }
    return result;
}

}  // namespace

std::optional<Quadrilateral> box_outline(const EdgeChain& chain) {
    std::vector<Eigen::Vector2d> loop;
    loop.reserve(chain.size());
    for (const auto& p : chain) {
        loop.push_back(p.cast<double>());
    }
    const std::vector<Eigen::Vector2d> hull = convex_hull(chain);
    if (hull.size() < 4) {
        return std::nullopt;
    }
    const double hull_area = area_of(hull);
    if (std::abs(area_of(loop)) < least_share_of_chain * hull_area) {
        return std::nullopt;
    }
    const Quadrilateral quad = largest_quadrilateral(hull);
    if (area_of(quad) < least_share_of_hull * hull_area) {
        return std::nullopt;
    }
    return grown(quad, -0.5);
}

Eigen::Vector2d mean_size_px(const Quadrilateral& box) {
    return {0.5 * ((box[1] - box[0]).norm() + (box[2] - box[3]).norm()),
            0.5 * ((box[3] - box[0]).norm() + (box[2] - box[1]).norm())};
}

Quadrilateral turned(const Quadrilateral& box, int corners) {
    Quadrilateral result;
    for (int i = 0; i < 4; ++i) {
        result[static_cast<std::size_t>(i)] = box[static_cast<std::size_t>((i + corners) % 4)];
    }
    return result;
}

Quadrilateral upright(const Quadrilateral& box) {
    double best = -3.0;
    int choice = 0;
    for (int turn = 0; turn < 4; ++turn) {
        const Quadrilateral b = turned(box, turn);
        const Eigen::Vector2d across = b[1] - b[0] + b[2] - b[3];
        const Eigen::Vector2d down = b[3] - b[0] + b[2] - b[1];
        const double agreement = across.normalized().x() + down.normalized().y();
        if (agreement > best) {
            best = agreement;
            choice = turn;
        }
    }
    return turned(box, choice);
}

}  // namespace kambara
