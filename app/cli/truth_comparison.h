// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <string>

#include "core/camera/rig.h"
#include "core/pointing/head_axes.h"
#include "core/vsystem/snapshot.h"

namespace kambara {
class SimulatedWorld;
}

namespace kambara::cli {

/// How far a run on the simulated rig was from the truth.
struct TruthSummary {
    std::int64_t frames = 0;
    double tracked_fraction = 0.0;  ///< of the frames: Tracking, with a position
    double range_error_mean_pct = 0.0;
    double range_error_worst_pct = 0.0;
    double position_error_mean_mm = 0.0;
    /// Of the time after the first 2 s; NaN (in JSON: null) where the run was shorter.
    double head_within_1_deg_fraction = 0.0;
    double head_error_worst_deg = 0.0;  ///< likewise
};

/// The summary's word on the head, such as "head within 1 degree for 99.0 % of the time".
std::string head_sentence(double within_1_deg_fraction);

/// The truth for one snapshot.
struct TruthSample {
    Eigen::Vector3d point_in_left_mm = Eigen::Vector3d::Zero();
    double range_error_pct = 0.0;  ///< NaN where there is no position
    double head_error_deg = 0.0;   ///< NaN where there is no head
};

/// Follows the point of the simulated target that was under the template's centre when it was
/// chosen.
class TruthComparison {
  public:
    /// `left_px` is the template's centre in frame `frame`. The centre must be on the target.
    TruthComparison(std::shared_ptr<const SimulatedWorld> world, const Eigen::Vector2d& left_px,
                    std::int64_t frame);

    bool on_target() const { return on_target_; }
    TruthSample add(const Snapshot& snapshot);
    TruthSummary summary() const;

  private:
    std::shared_ptr<const SimulatedWorld> world_;
    const Rig true_rig_;
    HeadAxes axes_;  // as the simulated head's encoders leave them
    Eigen::Vector2d target_point_mm_ = Eigen::Vector2d::Zero();
    bool on_target_ = false;
    std::int64_t first_time_ns_ = 0;
    std::int64_t last_frame_ = -1;
    std::int64_t frames_ = 0;
    std::int64_t tracked_ = 0;
    double range_error_sum_pct_ = 0.0;
    double range_error_worst_pct_ = 0.0;
    double position_error_sum_mm_ = 0.0;
    std::int64_t head_samples_ = 0;
    std::int64_t head_within_ = 0;
    double head_error_worst_deg_ = 0.0;
};

}  // namespace kambara::cli
