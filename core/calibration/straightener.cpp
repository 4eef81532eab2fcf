// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/straightener.h"

#include <Eigen/Cholesky>
#include <array>
#include <cmath>
#include <utility>

namespace kambara {
namespace {

constexpr double k1_sigma = 0.1;
constexpr double k2_sigma = 0.1;
constexpr double centre_sigma_of_radius = 1.0 / 30.0;
constexpr int most_iterations = 10;

Eigen::Vector2d straightened(const RadialTerms& t, const Eigen::Vector2d& pixel) {
    const Eigen::Vector2d d = pixel - t.centre_px;
    const double r2 = d.squaredNorm() / (t.radius_px * t.radius_px);
    return t.centre_px + d * (1.0 + r2 * (t.k1 + r2 * t.k2));
}

// Newton's steps on the radius.
std::optional<Eigen::Vector2d> bent(const RadialTerms& t, const Eigen::Vector2d& straight) {
    const Eigen::Vector2d d = straight - t.centre_px;
    const double wanted = d.norm() / t.radius_px;
    if (wanted < 1e-12) {
        return straight;
    }
    double r = wanted;
    for (int i = 0; i < 30; ++i) {
        const double r2 = r * r;
        const double slope = 1.0 + r2 * (3.0 * t.k1 + 5.0 * t.k2 * r2);
        if (slope < 0.1) {
            return std::nullopt;
        }
        const double step = (r * (1.0 + r2 * (t.k1 + r2 * t.k2)) - wanted) / slope;
        r -= step;
        if (std::abs(step) < 1e-13) {
            return t.centre_px + d * (r / wanted);
        }
    }
    return std::nullopt;
}

using Derivatives = Eigen::Matrix<double, Eigen::Dynamic, 5>;  // four parameters, and the residual

struct Equations {
    Eigen::Matrix4d normal;
    Eigen::Vector4d right;
    double cost;
};

RadialTerms moved(const RadialTerms& t, const Eigen::Vector4d& step) {
    RadialTerms result = t;
    result.k1 += step(0);
    result.k2 += step(1);
    result.centre_px += step.tail<2>();
    return result;
}

// How far a pixel lies beside a straight line, measured in pixels where it is (Sampson): in
// straightened coordinates alone, what shrinks the picture would seem to straighten it.
struct Beside {
    Eigen::Vector2d normal;
    double offset = 0.0;

