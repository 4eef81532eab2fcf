// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>

#include "core/tracking/vehicle_track.h"

namespace kambara {

enum class MotionModel { constant_velocity, constant_acceleration };

/// What the predictor makes of a target's places.
struct MotionEstimate {
    /// The filtered place: for display, it never replaces the measured one.
    Eigen::Vector3d point_mm = Eigen::Vector3d::Zero();
    Eigen::Vector3d velocity_mm_s = Eigen::Vector3d::Zero();
    Eigen::Matrix3d velocity_covariance_mm2_s2 = Eigen::Matrix3d::Zero();
    Eigen::Vector3d velocity_sigma_mm_s() const {
        return velocity_covariance_mm2_s2.diagonal().cwiseMax(0.0).cwiseSqrt();
    }
    Eigen::Vector3d acceleration_mm_s2 = Eigen::Vector3d::Zero();  ///< 0 with constant velocity
    MotionModel model = MotionModel::constant_velocity;            ///< the one in use
    /// The last innovation squared, in units of what the filter expected (3 on average).
    double innovation = 0.0;
    /// The mean of the last ten or so is such as the filter expects with 95 %.
    bool consistent = true;
    /// The vehicle's own motion is known: the velocity is over ground, not past the cameras.
    bool by_vehicle = false;
};

/// Where a target will be, from where it was: two Kalman filters in 3-D, of constant velocity and
/// of constant acceleration (one that fades within tenths of a second: Singer, Estimating optimal
/// tracking filter performance for manned maneuvering targets, 1970). The likelier one of late
/// predicts; both are judged by their normalised innovations. An innovation that is too large
/// widens the filter that it came from, so that a sudden turn is followed at once.
///
/// Where there is a vehicle, its motion since the last measurement moves the expected place.
class Predictor {
  public:
    static constexpr double farthest_ahead_s = 0.5;
    /// Of the innovation squared, three dimensions, 95 %.
    static constexpr double innovation_gate = 7.815;

    /// Forgets all but the vehicle.
    void reset();
    void follow_vehicle(std::shared_ptr<const VehicleTrack> vehicle);

    /// A measured place and its covariance. Times must not run backwards.
    void update(std::int64_t time_ns, const Eigen::Vector3d& point_mm,
                const Eigen::Matrix3d& covariance_mm2);
    /// The place expected at a time; the last one where no velocity is known yet. Empty before the
    /// first measurement. The extrapolation of the target's own motion stops after half a second:
    /// beyond it, the last velocity says nothing.
    std::optional<Eigen::Vector3d> at(std::int64_t time_ns) const;
    bool has_velocity() const { return updates_ > 1; }
    /// As of the last measurement. Empty until a velocity is known.
    std::optional<MotionEstimate> motion() const;

  private:
    using State = Eigen::Matrix<double, 9, 1>;       // place, velocity, acceleration
    using Covariance = Eigen::Matrix<double, 9, 9>;  // likewise
    struct Filter {
        MotionModel model = MotionModel::constant_velocity;
        State state = State::Zero();
        Covariance covariance = Covariance::Zero();
        double innovation = 0.0;       // of the last update
        double mean_innovation = 3.0;  // of late
        double unlikeliness = 0.0;     // likewise
    };

    static void begin(Filter& filter, const Eigen::Vector3d& point_mm,
                      const Eigen::Matrix3d& covariance_mm2);
    static void advance(Filter& filter, double step_s, const RigChange* change);
    static void correct(Filter& filter, double step_s, const Eigen::Vector3d& point_mm,
                        const Eigen::Matrix3d& covariance_mm2);
    const Filter& chosen() const { return filters_[use_acceleration_ ? 1 : 0]; }
    std::optional<RigChange> change_until(std::int64_t time_ns) const;

    std::shared_ptr<const VehicleTrack> vehicle_;
    std::array<Filter, 2> filters_;
    bool use_acceleration_ = false;
    bool by_vehicle_ = false;
    int updates_ = 0;
    std::int64_t time_ns_ = 0;
};

}  // namespace kambara
