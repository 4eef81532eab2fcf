// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/projective_fit.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>

namespace kambara {
namespace {

// Moves the points' mean to the origin and their mean distance from it to 1.
template <int N>
Eigen::Matrix<double, N + 1, N + 1> normalising(
    const std::vector<Eigen::Matrix<double, N, 1>>& points) {
    const auto count = static_cast<double>(points.size());
    Eigen::Matrix<double, N, 1> mean = Eigen::Matrix<double, N, 1>::Zero();
    for (const auto& p : points) {
        mean += p / count;
    }
    double distance = 0.0;
    for (const auto& p : points) {
        distance += (p - mean).norm() / count;
    }
    const double scale = 1.0 / std::max(1e-12, distance);
    Eigen::Matrix<double, N + 1, N + 1> T = Eigen::Matrix<double, N + 1, N + 1>::Identity();
    T.template topLeftCorner<N, N>() *= scale;
    T.template topRightCorner<N, 1>() = -scale * mean;
    return T;
}

// The 3 x (N + 1) matrix that takes places to pixels: the least eigenvector of the normal
// equations.
template <int N>
Eigen::Matrix<double, 3, N + 1> direct_linear(
    const std::vector<Eigen::Matrix<double, N, 1>>& places,
    const std::vector<Eigen::Vector2d>& pixels) {
    constexpr int C = N + 1;
    using Row = Eigen::Matrix<double, 3 * C, 1>;
    const auto T_place = normalising<N>(places);
    const auto T_pixel = normalising<2>(pixels);
    Eigen::Matrix<double, 3 * C, 3 * C> normal = Eigen::Matrix<double, 3 * C, 3 * C>::Zero();
    for (std::size_t i = 0; i < places.size(); ++i) {
        const Eigen::Matrix<double, C, 1> X = T_place * places[i].homogeneous();
        const Eigen::Vector2d x = (T_pixel * pixels[i].homogeneous()).template head<2>();
        Row row = Row::Zero();
        row.template segment<C>(0) = X;
        row.template segment<C>(2 * C) = -x.x() * X;
        normal.template selfadjointView<Eigen::Lower>().rankUpdate(row);
        row.template segment<C>(0).setZero();
        row.template segment<C>(C) = X;
        row.template segment<C>(2 * C) = -x.y() * X;
        normal.template selfadjointView<Eigen::Lower>().rankUpdate(row);
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 3 * C, 3 * C>> solver(normal);
    const Row least = solver.eigenvectors().col(0);
    Eigen::Matrix<double, 3, C> M;
    M.row(0) = least.template segment<C>(0);
    M.row(1) = least.template segment<C>(C);
    M.row(2) = least.template segment<C>(2 * C);
    return T_pixel.inverse() * M * T_place;
}

}  // namespace

Homography fit_homography(const std::vector<Eigen::Vector2d>& places,
                          const std::vector<Eigen::Vector2d>& pixels) {
    return direct_linear<2>(places, pixels);
}

Projection fit_projection(const std::vector<Eigen::Vector3d>& points,
                          const std::vector<Eigen::Vector2d>& pixels) {
    const Projection P = direct_linear<3>(points, pixels);
    double third = 0.0;
    for (const auto& point : points) {
        third += P.row(2).dot(point.homogeneous()) > 0.0 ? 1.0 : -1.0;
    }
    return third < 0.0 ? Projection(-P) : P;
}

bool seen_from_before(const Projection& P, const std::vector<Eigen::Vector3d>& points) {
    for (const auto& point : points) {
        if (!(P.row(2).dot(point.homogeneous()) > 0.0)) {
            return false;
        }
    }
    return P.leftCols<3>().determinant() > 0.0;
}

}  // namespace kambara
