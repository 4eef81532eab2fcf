// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pointing/head_adjustment.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/camera/rig_parameters.h"

namespace kambara {
namespace {

using HeadStep = Eigen::Matrix<double, head_numbers, 1>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

constexpr double least_sigma_px = 1e-3;    // of pixels without any noise
constexpr double rounding_of_unit = 1e-9;  // of an eigenvalue of the rig's correlations

Eigen::Matrix3d turned_by(const Eigen::Vector3d& vector) {
    const double angle = vector.norm();
    return angle < 1e-15 ? Eigen::Matrix3d::Identity()
                         : Eigen::AngleAxisd(angle, vector / angle).toRotationMatrix();
}

Eigen::Vector3d turn_of(const Eigen::Matrix3d& R) {
    const Eigen::AngleAxisd turn(R);
    return turn.angle() * turn.axis();
}

Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& v) {
    Eigen::Matrix3d m;
    m << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
    return m;
}

HeadModel moved(HeadModel model, const HeadStep& step) {
    model.T_base_from_rig.R = turned_by(step.segment<3>(0)) * model.T_base_from_rig.R;
    model.T_base_from_rig.t_mm += step.segment<3>(3);
    model.tilt_axis_ahead_mm += step[6];
    model.tilt_axis_skew_rad += step[7];
    model.T_camera_from_tilt.R = turned_by(step.segment<3>(8)) * model.T_camera_from_tilt.R;
    model.T_camera_from_tilt.t_mm += step.segment<3>(11);
    model.pan_backlash_rad += step[14];
    model.tilt_backlash_rad += step[15];
    return model;
}

// One over the deviation that is believed of each number's distance from nothing; the base is free.
HeadStep belief_weights() {
    HeadStep weights = HeadStep::Zero();
    weights[6] = 1.0 / 200.0;
    weights[7] = 1.0 / 0.1;
    weights.segment<3>(8).setConstant(1.0 / 0.1);
    weights.segment<3>(11).setConstant(1.0 / 200.0);
    weights.tail<2>().setConstant(1.0 / 0.05);
    return weights;
}

HeadStep beliefs_of(const HeadModel& model) {
    HeadStep off = HeadStep::Zero();
    off[6] = model.tilt_axis_ahead_mm;
    off[7] = model.tilt_axis_skew_rad;
    off.segment<3>(8) = turn_of(model.T_camera_from_tilt.R);
    off.segment<3>(11) = model.T_camera_from_tilt.t_mm;
    off[14] = model.pan_backlash_rad;
    off[15] = model.tilt_backlash_rad;
    return belief_weights().cwiseProduct(off);
}

// How the camera's pose changes with each of the head's numbers, by central differences.
std::array<RigidTransform, head_numbers> pose_by_numbers(const HeadModel& model,
                                                         const HeadView& view) {
    std::array<RigidTransform, head_numbers> result;
    for (int i = 0; i < head_numbers; ++i) {
        const bool length = (i >= 3 && i <= 6) || (i >= 11 && i <= 13);
        HeadStep step = HeadStep::Zero();
        step[i] = length ? 1e-3 : 1e-6;
        const auto pose = [&](const HeadModel& one) {
            return T_camera_from_rig(one, axes_at(one, view.encoder, view.approach));
        };
        const RigidTransform more = pose(moved(model, step));
        const RigidTransform less = pose(moved(model, -step));
        result[static_cast<std::size_t>(i)] = {(more.R - less.R) / (2.0 * step[i]),
                                               (more.t_mm - less.t_mm) / (2.0 * step[i])};
    }
    return result;
}

// A view's target is turned about the middle of what is known of it.
Eigen::Vector3d middle_of(const HeadView& view) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const HeadSighting& one : view.sightings) {
        sum += one.point_in_rig_mm;
    }
    return sum / std::max<double>(1.0, static_cast<double>(view.sightings.size()));
}

RigidTransform moved(const RigidTransform& T, const Eigen::Vector3d& about, const Vector6& step) {
    const Eigen::Matrix3d R = turned_by(step.head<3>());
    return RigidTransform{R, about - R * about + step.tail<3>()} * T;
}

// Columns by which the parameters lie off for one deviation each, their squares adding up to the
// covariance; by its correlations, since the parameters' units differ.
Eigen::MatrixXd axes_of(const Eigen::MatrixXd& covariance) {
    const Eigen::VectorXd sigma = covariance.diagonal().cwiseMax(0.0).cwiseSqrt();
    const Eigen::VectorXd weight =
        sigma.unaryExpr([](double s) { return s > 0.0 ? 1.0 / s : 0.0; });
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> axes(weight.asDiagonal() * covariance *
                                                              weight.asDiagonal());
    const Eigen::Index n = covariance.rows();
    const Eigen::Index count = (axes.eigenvalues().array() > rounding_of_unit).count();
    return sigma.asDiagonal() * axes.eigenvectors().rightCols(std::min(count, n)) *
           axes.eigenvalues().tail(count).cwiseSqrt().asDiagonal();
}

}  // namespace

