// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/tsai_refine.h"

#include <ceres/ceres.h>
#include <ceres/rotation.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <type_traits>

#include "core/calibration/point_layout.h"
#include "core/camera/lens_functions.h"

namespace kambara {
namespace {

using Parameters = std::array<double, tsai_parameters>;

// How far a point is from where a pincushion lens turns back and the derivatives end: 1 on the
// axis, 0 there; NaN beyond.
double before_the_turn(double f_mm, double kappa, double x, double y) {
    const double w = tsai_squared_distorted_radius(kappa, f_mm * f_mm * (x * x + y * y));
    return 1.0 + 3.0 * kappa * w;
}

// A step is tried with plain numbers first: what is just good enough then must be so again with
// derivatives, whose last digits differ.
template <class T>
constexpr double least_before_the_turn = std::is_same_v<T, double> ? 2e-6 : 1e-6;

struct PointResidual {
    Eigen::Vector3d turned_mm;  // by the rotation at the start
    Eigen::Vector2d seen_px;
    double dx_prime_mm;
    double dy_mm;

    template <class T>
    bool operator()(const T* parameters, T* residual) const {
        const T point[3] = {T(turned_mm.x()), T(turned_mm.y()), T(turned_mm.z())};
        T in_camera[3];
        ceres::AngleAxisRotatePoint(parameters + tsai::turn_x, point, in_camera);
        for (int i = 0; i < 3; ++i) {
            in_camera[i] += parameters[tsai::t_x + i];
        }
        if (!(value_of(in_camera[2]) > 0.0) || !(value_of(parameters[tsai::f]) > 0.0) ||
            !(value_of(parameters[tsai::s_x]) > 0.0)) {
            return false;
        }
        const T x = in_camera[0] / in_camera[2];
        const T y = in_camera[1] / in_camera[2];
        if (!(before_the_turn(value_of(parameters[tsai::f]), value_of(parameters[tsai::kappa1]),
                              value_of(x), value_of(y)) > least_before_the_turn<T>)) {
            return false;
        }
        T pixel[2];
        tsai_pixel(parameters + tsai::f, dx_prime_mm, dy_mm, x, y, pixel);
        residual[0] = pixel[0] - seen_px.x();
        residual[1] = pixel[1] - seen_px.y();
        return true;
    }
};

using PointCost = ceres::AutoDiffCostFunction<PointResidual, 2, tsai_parameters>;

PointCost* cost_of(const TsaiView& view, const SeenPoint& point) {
    return new PointCost(new PointResidual{view.T_camera_from_world.R * point.in_world_mm,
                                           point.seen_px, view.lens.sensor.dx_prime_mm(),
                                           view.lens.sensor.dy_mm});
}

Parameters parameters_of(const TsaiView& view) {
    const Eigen::Vector3d& t = view.T_camera_from_world.t_mm;
    return {0.0,
            0.0,
            0.0,
            t.x(),
            t.y(),
            t.z(),
            view.lens.f_mm,
            view.lens.kappa1_per_mm2,
            view.lens.cx_px,
            view.lens.cy_px,
            view.lens.sx};
}

TsaiView view_of(const Parameters& p, const TsaiView& start) {
    TsaiView view = start;
    const Eigen::Vector3d turn(p[tsai::turn_x], p[tsai::turn_y], p[tsai::turn_z]);
    if (turn.norm() > 0.0) {
        view.T_camera_from_world.R =
            nearest_rotation(Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix() *
                             start.T_camera_from_world.R);
    }
    view.T_camera_from_world.t_mm = {p[tsai::t_x], p[tsai::t_y], p[tsai::t_z]};
    view.lens.f_mm = p[tsai::f];
    view.lens.kappa1_per_mm2 = p[tsai::kappa1];
    view.lens.cx_px = p[tsai::c_x];
    view.lens.cy_px = p[tsai::c_y];
    view.lens.sx = p[tsai::s_x];
    return view;
}

// The same with the world's origin moved by `by`.
TsaiView about(TsaiView view, const Eigen::Vector3d& by) {
    view.T_camera_from_world.t_mm += view.T_camera_from_world.R * by;
    return view;
}

ceres::Solver::Options solver_options() {
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::DENSE_QR;
    options.max_num_iterations = 100;
    options.function_tolerance = 1e-15;
    options.parameter_tolerance = 1e-15;
    options.gradient_tolerance = 1e-15;
    options.num_threads = 1;
    options.logging_type = ceres::SILENT;
    return options;
}

}  // namespace

TsaiMask without_s_x(TsaiMask free) {
    free[tsai::s_x] = false;
    return free;
}

std::optional<TsaiView> refined(const TsaiView& start, const std::vector<SeenPoint>& points,
                                const TsaiMask& free) {
    // Ceres writes to the log where a start can't be evaluated; that is asked before.
    if (!tsai_jacobian(start, points)) {
        return std::nullopt;
    }
    // About the points' mean, a turn and a shift are nearly independent of each other.
    const Eigen::Vector3d mean = layout_of(points).mean_mm;
    const TsaiView start_about = about(start, mean);
    Parameters parameters = parameters_of(start_about);
    ceres::Problem problem;
    for (const SeenPoint& point : points) {
        problem.AddResidualBlock(cost_of(start_about, {point.in_world_mm - mean, point.seen_px}),
                                 nullptr, parameters.data());
    }
    std::vector<int> fixed;
    for (int i = 0; i < tsai_parameters; ++i) {
        if (!free[static_cast<std::size_t>(i)]) {
            fixed.push_back(i);
        }
    }
    if (!fixed.empty()) {
        problem.SetManifold(parameters.data(), new ceres::SubsetManifold(tsai_parameters, fixed));
    }
    ceres::Solver::Summary summary;
    ceres::Solve(solver_options(), &problem, &summary);
    if (!summary.IsSolutionUsable()) {
        return std::nullopt;
    }
    return about(view_of(parameters, start_about), -mean);
}

std::optional<Eigen::Matrix<double, Eigen::Dynamic, tsai_parameters>> tsai_jacobian(
    const TsaiView& view, const std::vector<SeenPoint>& points) {
    const Parameters parameters = parameters_of(view);
    const double* const blocks[] = {parameters.data()};
    Eigen::Matrix<double, Eigen::Dynamic, tsai_parameters> J(
        2 * static_cast<Eigen::Index>(points.size()), tsai_parameters);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::unique_ptr<PointCost> cost(cost_of(view, points[i]));
        Eigen::Matrix<double, 2, tsai_parameters, Eigen::RowMajor> by_parameters;
        double* jacobians[] = {by_parameters.data()};
        Eigen::Vector2d residual;
        if (!cost->Evaluate(blocks, residual.data(), jacobians) || !by_parameters.allFinite()) {
            return std::nullopt;
        }
        J.middleRows<2>(2 * static_cast<Eigen::Index>(i)) = by_parameters;
    }
    return J;
}

