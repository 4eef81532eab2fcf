// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <vector>

#include "core/camera/foreign_formats.h"
#include "core/camera/lens_functions.h"

namespace kambara {
namespace {

constexpr int grid_across = 33;
constexpr int most_steps = 200;

struct Sample {
    Eigen::Vector2d direction;
    Eigen::Vector2d pixel;
};

std::vector<Sample> samples_of(const Camera& camera) {
    std::vector<Sample> samples;
    for (int j = 0; j < grid_across; ++j) {
        for (int i = 0; i < grid_across; ++i) {
            const Eigen::Vector2d pixel((camera.width_px - 1.0) * i / (grid_across - 1.0),
                                        (camera.height_px - 1.0) * j / (grid_across - 1.0));
            if (const auto ray = unproject(camera.lens, pixel)) {
                samples.push_back({ray->direction.head<2>() / ray->direction.z(), pixel});
            }
        }
    }
    return samples;
}

using Parameters = Eigen::Matrix<double, 12, 1>;

Eigen::VectorXd residuals_at(const Parameters& p, const std::vector<Sample>& samples) {
    Eigen::VectorXd residuals(2 * static_cast<Eigen::Index>(samples.size()));
    Eigen::Index row = 0;
    for (const Sample& sample : samples) {
        Eigen::Vector2d pixel;
        brown_pixel(p.data(), sample.direction.x(), sample.direction.y(), pixel.data());
        residuals.segment<2>(row) = pixel - sample.pixel;
        row += 2;
    }
    return residuals;
}

// Levenberg and Marquardt with differences: twelve smooth parameters, done once an export.
Parameters fitted(Parameters p, const std::vector<int>& free, const std::vector<Sample>& samples) {
    Eigen::VectorXd residuals = residuals_at(p, samples);
    const auto n = static_cast<Eigen::Index>(free.size());
    double damping = 1e-6;
    for (int step = 0; step < most_steps; ++step) {
        Eigen::MatrixXd J(residuals.size(), n);
        for (Eigen::Index k = 0; k < n; ++k) {
            Parameters moved = p;
            const double h = 1e-6 * std::max(1.0, std::abs(p[free[static_cast<std::size_t>(k)]]));
            moved[free[static_cast<std::size_t>(k)]] += h;
            J.col(k) = (residuals_at(moved, samples) - residuals) / h;
        }
        const Eigen::MatrixXd H = J.transpose() * J;
        const Eigen::VectorXd g = J.transpose() * residuals;
        bool improved = false;
        while (!improved && damping < 1e6) {
            Eigen::MatrixXd damped = H;
            damped.diagonal() += damping * H.diagonal();
            const Eigen::VectorXd move = damped.ldlt().solve(-g);
            Parameters next = p;
            for (Eigen::Index k = 0; k < n; ++k) {
                next[free[static_cast<std::size_t>(k)]] += move[k];
            }
            const Eigen::VectorXd after = residuals_at(next, samples);
            if (after.allFinite() && after.squaredNorm() < residuals.squaredNorm()) {
                const bool settled =
                    residuals.squaredNorm() - after.squaredNorm() < 1e-12 * residuals.squaredNorm();
                p = next;
                residuals = after;
                damping = std::max(1e-12, damping * 0.1);
                improved = true;
                if (settled) {
                    return p;
                }
            } else {
                damping *= 10.0;
            }
        }
        if (!improved) {
            return p;
        }
    }
    return p;
}

// The rational lens multiplied out is linear in its radial terms: a start that lies off the poles
// that steps from no distortion at all may run into.
Parameters rational_start(Parameters p, const std::vector<Sample>& samples) {
    Eigen::MatrixXd A(static_cast<Eigen::Index>(samples.size()), 6);
    Eigen::VectorXd b(A.rows());
    for (Eigen::Index i = 0; i < A.rows(); ++i) {
        const Sample& sample = samples[static_cast<std::size_t>(i)];
        const Eigen::Vector2d distorted((sample.pixel.x() - p[2]) / p[0],
                                        (sample.pixel.y() - p[3]) / p[1]);
        const double r2 = sample.direction.squaredNorm();
        const double factor = r2 > 1e-12 ? distorted.norm() / std::sqrt(r2) : 1.0;
        const Eigen::RowVector3d powers(r2, r2 * r2, r2 * r2 * r2);
        A.row(i) << powers, -factor * powers;
        b[i] = factor - 1.0;
    }
    const Eigen::VectorXd k = A.jacobiSvd(Eigen::ComputeThinU | Eigen::ComputeThinV).solve(b);
    p[4] = k[0];
    p[5] = k[1];
    p[8] = k[2];
    p.tail<3>() = k.tail<3>();
    return p;
}

// Empty where the lens turns back at a sample.
std::optional<FittedLens> lens_of(const Parameters& p, int terms,
                                  const std::vector<Sample>& samples) {
    FittedLens result{
        BrownLens(p[0], p[1], p[2], p[3], {p.data() + 4, p.data() + (terms > 5 ? 12 : 9)}), 0.0};
    for (const Sample& sample : samples) {
        const auto pixel = project(result.lens, {sample.direction.x(), sample.direction.y(), 1.0});
        if (!pixel) {
            return std::nullopt;
        }
        result.worst_residual_px =
            std::max(result.worst_residual_px, (*pixel - sample.pixel).norm());
    }
    return result;
}

}  // namespace

Result<FittedLens> fitted_brown(const Camera& camera, int terms) {
    const std::vector<Sample> samples = samples_of(camera);
    if (samples.size() < 100) {
        return Error{"The lens can be undistorted in a small part of the picture only.",
                     "Calibrate it anew."};
    }
    const PinholeParameters pinhole = pinhole_parameters(camera.lens);
    Parameters p = Parameters::Zero();
    p.head<4>() << pinhole.fx_px, pinhole.fy_px, pinhole.cx_px, pinhole.cy_px;
    if (const auto* brown = std::get_if<BrownLens>(&camera.lens)) {
        const auto known = brown->distortion();
        std::copy(known.begin(), known.end(), p.data() + 4);
        if (terms < 8) {
            p.tail<3>().setZero();
        }
        if (terms < 5) {
            p[8] = 0.0;
        }
    }
    std::vector<int> free(static_cast<std::size_t>(4 + terms));
    std::iota(free.begin(), free.end(), 0);
    auto best = lens_of(fitted(p, free, samples), terms, samples);
    if (terms == 8) {
        const auto other =
            lens_of(fitted(rational_start(p, samples), free, samples), terms, samples);
        if (other && (!best || other->worst_residual_px < best->worst_residual_px)) {
            best = other;
        }
    }
    if (!best) {
        return Error{
            "The lens does not fit into the other program's model: its distortion "
            "turns back inside the picture.",
            "Use a format with more distortion terms."};
    }
    return *best;
}

}  // namespace kambara
