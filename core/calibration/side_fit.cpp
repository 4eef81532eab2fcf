// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/side_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "core/base/median.h"
#include "core/calibration/side_scan.h"

namespace kambara {
namespace {

constexpr int rounds = 3;
constexpr std::size_t least_points = 3;
constexpr double outlier_deviations = 4.0;
constexpr double never_outlier_px = 0.12;
constexpr double prior_weight = 8.0;  // points' worth of trust in the noise that was predicted
constexpr double least_sigma_px = 0.003;

// n . p + c = 0 with n of unit length, and how sure it is at a place along it.
struct FittedLine {
    Eigen::Vector3d line;
    Eigen::Vector2d mean;
    Eigen::Vector2d along;
    double offset_variance = 0.0;
    double slope_variance = 0.0;

    double variance_at(const Eigen::Vector2d& p) const {
        const double t = along.dot(p - mean);
        return offset_variance + t * t * slope_variance;
    }
};

FittedLine orthogonal_line(const std::vector<Eigen::Vector2d>& points) {
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    for (const auto& p : points) {
        mean += p / static_cast<double>(points.size());
    }
    Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
    for (const auto& p : points) {
        scatter += (p - mean) * (p - mean).transpose();
    }
    const double angle = 0.5 * std::atan2(2.0 * scatter(0, 1), scatter(0, 0) - scatter(1, 1));
    const Eigen::Vector2d along(std::cos(angle), std::sin(angle));
    const Eigen::Vector2d normal(-along.y(), along.x());
    return {{normal.x(), normal.y(), -normal.dot(mean)}, mean, along};
}

double beside(const FittedLine& line, const Eigen::Vector2d& p) {
    return std::abs(line.line.head<2>().dot(p) + line.line.z());
}

// Leaves out what lies far beside, and fits again; the side keeps the points that were used.
std::optional<FittedLine> fit_line(SideScan::Edge& edge, const Straightener& straightener,
                                   FittedSide& side) {
    std::vector<Eigen::Vector2d> straight;
    std::vector<Eigen::Vector2d> pixels;
    for (const Eigen::Vector2d& p : edge.points_px) {
        if (const auto place = straightener.straight(p)) {
            straight.push_back(*place);
            pixels.push_back(p);
        }
    }
    if (straight.size() < least_points) {
        return std::nullopt;
    }
    FittedLine line = orthogonal_line(straight);
    std::vector<double> distances;
    distances.reserve(straight.size());
    for (const auto& p : straight) {
        distances.push_back(beside(line, p));
    }
    const double limit =
        std::max(never_outlier_px, outlier_deviations * 1.4826 * median(std::move(distances)));
    std::size_t kept = 0;
    for (std::size_t i = 0; i < straight.size(); ++i) {
        if (beside(line, straight[i]) <= limit) {
            straight[kept] = straight[i];
            pixels[kept] = pixels[i];
            ++kept;
        }
    }
    if (kept < least_points) {
        return std::nullopt;
    }
    if (kept < straight.size()) {
        straight.resize(kept);
        pixels.resize(kept);
        line = orthogonal_line(straight);
    }
    double squares = 0.0;
    double along_squares = 0.0;
    for (const auto& p : straight) {
        squares += std::pow(beside(line, p), 2);
        along_squares += std::pow(line.along.dot(p - line.mean), 2);
    }
    const auto n = static_cast<double>(kept);
    const double variance = (prior_weight * edge.sigma_px * edge.sigma_px + squares) /
                            (prior_weight + std::max(0.0, n - 2.0));
    line.offset_variance = variance / n + edge.common_sigma_px * edge.common_sigma_px;
    line.slope_variance = variance / std::max(1e-9, along_squares);
    side.points_px = std::move(pixels);
    side.sigma_px = std::sqrt(variance);
    side.rms_px = std::sqrt(squares / n);
    side.dark = edge.dark;
    side.light = edge.light;
    return line;
}

// Where two lines meet, in pixels, and the deviation of its coordinates.
bool intersect(const FittedLine& a, const FittedLine& b, const Straightener& straightener,
               Eigen::Vector2d& corner_px, double& sigma_px) {
    const Eigen::Vector3d meet = a.line.cross(b.line);
    if (std::abs(meet.z()) < 0.1) {
        return false;
    }
    const Eigen::Vector2d place = meet.head<2>() / meet.z();
    const auto pixel = straightener.pixel(place);
    if (!pixel) {
        return false;
    }
    Eigen::Matrix2d normals;
    normals << a.line.x(), a.line.y(), b.line.x(), b.line.y();
    const Eigen::Matrix2d inverse = normals.inverse();
    const Eigen::Matrix2d covariance =
        inverse * Eigen::Vector2d(a.variance_at(place), b.variance_at(place)).asDiagonal() *
        inverse.transpose();
    corner_px = *pixel;
    sigma_px = std::sqrt(0.5 * covariance.trace() + least_sigma_px * least_sigma_px);
    return true;
}

// One round: all four sides about the corners as they are known.
bool refine(const Image& grey, const LightOfLevel& light, const SideFitOptions& options,
            const Straightener& straightener, std::array<double, 4>& bow_px, FittedBox& box) {
    std::array<FittedLine, 4> lines;
    double blur_variance = 0.0;
    int blurs = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        const SideScan scan(grey, light, box.corners_px, i, bow_px[i], options);
        auto edge = scan.edge();
        if (!edge) {
            return false;
        }
        const auto line = fit_line(*edge, straightener, box.sides[i]);
        if (!line) {
            return false;
        }
        lines[i] = *line;
        bow_px[i] = scan.bow_of(box.sides[i].points_px);
        if (edge->blur_variance_px2) {
            blur_variance += *edge->blur_variance_px2;
            ++blurs;
        }
    }
    for (std::size_t i = 0; i < 4; ++i) {
        if (!intersect(lines[(i + 3) % 4], lines[i], straightener, box.corners_px[i],
                       box.sigma_px[i])) {
            return false;
        }
    }
    box.blur_px = blurs > 0 ? std::sqrt(std::max(0.0, blur_variance / blurs)) : options.blur_px;
    return true;
}

}  // namespace

LightOfLevel light_of_level(double gamma) {
    LightOfLevel table{};
    for (std::size_t i = 0; i < table.size(); ++i) {
        table[i] = static_cast<float>(255.0 * std::pow(static_cast<double>(i) / 255.0, gamma));
    }
    return table;
}

std::optional<FittedBox> fit_sides(const Image& grey, const LightOfLevel& light,
                                   const Quadrilateral& start, const SideFitOptions& options,
                                   const Straightener& straightener) {
    FittedBox box;
    box.corners_px = start;
    std::array<double, 4> bow_px{};
    for (int round = 0; round < rounds; ++round) {
        if (!refine(grey, light, options, straightener, bow_px, box)) {
            return std::nullopt;
        }
        for (std::size_t i = 0; i < 4; ++i) {
            const double moved = (box.corners_px[i] - start[i]).norm();
            if (!(moved < 3.0 + 0.1 * (start[i] - start[(i + 1) % 4]).norm())) {
                return std::nullopt;  // went off to something else
            }
        }
    }
    return box;
}

}  // namespace kambara