// A view's errors by their deviation, and their derivatives.
struct HeadAdjustment::Rows {
    Rows(Eigen::Index count, Eigen::Index shared)
        : errors(count),
          by_shared(Eigen::MatrixXd::Zero(count, shared)),
          by_place(Eigen::Matrix<double, Eigen::Dynamic, 6>::Zero(count, 6)) {}
    Eigen::VectorXd errors;
    Eigen::MatrixXd by_shared;
    Eigen::Matrix<double, Eigen::Dynamic, 6> by_place;
    Eigen::Index row = 0;
};

HeadAdjustment::HeadAdjustment(const Rig& rig, const std::vector<HeadView>& views)
    : rig_(rig), views_(views) {
    const bool paired = std::any_of(views.begin(), views.end(),
                                    [](const HeadView& view) { return !view.pair.empty(); });
    if (rig.right && rig.parameter_covariance && paired) {
        by_rig_axis_ = axes_of(*rig.parameter_covariance);
        if (rig.pan_tilt_lens_covariance) {
            by_lens_axis_ = axes_of(*rig.pan_tilt_lens_covariance);
        }
    }
}

HeadUnknowns HeadAdjustment::start(const HeadModel& model) const {
    return {model, Eigen::VectorXd::Zero(by_rig_axis_.cols() + by_lens_axis_.cols()),
            std::vector<RigidTransform>(views_.size())};
}

Eigen::VectorXd HeadAdjustment::parameters_off(const HeadUnknowns& at) const {
    return by_rig_axis_ * at.rig_off.head(by_rig_axis_.cols());
}

Eigen::VectorXd HeadAdjustment::lens_off(const HeadUnknowns& at) const {
    return by_lens_axis_ * at.rig_off.tail(by_lens_axis_.cols());
}

Eigen::MatrixXd HeadAdjustment::parameters_left(const Eigen::MatrixXd& covariance) const {
    const Eigen::Index axes = by_rig_axis_.cols();
    return by_rig_axis_ * covariance.block(head_numbers, head_numbers, axes, axes) *
           by_rig_axis_.transpose();
}

Eigen::MatrixXd HeadAdjustment::lens_left(const Eigen::MatrixXd& covariance) const {
    const Eigen::Index axes = by_lens_axis_.cols();
    return by_lens_axis_ * covariance.bottomRightCorner(axes, axes) * by_lens_axis_.transpose();
}

bool HeadAdjustment::add_head_pixels(const HeadUnknowns& at, const Lens& lens, std::size_t view,
                                     Rows& rows) const {
    const HeadView& seen = views_[view];
    const RigidTransform T =
        T_camera_from_rig(at.model, axes_at(at.model, seen.encoder, seen.approach));
    const auto by_numbers = pose_by_numbers(at.model, seen);
    const RigidTransform& placed = at.T_rig_from_placed[view];
    const Eigen::Vector3d middle = placed * middle_of(seen);
    for (const HeadSighting& one : seen.sightings) {
        const Eigen::Vector3d point = placed * one.point_in_rig_mm;
        Eigen::Matrix<double, 2, 3> by_point;
        const auto pixel = kambara::project(lens, T * point, by_point);
        if (!pixel) {
            return false;
        }
        rows.errors.segment<2>(rows.row) = *pixel - one.pixel;
        for (std::size_t i = 0; i < by_numbers.size(); ++i) {
            rows.by_shared.block<2, 1>(rows.row, static_cast<Eigen::Index>(i)) =
                by_point * (by_numbers[i] * point);
        }
        if (lens_takes_part()) {
            rows.by_shared.block(rows.row, head_numbers + by_rig_axis_.cols(), 2,
                                 by_lens_axis_.cols()) =
                pixel_by_lens_parameters(lens, T * point) * by_lens_axis_;
        }
        const Eigen::Matrix<double, 2, 3> by_shift = by_point * T.R;
        rows.by_place.block<2, 3>(rows.row, 0) = -by_shift * cross_matrix(point - middle);
        rows.by_place.block<2, 3>(rows.row, 3) = by_shift;
        rows.row += 2;
    }
    return true;
}

