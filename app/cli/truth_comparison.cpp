// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/truth_comparison.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>

#include "core/base/angles.h"
#include "core/pointing/aim.h"
#include "hardware/simulated/simulated_world.h"

namespace kambara::cli {
namespace {

constexpr std::int64_t settling_ns = 2'000'000'000;
constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

}  // namespace

std::string head_sentence(double within_1_deg_fraction) {
    if (!std::isfinite(within_1_deg_fraction)) {
        return "too short to judge the head";
    }
    char text[80];
    std::snprintf(text, sizeof text, "head within 1 degree for %.1f %% of the time",
                  100.0 * within_1_deg_fraction);
    return text;
}

TruthComparison::TruthComparison(std::shared_ptr<const SimulatedWorld> world,
                                 const Eigen::Vector2d& left_px, std::int64_t frame)
    : world_(std::move(world)),
      true_rig_(world_->true_rig()),
      axes_(world_->profile().head_backlash),
      first_time_ns_(world_->time_ns(frame)) {
    if (const auto point = world_->target_point_under(left_px, frame)) {
        target_point_mm_ = *point;
        on_target_ = true;
    }
}

TruthSample TruthComparison::add(const Snapshot& snapshot) {
    TruthSample sample{world_->point_in_left_mm(target_point_mm_, snapshot.frame), not_known,
                       not_known};
    const bool again = snapshot.frame == last_frame_;
    last_frame_ = snapshot.frame;
    frames_ += again ? 0 : 1;
    const TrackEstimate estimate = steered_estimate(snapshot);
    if (estimate.position) {
        const Eigen::Vector3d& measured = estimate.position->point_in_left_mm;
        sample.range_error_pct = 100.0 * (measured.norm() / sample.point_in_left_mm.norm() - 1.0);
        if (!again && estimate.state == TrackState::tracking) {
            ++tracked_;
            range_error_sum_pct_ += std::abs(sample.range_error_pct);
            range_error_worst_pct_ =
                std::max(range_error_worst_pct_, std::abs(sample.range_error_pct));
            position_error_sum_mm_ += (measured - sample.point_in_left_mm).norm();
        }
    }
    if (snapshot.head) {
        axes_.see(snapshot.head->angles);
        const double error_rad =
            aiming_error_rad(true_rig_, axes_.at(snapshot.head->angles), sample.point_in_left_mm);
        sample.head_error_deg = deg_from_rad(error_rad);
        if (!again && snapshot.time_ns - first_time_ns_ >= settling_ns) {
            ++head_samples_;
            head_within_ += sample.head_error_deg <= 1.0 ? 1 : 0;
            head_error_worst_deg_ = std::max(head_error_worst_deg_, sample.head_error_deg);
        }
    }
    return sample;
}

TruthSummary TruthComparison::summary() const {
    const auto share = [](double part, std::int64_t of) {
        return of > 0 ? part / static_cast<double>(of) : 0.0;
    };
    TruthSummary summary;
    summary.frames = frames_;
    summary.tracked_fraction = share(static_cast<double>(tracked_), frames_);
    summary.range_error_mean_pct = share(range_error_sum_pct_, tracked_);
    summary.range_error_worst_pct = range_error_worst_pct_;
    summary.position_error_mean_mm = share(position_error_sum_mm_, tracked_);
    const bool judged = head_samples_ > 0;
    summary.head_within_1_deg_fraction =
        judged ? share(static_cast<double>(head_within_), head_samples_) : not_known;
    summary.head_error_worst_deg = judged ? head_error_worst_deg_ : not_known;
    return summary;
}

}  // namespace kambara::cli
