// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>
#include <random>

#include "core/geometry/rigid_transform.h"

namespace kambara {

/// A hand that holds a calibration target before the simulated rig and moves it where it is told,
/// no faster than hands do. Where the target was at a time, once told, stays so: two cameras that
/// ask for the same time get the same pose. Any thread.
///
///     free --hold--> moving --arrived--> still --hold--> moving ...   (free again: let_go)
class HeldTarget {
  public:
    struct Options {
        double speed_mm_s = 350.0;
        double turning_rad_s = 1.0;
        double off_mm = 4.0;  ///< one deviation of each coordinate of where a helper's hand stops
        double off_rad = 0.015;  ///< likewise, of each angle
        std::uint32_t seed = 1;
    };
    /// The place of the target's middle in the left camera's frame, and how it is turned.
    struct Pose {
        Eigen::Vector3d middle_mm = Eigen::Vector3d::Zero();
        Eigen::Quaterniond turned = Eigen::Quaterniond::Identity();
    };
    struct At {
        Pose pose;
        std::int64_t still_since = -1;  ///< equal numbers mean equal poses; -1: it moves
    };

    HeldTarget();
    explicit HeldTarget(const Options& options);

    /// Moves it there; with `by_helper`, whose hand is a little off, to about there.
    void hold(const Pose& goal, bool by_helper);
    void let_go();
    /// The pose at a time, from `from` where it was not held before; empty while nobody holds it.
    std::optional<At> at(double time_s, const Pose& from);

  private:
    struct Told {
        double time_s;
        At at;
    };
    At after(const At& before, double seconds);

    const Options options_;
    std::mutex mutex_;
    std::mt19937 random_;
    std::optional<Pose> goal_;
    std::int64_t arrivals_ = 0;
    bool arrived_ = false;
    std::deque<Told> told_;  // in the order of their times
};

}  // namespace kambara