bool HeadAdjustment::add_pair_pixels(const HeadUnknowns& at, const Rig& rig, std::size_t view,
                                     Rows& rows) const {
    const HeadView& seen = views_[view];
    const RigidTransform& placed = at.T_rig_from_placed[view];
    const Eigen::Vector3d middle = placed * middle_of(seen);
    for (const PairSighting& one : seen.pair) {
        const Eigen::Vector3d point = placed * one.point_in_rig_mm;
        Eigen::Matrix<double, 2, 3> left_by_point;
        Eigen::Matrix<double, 2, 3> right_by_point;
        const auto left = rig.left.project(point, left_by_point);
        const auto right = rig.right->project(point, right_by_point);
        if (!left || !right) {
            return false;
        }
        Eigen::Matrix<double, 4, 3> by_point;
        by_point << left_by_point, right_by_point;
        rows.errors.segment<4>(rows.row) << *left - one.left_px, *right - one.right_px;
        if (rig_takes_part()) {
            const auto by_rig = pixels_by_parameters(rig, rig.left.T_camera_from_rig * point);
            if (!by_rig) {
                return false;
            }
            rows.by_shared.block(rows.row, head_numbers, 4, by_rig_axis_.cols()) =
                *by_rig * by_rig_axis_;
        }
        rows.by_place.block<4, 3>(rows.row, 0) = -by_point * cross_matrix(point - middle);
        rows.by_place.block<4, 3>(rows.row, 3) = by_point;
        rows.row += 4;
    }
    return true;
}

std::optional<HeadAdjustment::Equations> HeadAdjustment::equations(const HeadUnknowns& at,
                                                                   const Sigmas& sigmas) const {
    const Eigen::Index axes = by_rig_axis_.cols() + by_lens_axis_.cols();
    const Eigen::Index shared = head_numbers + axes;
    const Lens lens = lens_takes_part() ? with_lens_moved(rig_.pan_tilt->lens, lens_off(at))
                                        : rig_.pan_tilt->lens;
    const Rig rig = rig_takes_part() ? with_parameters_moved(rig_, parameters_off(at)) : rig_;
    const HeadStep weights = belief_weights();
    const HeadStep beliefs = beliefs_of(at.model);
    Equations result;
    result.shared = Eigen::MatrixXd::Zero(shared, shared);
    result.shared.diagonal().head<head_numbers>() = weights.cwiseAbs2();
    result.shared.diagonal().tail(axes).setOnes();
    result.gradient.resize(shared);
    result.gradient << weights.cwiseProduct(beliefs), at.rig_off;
    result.cost = beliefs.squaredNorm() + at.rig_off.squaredNorm();
    for (std::size_t view = 0; view < views_.size(); ++view) {
        const auto head_rows = static_cast<Eigen::Index>(2 * views_[view].sightings.size());
        const auto pair_rows = static_cast<Eigen::Index>(4 * views_[view].pair.size());
        Rows rows(head_rows + pair_rows, shared);
        if (!add_head_pixels(at, lens, view, rows) || !add_pair_pixels(at, rig, view, rows)) {
            return std::nullopt;
        }
        result.squares.head_px2 += rows.errors.head(head_rows).squaredNorm();
        result.squares.pair_px2 += rows.errors.tail(pair_rows).squaredNorm();
        result.squares.head += static_cast<int>(head_rows / 2);
        result.squares.pair += static_cast<int>(pair_rows / 2);
        Eigen::VectorXd weight(head_rows + pair_rows);
        weight << Eigen::VectorXd::Constant(head_rows, 1.0 / sigmas.head_px),
            Eigen::VectorXd::Constant(pair_rows, 1.0 / sigmas.pair_px);
        const Eigen::VectorXd errors = weight.asDiagonal() * rows.errors;
        const Eigen::MatrixXd by_shared = weight.asDiagonal() * rows.by_shared;
        const Eigen::MatrixXd by_place = weight.asDiagonal() * rows.by_place;
        Equations::Place place;
        place.shared_gradient = by_shared.transpose() * errors;
        place.shared_by_place = Eigen::MatrixXd::Zero(shared, 6);
        place.place.setIdentity();  // the target stays where it was placed,
        place.place_gradient.setZero();
        if (pair_rows > 0) {  // unless the fixed cameras' own pixels are there
            place.shared_by_place = by_shared.transpose() * by_place;
            place.place = by_place.transpose() * by_place;
            place.place_gradient = by_place.transpose() * errors;
        }
        result.shared += by_shared.transpose() * by_shared;
        result.gradient += place.shared_gradient;
        result.cost += errors.squaredNorm();
        result.places.push_back(std::move(place));
    }
    return result;
}

