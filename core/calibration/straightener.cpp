// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/straightener.h"

#include <Eigen/Cholesky>
#include <cmath>

namespace kambara {
namespace {

constexpr double k1_sigma = 0.3;
constexpr double k2_sigma = 0.1;
constexpr double centre_sigma_of_width = 0.05;

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

RadialTerms moved(const RadialTerms& t, const Eigen::Vector4d& step) {
    RadialTerms result = t;
    result.k1 += step(0);
    result.k2 += step(1);
    result.centre_px += step.tail<2>();
    return result;
}

// How far a line's points lie beside their straight line, and how that follows the parameters:
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
    Derivatives columns(n, 5);
    columns.col(4) = from_mean * across;
    static const Eigen::Vector4d steps(1e-4, 1e-4, 1e-2, 1e-2);
    for (int k = 0; k < 4; ++k) {
        const Eigen::Vector4d step = steps(k) * Eigen::Vector4d::Unit(k);
        const RadialTerms plus = moved(terms, step);
        const RadialTerms minus = moved(terms, -step);
        for (Eigen::Index i = 0; i < n; ++i) {
            const Eigen::Vector2d& p = line.points_px[static_cast<std::size_t>(i)];
            columns(i, k) =
                (straightened(plus, p) - straightened(minus, p)).dot(across) / (2.0 * steps(k));
        }
    }
    const Eigen::VectorXd t = from_mean * along;
    const double spread = std::max(1e-12, t.squaredNorm());
    for (int k = 0; k < 5; ++k) {
        columns.col(k).array() -= columns.col(k).mean();
        columns.col(k) -= t * (t.dot(columns.col(k)) / spread);
    }
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

RadialTerms plumb_line_terms(const std::vector<StraightPoints>& lines, int width_px,
                             int height_px) {
    const Eigen::Vector2d middle(0.5 * (width_px - 1), 0.5 * (height_px - 1));
    RadialTerms terms{middle, middle.norm(), 0.0, 0.0};
    const double centre_sigma = centre_sigma_of_width * width_px;
    const Eigen::Vector4d weight =
        Eigen::Vector4d(k1_sigma, k2_sigma, centre_sigma, centre_sigma).array().pow(-2.0);
    for (int iteration = 0; iteration < 8; ++iteration) {
        Eigen::Vector4d away(terms.k1, terms.k2, terms.centre_px.x() - middle.x(),
                             terms.centre_px.y() - middle.y());
        Eigen::Matrix4d normal = weight.asDiagonal();
        Eigen::Vector4d right = -weight.cwiseProduct(away);
        for (const StraightPoints& line : lines) {
            if (line.points_px.size() < 3) {
                continue;
            }
            const Derivatives d = beside_line(terms, line);
            const double w = 1.0 / (line.sigma_px * line.sigma_px);
            normal += w * d.leftCols<4>().transpose() * d.leftCols<4>();
            right -= w * d.leftCols<4>().transpose() * d.col(4);
        }
        const Eigen::Vector4d step = normal.ldlt().solve(right);
        terms = moved(terms, step);
        if (std::abs(step(0)) < 1e-6 && step.tail<2>().norm() < 1e-3) {
            break;
        }
    }
    return terms;
}

}  // namespace kambara
