// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/matching/subpixel.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/matching/cubic_spline.h"

namespace kambara {
namespace {

constexpr int most_steps = 20;
constexpr double settled_px = 1e-4;
constexpr double farthest_px = 1.5;
// Variance of the slope of a spline through white noise of variance 1, at its nodes: the mean of
// (3 sin w / (2 + cos w))^2 over all frequencies, 9 (2 / sqrt(3) - 1).
constexpr double gradient_of_noise = 1.392;
constexpr double most_by_noise = 0.5;   // of the weaker direction's slopes
constexpr double least_texture = 1e-3;  // of a flat direction's share in the normal matrix

// The template's own noise is in its gradients, where it steepens the normal matrix by
// gradient_of_noise times its variance a pixel without helping to tell the place. Half the
// residual's variance is taken to be the template's.
Eigen::Matrix2d covariance_of(const Eigen::Matrix4d& normal, double variance, double count) {
    Eigen::Matrix4d without_noise = normal;
    const Eigen::Matrix2d slopes = normal.topLeftCorner<2, 2>();
    const double weakest =
        0.5 * slopes.trace() -
        std::sqrt(std::max(0.0, 0.25 * slopes.trace() * slopes.trace() - slopes.determinant()));
    const double by_noise =
        std::min(gradient_of_noise * 0.5 * variance * count, most_by_noise * weakest);
    without_noise(0, 0) -= by_noise;
    without_noise(1, 1) -= by_noise;
    const Eigen::Matrix4d inverse =
        without_noise.ldlt().solve(Eigen::Matrix4d(Eigen::Matrix4d::Identity()));
    return variance * (inverse * normal * inverse).topLeftCorner<2, 2>();
}

}  // namespace

std::optional<SubpixelMatch> refine_match(const Image& picture, const Image& picture_of_template,
                                          const Rectangle& rectangle,
                                          const Eigen::Vector2d& start_px) {
    using Matrix4 = Eigen::Matrix4d;
    using Vector4 = Eigen::Vector4d;
    // Unknowns of picture = a T + b + a dT/dx dx + a dT/dy dy: linear in (a dx, a dy, a, b).
    const CubicSpline of_template(picture_of_template,
                                  spline_piece(rectangle, picture_of_template));
    const auto count =
        static_cast<std::size_t>(rectangle.width) * static_cast<std::size_t>(rectangle.height);
    std::vector<Vector4> terms(count);
    Matrix4 normal = Matrix4::Zero();
    double mean = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        const int x = rectangle.x + static_cast<int>(i) % rectangle.width;
        const int y = rectangle.y + static_cast<int>(i) / rectangle.width;
        const auto slope = of_template.gradient(x, y);
        terms[i] = {slope.x, slope.y, static_cast<double>(picture_of_template.at(x, y)), 1.0};
        mean += terms[i].z() / static_cast<double>(count);
    }
    for (Vector4& term : terms) {
        term.z() -= mean;  // so that gain and offset are told apart well
        normal += term * term.transpose();
    }
    const Eigen::LDLT<Matrix4> solver(normal);
    if (solver.info() != Eigen::Success ||
        solver.vectorD().minCoeff() < least_texture * static_cast<double>(count)) {
        return std::nullopt;
    }
    const Rectangle around{static_cast<int>(std::floor(start_px.x())) - 2,
                           static_cast<int>(std::floor(start_px.y())) - 2, rectangle.width + 5,
                           rectangle.height + 5};
    const bool meets_picture = around.x < picture.width() && around.y < picture.height() &&
                               around.x + around.width > 0 && around.y + around.height > 0;
    if (!meets_picture) {
        return std::nullopt;
    }
    const CubicSpline of_picture(picture, spline_piece(around, picture));
    Eigen::Vector2d place = start_px;
    for (int step = 0; step < most_steps; ++step) {
        const bool inside = place.x() >= 0.0 && place.y() >= 0.0 &&
                            place.x() + rectangle.width - 1 <= picture.width() - 1 &&
                            place.y() + rectangle.height - 1 <= picture.height() - 1;
        if (!inside || (place - start_px).norm() > farthest_px) {
            return std::nullopt;
        }
        Vector4 right = Vector4::Zero();
        double squares = 0.0;
        for (std::size_t i = 0; i < count; ++i) {
            const double x = place.x() + static_cast<double>(static_cast<int>(i) % rectangle.width);
            const double y = place.y() + static_cast<double>(static_cast<int>(i) / rectangle.width);
            const double seen = of_picture.value(x, y);
            right += seen * terms[i];
            squares += seen * seen;
        }
        const Vector4 solution = solver.solve(right);
        const double gain = solution.z();
        if (gain <= 0.0) {
            return std::nullopt;  // the picture is the template's negative here
        }
        const Eigen::Vector2d shift = solution.head<2>() / gain;
        place -= shift;
        if (shift.norm() < settled_px || step + 1 == most_steps) {
            SubpixelMatch match;
            match.position_px = place;
            match.gain = gain;
            match.offset_grey = solution.w() - gain * mean;
            const double rest = std::max(0.0, squares - solution.dot(right));
            const double variance =
                rest / std::max(1.0, static_cast<double>(count) - 4.0) + 1.0 / 12.0;
            match.residual_grey = std::sqrt(rest / static_cast<double>(count));
            match.covariance_px2 =
                covariance_of(normal, variance / (gain * gain), static_cast<double>(count));
            return match;
        }
    }
    return std::nullopt;
}

}  // namespace kambara