HeadUnknowns HeadAdjustment::stepped(const HeadUnknowns& at, const Equations& equations,
                                     double damping) const {
    Eigen::MatrixXd reduced = equations.shared;
    reduced.diagonal() += damping * equations.shared.diagonal();
    Eigen::VectorXd gradient = equations.gradient;
    std::vector<Eigen::LDLT<Eigen::Matrix<double, 6, 6>>> solvers;
    for (const Equations::Place& one : equations.places) {
        Eigen::Matrix<double, 6, 6> damped = one.place;
        damped.diagonal() += damping * one.place.diagonal();
        solvers.emplace_back(damped);
        reduced -=
            one.shared_by_place * solvers.back().solve(one.shared_by_place.transpose().eval());
        gradient -= one.shared_by_place * solvers.back().solve(one.place_gradient);
    }
    const Eigen::VectorXd step = -reduced.ldlt().solve(gradient);
    HeadUnknowns next{moved(at.model, step.head<head_numbers>()),
                      at.rig_off + step.tail(at.rig_off.size()), at.T_rig_from_placed};
    for (std::size_t view = 0; view < views_.size(); ++view) {
        const Equations::Place& one = equations.places[view];
        const Vector6 of_place =
            -solvers[view].solve(one.place_gradient + one.shared_by_place.transpose() * step);
        RigidTransform& placed = next.T_rig_from_placed[view];
        placed = moved(placed, placed * middle_of(views_[view]), of_place);
    }
    return next;
}

std::optional<HeadUnknowns> HeadAdjustment::solved(HeadUnknowns at, const Sigmas& sigmas) const {
    auto here = equations(at, sigmas);
    if (!here) {
        return std::nullopt;
    }
    double damping = 1e-3;
    for (int round = 0; round < 100; ++round) {
        bool better = false;
        double gain = 0.0;
        while (!better && damping < 1e12) {
            const HeadUnknowns tried = stepped(at, *here, damping);
            auto there = equations(tried, sigmas);
            better = there && there->cost < here->cost;
            if (better) {
                gain = 1.0 - there->cost / here->cost;
                at = tried;
                here = std::move(there);
            }
            damping = better ? std::max(1e-9, 0.1 * damping) : 10.0 * damping;
        }
        if (!better || gain < 1e-10) {
            break;
        }
    }
    return at;
}

HeadAdjustment::Sigmas HeadAdjustment::sigmas_of(const Squares& squares) const {
    double unknowns = head_numbers;
    for (const HeadView& view : views_) {
        unknowns += view.pair.empty() ? 0.0 : 6.0;
    }
    const double rows = 2.0 * (squares.head + squares.pair);
    const double left_over = std::max(1.0, rows - unknowns) / rows;  // of each row
    const auto sigma = [left_over](double squares_px2, int pixels) {
        return std::max(least_sigma_px,
                        std::sqrt(squares_px2 / std::max(1.0, 2.0 * pixels * left_over)));
    };
    return {sigma(squares.head_px2, squares.head), sigma(squares.pair_px2, squares.pair)};
}

// What errs together within a view, such as its angles as told, scatters from view to view by more
// than single pixels would (the sandwich estimator, clustered by view: Liang and Zeger, Biometrika
// 73, 1986). The rig and the lens are off by the same in all of them: their own deviation is added
// to the scatter.
Eigen::MatrixXd HeadAdjustment::covariance(const Equations& at_solution) const {
    const Eigen::Index shared = at_solution.shared.rows();
    Eigen::MatrixXd information = at_solution.shared;
    Eigen::MatrixXd scatter = Eigen::MatrixXd::Zero(shared, shared);
    for (const Equations::Place& one : at_solution.places) {
        const Eigen::LDLT<Eigen::Matrix<double, 6, 6>> solver(one.place);
        information -= one.shared_by_place * solver.solve(one.shared_by_place.transpose().eval());
        const Eigen::VectorXd sum =
            one.shared_gradient - one.shared_by_place * solver.solve(one.place_gradient);
        scatter += sum * sum.transpose();
    }
    const double told = 3.0 * static_cast<double>(views_.size());  // a place a view at least
    scatter *= told / std::max(1.0, told - head_numbers);
    scatter.diagonal().tail(shared - head_numbers).array() += 1.0;
    const Eigen::MatrixXd by_pixels = information.inverse();
    const Eigen::MatrixXd by_views = by_pixels * scatter * by_pixels;
    // Scaled number by number, so that it stays a covariance.
    const Eigen::VectorXd scale =
        (by_views.diagonal().cwiseQuotient(by_pixels.diagonal())).cwiseMax(1.0).cwiseSqrt();
    return scale.asDiagonal() * by_pixels * scale.asDiagonal();
}

}  // namespace kambara
