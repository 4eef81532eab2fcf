// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>

namespace kambara {

/// Where a target will be, from where it was: constant velocity, smoothed over a few frames.
class Predictor {
  public:
    static constexpr double farthest_ahead_s = 0.5;

    void reset();
    /// A measured place. Times must not run backwards.
    void update(std::int64_t time_ns, const Eigen::Vector3d& point_mm);
    /// The place expected at a time; the last one where no velocity is known yet. Empty before the
    /// first measurement. The extrapolation stops after half a second: beyond it, the last velocity
    /// says nothing.
    std::optional<Eigen::Vector3d> at(std::int64_t time_ns) const;
    bool has_velocity() const { return has_velocity_; }

  private:
    std::optional<Eigen::Vector3d> point_mm_;
    Eigen::Vector3d velocity_mm_s_ = Eigen::Vector3d::Zero();
    std::int64_t time_ns_ = 0;
    bool has_velocity_ = false;
};

}  // namespace kambara