    double stretch(const RadialTerms& t, const Eigen::Vector2d& pixel) const {
        const Eigen::Vector2d d = pixel - t.centre_px;
        const double radius2 = t.radius_px * t.radius_px;
        const double r2 = d.squaredNorm() / radius2;
        return ((1.0 + r2 * (t.k1 + r2 * t.k2)) * normal +
                (2.0 * (t.k1 + 2.0 * t.k2 * r2) / radius2 * d.dot(normal)) * d)
            .norm();
    }
    double operator()(const RadialTerms& t, const Eigen::Vector2d& pixel) const {
        return (normal.dot(straightened(t, pixel)) - offset) / stretch(t, pixel);
    }
};

// The distances of a line's points from their straight line, and how these follow the parameters:
// whatever another offset or direction of the line would take up is taken out of both.
Derivatives beside_line(const RadialTerms& terms, const StraightPoints& line) {
    const auto n = static_cast<Eigen::Index>(line.points_px.size());
    Eigen::Matrix<double, Eigen::Dynamic, 2> q(n, 2);
    for (Eigen::Index i = 0; i < n; ++i) {
        q.row(i) = straightened(terms, line.points_px[static_cast<std::size_t>(i)]);
    }
    const Eigen::RowVector2d mean = q.colwise().mean();
    const Eigen::Matrix<double, Eigen::Dynamic, 2> from_mean = q.rowwise() - mean;
    const Eigen::Matrix2d scatter = from_mean.transpose() * from_mean;
    const double angle = 0.5 * std::atan2(2.0 * scatter(0, 1), scatter(0, 0) - scatter(1, 1));
    const Eigen::Vector2d along(std::cos(angle), std::sin(angle));
    const Eigen::Vector2d across(-along.y(), along.x());
    const Beside beside{across, mean.dot(across.transpose())};
    static const Eigen::Vector4d steps(1e-4, 1e-4, 1e-2, 1e-2);
    std::array<std::pair<RadialTerms, RadialTerms>, 4> beyond;
    for (int k = 0; k < 4; ++k) {
        const Eigen::Vector4d step = steps(k) * Eigen::Vector4d::Unit(k);
        beyond[static_cast<std::size_t>(k)] = {moved(terms, -step), moved(terms, step)};
    }
    Derivatives columns(n, 5);
    Eigen::Matrix<double, Eigen::Dynamic, 2> of_line(n, 2);
    for (Eigen::Index i = 0; i < n; ++i) {
        const Eigen::Vector2d& p = line.points_px[static_cast<std::size_t>(i)];
        for (int k = 0; k < 4; ++k) {
            const auto& [minus, plus] = beyond[static_cast<std::size_t>(k)];
            columns(i, k) = (beside(plus, p) - beside(minus, p)) / (2.0 * steps(k));
        }
        columns(i, 4) = beside(terms, p);
        const double stretch = beside.stretch(terms, p);
        of_line(i, 0) = 1.0 / stretch;
        of_line(i, 1) = from_mean.row(i).dot(along.transpose()) / stretch;
    }
    const Eigen::Matrix2d normal = of_line.transpose() * of_line;
    const Eigen::Matrix<double, 2, 5> taken = normal.ldlt().solve(of_line.transpose() * columns);
    columns -= of_line * taken;
    return columns;
}

}  // namespace

std::optional<Eigen::Vector2d> Straightener::straight(const Eigen::Vector2d& pixel) const {
    if (const auto* terms = std::get_if<RadialTerms>(&model_)) {
        return straightened(*terms, pixel);
    }
    if (const auto* lens = std::get_if<Lens>(&model_)) {
        const auto ray = unproject(*lens, pixel);
        if (!ray || ray->direction.z() <= 0.0) {
            return std::nullopt;
        }
        const PinholeParameters p = pinhole_parameters(*lens);
        const Eigen::Vector3d& d = ray->direction;
        return Eigen::Vector2d(p.fx_px * d.x() / d.z() + p.cx_px,
                               p.fy_px * d.y() / d.z() + p.cy_px);
    }
    return pixel;
}

std::optional<Eigen::Vector2d> Straightener::pixel(const Eigen::Vector2d& straight) const {
    if (const auto* terms = std::get_if<RadialTerms>(&model_)) {
        return bent(*terms, straight);
    }
    if (const auto* lens = std::get_if<Lens>(&model_)) {
        const PinholeParameters p = pinhole_parameters(*lens);
        return project(
            *lens, {(straight.x() - p.cx_px) / p.fx_px, (straight.y() - p.cy_px) / p.fy_px, 1.0});
    }
    return straight;
}

RadialTerms plumb_line_terms(const std::vector<StraightPoints>& lines, const RadialTerms& start) {
    const double centre_sigma = centre_sigma_of_radius * start.radius_px;
    const Eigen::Vector4d weight =
        Eigen::Vector4d(k1_sigma, k2_sigma, centre_sigma, centre_sigma).array().pow(-2.0);
    const auto away_from_start = [&](const RadialTerms& t) {
        return Eigen::Vector4d(t.k1 - start.k1, t.k2 - start.k2,
                               t.centre_px.x() - start.centre_px.x(),
                               t.centre_px.y() - start.centre_px.y());
    };
    const auto equations = [&](const RadialTerms& t) {
        const Eigen::Vector4d away = away_from_start(t);
        Equations e{weight.asDiagonal(), -weight.cwiseProduct(away),
                    away.cwiseProduct(weight).dot(away)};
        for (const StraightPoints& line : lines) {
            if (line.points_px.size() < 3) {
                continue;
            }
            const Derivatives d = beside_line(t, line);
            const double w = 1.0 / (line.sigma_px * line.sigma_px);
            e.normal += w * d.leftCols<4>().transpose() * d.leftCols<4>();
            e.right -= w * d.leftCols<4>().transpose() * d.col(4);
            e.cost += w * d.col(4).squaredNorm();
        }
        return e;
    };
    RadialTerms terms = start;
    Equations here = equations(terms);
    double damping = 1e-3;
    for (int iteration = 0; iteration < most_iterations && damping < 1e6; ++iteration) {
        Eigen::Matrix4d damped = here.normal;
        damped.diagonal() *= 1.0 + damping;
        const Eigen::Vector4d step = damped.ldlt().solve(here.right);
        const RadialTerms next = moved(terms, step);
        const Equations there = equations(next);
        if (there.cost >= here.cost) {
            damping *= 10.0;
            continue;
        }
        const bool settled = here.cost - there.cost < 1e-5 * here.cost;
        terms = next;
        here = there;
        damping *= 0.1;
        if (settled) {
            break;
        }
    }
    const Eigen::Vector4d away = away_from_start(terms);
    const bool astray = std::abs(away(0)) > 3.0 * k1_sigma || std::abs(away(1)) > 3.0 * k2_sigma ||
                        away.tail<2>().norm() > 5.0 * centre_sigma;
    return astray ? start : terms;
}

}  // namespace kambara
