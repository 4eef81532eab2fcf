// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/predictor.h"

#include <algorithm>

namespace kambara {
namespace {

constexpr double newest_share = 0.5;

}  // namespace

void Predictor::reset() {
    *this = Predictor();
}

void Predictor::update(std::int64_t time_ns, const Eigen::Vector3d& point_mm) {
    const double step_s = static_cast<double>(time_ns - time_ns_) * 1e-9;
    if (point_mm_ && step_s > 0.0) {
        if (step_s > farthest_ahead_s) {
            has_velocity_ = false;
            velocity_mm_s_.setZero();
        } else {
            const Eigen::Vector3d newest = (point_mm - *point_mm_) / step_s;
            velocity_mm_s_ =
                has_velocity_
                    ? Eigen::Vector3d((1.0 - newest_share) * velocity_mm_s_ + newest_share * newest)
                    : newest;
            has_velocity_ = true;
        }
    }
    point_mm_ = point_mm;
    time_ns_ = time_ns;
}

std::optional<Eigen::Vector3d> Predictor::at(std::int64_t time_ns) const {
    if (!point_mm_) {
        return std::nullopt;
    }
    const double ahead_s = static_cast<double>(time_ns - time_ns_) * 1e-9;
    return *point_mm_ + std::clamp(ahead_s, 0.0, farthest_ahead_s) * velocity_mm_s_;
}

}  // namespace kambara