std::optional<TsaiMatrix> unit_covariance(
    const Eigen::Matrix<double, Eigen::Dynamic, tsai_parameters>& jacobian, const TsaiMask& free) {
    std::vector<Eigen::Index> columns;
    for (int i = 0; i < tsai_parameters; ++i) {
        if (free[static_cast<std::size_t>(i)]) {
            columns.push_back(i);
        }
    }
    Eigen::MatrixXd J = jacobian(Eigen::all, columns);
    const Eigen::VectorXd sizes = J.colwise().norm().transpose();
    if (J.rows() < J.cols() || !(sizes.minCoeff() > 0.0) || !sizes.allFinite()) {
        return std::nullopt;
    }
    J.array().rowwise() /= sizes.transpose().array();
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(J);
    if (qr.rank() < J.cols()) {
        return std::nullopt;
    }
    const Eigen::Index n = J.cols();
    Eigen::MatrixXd inverse = Eigen::MatrixXd::Identity(n, n);
    qr.matrixR().topLeftCorner(n, n).triangularView<Eigen::Upper>().solveInPlace(inverse);
    inverse = (qr.colsPermutation() * inverse).eval();
    inverse = (sizes.cwiseInverse().asDiagonal() * inverse).eval();
    TsaiMatrix covariance = TsaiMatrix::Zero();
    covariance(columns, columns) = inverse * inverse.transpose();
    return covariance;
}

}  // namespace kambara
