// SPDX-License-Identifier: GPL-3.0-or-later
#include "hardware/simulated/held_target.h"

#include <algorithm>
#include <cmath>

namespace kambara {
namespace {

constexpr std::size_t most_told = 600;  // 20 s at 30 Hz: no camera is as late as that
// Numbers of still poses that no pose of the profile's own has.
constexpr std::int64_t first_still = std::int64_t{1} << 40;

HeldTarget::Pose between(const HeldTarget::Pose& a, const HeldTarget::Pose& b, double share) {
    return {a.middle_mm + share * (b.middle_mm - a.middle_mm), a.turned.slerp(share, b.turned)};
}

}  // namespace

HeldTarget::HeldTarget() : HeldTarget(Options()) {}

HeldTarget::HeldTarget(const Options& options) : options_(options), random_(options.seed) {}

void HeldTarget::hold(const Pose& goal, bool by_helper) {
    const std::lock_guard lock(mutex_);
    Pose taken = goal;
    if (by_helper) {
        std::normal_distribution<double> normal;
        for (int i = 0; i < 3; ++i) {
            taken.middle_mm[i] += options_.off_mm * normal(random_);
            const double angle = options_.off_rad * normal(random_);
            taken.turned = taken.turned * Eigen::AngleAxisd(angle, Eigen::Vector3d::Unit(i));
        }
    }
    goal_ = taken;
    arrived_ = false;
}

void HeldTarget::let_go() {
    const std::lock_guard lock(mutex_);
    goal_.reset();
    told_.clear();
}

HeldTarget::At HeldTarget::after(const At& before, double seconds) {
    if (arrived_) {
        return before;
    }
    const double way_mm = (goal_->middle_mm - before.pose.middle_mm).norm();
    const double way_rad = before.pose.turned.angularDistance(goal_->turned);
    const double needs_s = std::max(way_mm / options_.speed_mm_s, way_rad / options_.turning_rad_s);
    if (needs_s <= seconds) {
        arrived_ = true;
        return {*goal_, first_still + arrivals_++};
    }
    return {between(before.pose, *goal_, seconds / needs_s), -1};
}

std::optional<HeldTarget::At> HeldTarget::at(double time_s, const Pose& from) {
    const std::lock_guard lock(mutex_);
    if (!goal_) {
        return std::nullopt;
    }
    if (told_.empty()) {
        told_.push_back({time_s, {from, -1}});
    }
    if (time_s > told_.back().time_s) {
        const At now = after(told_.back().at, time_s - told_.back().time_s);
        told_.push_back({time_s, now});
        if (told_.size() > most_told) {
            told_.pop_front();
        }
        return now;
    }
    // A camera that is late, or another one at the same time.
    const auto next =
        std::lower_bound(told_.begin(), told_.end(), time_s,
                         [](const Told& told, double wanted_s) { return told.time_s < wanted_s; });
    if (next == told_.begin() || next->time_s == time_s) {
        return next->at;
    }
    const Told& last = *std::prev(next);
    if (last.at.still_since >= 0 && last.at.still_since == next->at.still_since) {
        return last.at;
    }
    const double share = (time_s - last.time_s) / (next->time_s - last.time_s);
    return At{between(last.at.pose, next->at.pose, share), -1};
}

}  // namespace kambara
