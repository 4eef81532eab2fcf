// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/predictor.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

namespace kambara {
namespace {

// What a target's motion changes by unforeseen: accelerations, and the acceleration's own spread.
constexpr double acceleration_sigma_mm_s2 = 600.0;
constexpr double varied_acceleration_mm_s2 = 1500.0;
constexpr double acceleration_fades_s = 0.5;
constexpr double first_velocity_sigma_mm_s = 1000.0;
constexpr double least_sigma_mm = 0.05;  // no measurement is better
constexpr double newest_share = 0.1;     // in what is said of late
constexpr double better_by = 0.5;        // another model must be, to be taken
// A mean of about 2 / newest_share - 1 squares of three dimensions, 95 %.
constexpr double mean_gate = 4.0;

}  // namespace

void Predictor::reset() {
    auto vehicle = std::move(vehicle_);
    *this = Predictor();
    vehicle_ = std::move(vehicle);
}

void Predictor::follow_vehicle(std::shared_ptr<const VehicleTrack> vehicle) {
    vehicle_ = std::move(vehicle);
}

void Predictor::begin(Filter& filter, const Eigen::Vector3d& point_mm,
                      const Eigen::Matrix3d& covariance_mm2) {
    const MotionModel model = filter.model;
    filter = Filter{};
    filter.model = model;
    filter.state.head<3>() = point_mm;
    filter.covariance.topLeftCorner<3, 3>() = covariance_mm2;
    filter.covariance.diagonal().segment<3>(3).setConstant(first_velocity_sigma_mm_s *
                                                           first_velocity_sigma_mm_s);
    if (model == MotionModel::constant_acceleration) {
        filter.covariance.diagonal().tail<3>().setConstant(varied_acceleration_mm_s2 *
                                                           varied_acceleration_mm_s2);
    }
}

void Predictor::advance(Filter& filter, double step_s, const RigChange* change) {
    const Eigen::Matrix3d I = Eigen::Matrix3d::Identity();
    Covariance F = Covariance::Identity();
    F.block<3, 3>(0, 3) = step_s * I;
    Eigen::Matrix<double, 9, 3> G = Eigen::Matrix<double, 9, 3>::Zero();
    double unforeseen = acceleration_sigma_mm_s2;
    if (filter.model == MotionModel::constant_velocity) {
        F.bottomRightCorner<3, 3>().setZero();
        G.topRows<3>() = 0.5 * step_s * step_s * I;
        G.middleRows<3>(3) = step_s * I;
    } else {
        // Singer: the acceleration fades as exp(-t / tau).
        const double tau = acceleration_fades_s;
        const double left = std::exp(-step_s / tau);
        F.block<3, 3>(0, 6) = tau * tau * (step_s / tau - 1.0 + left) * I;
        F.block<3, 3>(3, 6) = tau * (1.0 - left) * I;
        F.block<3, 3>(6, 6) = left * I;
        G.topRows<3>() = step_s * step_s / 6.0 * I;
        G.middleRows<3>(3) = 0.5 * step_s * I;
        G.bottomRows<3>() = I;
        unforeseen = varied_acceleration_mm_s2 * std::sqrt(1.0 - left * left);
    }
    filter.state = F * filter.state;
    filter.covariance =
        F * filter.covariance * F.transpose() + unforeseen * unforeseen * G * G.transpose();
    if (change == nullptr) {
        return;
    }
    const Eigen::Matrix3d& R = change->T_now_from_then.R;
    Covariance turn = Covariance::Zero();
    for (int i = 0; i < 9; i += 3) {
        turn.block<3, 3>(i, i) = R;
    }
    filter.state = turn * filter.state;
    filter.state.head<3>() += change->T_now_from_then.t_mm;
    filter.covariance = turn * filter.covariance * turn.transpose();
    // A turn that is not known well moves a place across the line to it.
    const Eigen::Vector3d at = filter.state.head<3>();
    const Eigen::Matrix3d across = at.squaredNorm() * I - at * at.transpose();
    filter.covariance.topLeftCorner<3, 3>() +=
        change->turn_sigma_rad * change->turn_sigma_rad * across +
        change->way_sigma_mm * change->way_sigma_mm * I;
}

void Predictor::correct(Filter& filter, double step_s, const Eigen::Vector3d& point_mm,
                        const Eigen::Matrix3d& covariance_mm2) {
    const Eigen::Vector3d innovation = point_mm - filter.state.head<3>();
    Eigen::Matrix3d S = filter.covariance.topLeftCorner<3, 3>() + covariance_mm2;
    const double squared = innovation.dot(S.ldlt().solve(innovation));
    filter.innovation = squared;
    filter.mean_innovation += newest_share * (squared - filter.mean_innovation);
    filter.unlikeliness +=
        newest_share * (squared + std::log(S.determinant()) - filter.unlikeliness);
    if (squared > innovation_gate) {
        // As if its velocity had changed at a stroke since the last measurement.
        Eigen::Matrix<double, 9, 3> jump = Eigen::Matrix<double, 9, 3>::Zero();
        jump.topRows<3>() = Eigen::Matrix3d::Identity();
        jump.middleRows<3>(3) = Eigen::Matrix3d::Identity() / step_s;
        filter.covariance += innovation.squaredNorm() / 3.0 * jump * jump.transpose();
        S = filter.covariance.topLeftCorner<3, 3>() + covariance_mm2;
    }
    const Eigen::Matrix<double, 9, 3> gain =
        S.ldlt().solve(filter.covariance.topRows<3>()).transpose();
    filter.state += gain * innovation;
    filter.covariance -= gain * S * gain.transpose();
    filter.covariance = 0.5 * (filter.covariance + filter.covariance.transpose()).eval();
}

std::optional<RigChange> Predictor::change_until(std::int64_t time_ns) const {
    return vehicle_ ? vehicle_->between(time_ns_, time_ns) : std::nullopt;
}

void Predictor::update(std::int64_t time_ns, const Eigen::Vector3d& point_mm,
                       const Eigen::Matrix3d& covariance_mm2) {
    const double step_s = static_cast<double>(time_ns - time_ns_) * 1e-9;
    const Eigen::Matrix3d noise =
        covariance_mm2 + least_sigma_mm * least_sigma_mm * Eigen::Matrix3d::Identity();
    const auto change = updates_ > 0 ? change_until(time_ns) : std::nullopt;
    // A velocity over ground is none past the cameras, and the other way about.
    const bool other_velocity = updates_ > 1 && change.has_value() != by_vehicle_;
    const bool afresh =
        updates_ == 0 || step_s <= 0.0 || step_s > farthest_ahead_s || other_velocity;
    if (afresh) {
        filters_[1].model = MotionModel::constant_acceleration;
        for (Filter& filter : filters_) {
            begin(filter, point_mm, noise);
        }
        use_acceleration_ = false;
        updates_ = 1;
    } else {
        for (Filter& filter : filters_) {
            advance(filter, step_s, change ? &*change : nullptr);
            correct(filter, step_s, point_mm, noise);
        }
        const double gain = filters_[0].unlikeliness - filters_[1].unlikeliness;
        if (std::abs(gain) > better_by) {
            use_acceleration_ = gain > 0.0;
        }
        ++updates_;
    }
    by_vehicle_ = change.has_value();
    time_ns_ = time_ns;
}

std::optional<Eigen::Vector3d> Predictor::at(std::int64_t time_ns) const {
    if (updates_ == 0) {
        return std::nullopt;
    }
    const double ahead_s = static_cast<double>(time_ns - time_ns_) * 1e-9;
    Filter moved = chosen();
    const auto change = change_until(time_ns);
    if (!has_velocity()) {
        moved.state.tail<6>().setZero();
    }
    advance(moved, std::clamp(ahead_s, 0.0, farthest_ahead_s), change ? &*change : nullptr);
    return Eigen::Vector3d(moved.state.head<3>());
}

std::optional<MotionEstimate> Predictor::motion() const {
    if (!has_velocity()) {
        return std::nullopt;
    }
    const Filter& filter = chosen();
    MotionEstimate motion;
    motion.point_mm = filter.state.head<3>();
    motion.velocity_mm_s = filter.state.segment<3>(3);
    motion.velocity_covariance_mm2_s2 = filter.covariance.block<3, 3>(3, 3);
    motion.acceleration_mm_s2 = filter.state.tail<3>();
    motion.model = filter.model;
    motion.innovation = filter.innovation;
    motion.consistent = filter.mean_innovation < mean_gate;
    motion.by_vehicle = by_vehicle_;
    return motion;
}

}  // namespace kambara
