// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/stereo/rig_watch.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "core/base/angles.h"
#include "core/base/median.h"

namespace kambara {
namespace {

constexpr double median_over_mean_sigma = 1.2533;  // of a normal distribution: sqrt(pi / 2)
constexpr double sigma_over_mad = 1.4826;
constexpr double restored_share = 0.5;
// Of a calibration whose file tells neither residuals nor covariance: such as good ones leave.
constexpr double usual_rms_px = 0.15;

}  // namespace

RigWatch::RigWatch(const Rig& rig, RigWatchOptions options) : options_(options) {
    if (rig.right) {
        focal_px_ = pinhole_parameters(rig.right->lens).fy_px;
    }
    // A corner's residual, of which the epipolar curve tells one coordinate.
    rms_of_calibration_ = rig.provenance.stereo_rms_px.value_or(usual_rms_px) / std::sqrt(2.0);
}

void RigWatch::reset() {
    matches_.clear();
    moved_ = false;
    state_.reset();
}

void RigWatch::add(std::int64_t time_ns, const EpipolarOffset& epipolar) {
    const auto window_ns = static_cast<std::int64_t>(options_.window_s * 1e9);
    if (!matches_.empty() &&
        (time_ns - matches_.back().time_ns > window_ns || time_ns < matches_.back().time_ns)) {
        reset();
    }
    matches_.push_back({time_ns, epipolar});
    while (time_ns - matches_.front().time_ns > window_ns) {
        matches_.pop_front();
    }
    judge();
}

void RigWatch::judge() {
    if (static_cast<int>(matches_.size()) < options_.least_matches) {
        state_.reset();
        return;
    }
    std::vector<double> offsets;
    std::vector<double> noise;
    std::vector<double> calibration;
    for (const Match& match : matches_) {
        offsets.push_back(match.epipolar.offset_px);
        noise.push_back(match.epipolar.noise_sigma_px);
        calibration.push_back(match.epipolar.calibration_sigma_px.value_or(rms_of_calibration_));
    }
    RigWatchState state;
    state.matches = static_cast<int>(matches_.size());
    state.offset_px = median(offsets);
    std::vector<double> apart;
    apart.reserve(offsets.size());
    for (const double offset : offsets) {
        apart.push_back(std::abs(offset - state.offset_px));
    }
    // The matches scatter by their noise at least; by more where the picture is worse than told.
    const double scatter = std::max(median(noise), sigma_over_mad * median(apart));
    const double independent = std::max(1.0, static_cast<double>(state.matches) / options_.alike);
    const double by_noise = median_over_mean_sigma * scatter / std::sqrt(independent);
    state.sigma_px = std::hypot(by_noise, median(calibration), options_.common_sigma_px);
    state.turn_rad = std::atan(state.offset_px / focal_px_);
    const double limit = options_.suspect_sigmas * state.sigma_px;
    moved_ = std::abs(state.offset_px) > (moved_ ? restored_share * limit : limit);
    state.moved = moved_;
    state_ = state;
}

std::string rig_moved_text(const RigWatchState& state) {
    char text[400];
    std::snprintf(text, sizeof text,
                  "A camera may have moved: the right picture shows things %.2f px %s where the "
                  "calibration expects them (median of %d matches; %.2f px would be usual), as if "
                  "the right camera had tilted %s by %.3f degrees against the left one. Check the "
                  "cameras' mounts, then calibrate again.",
                  std::abs(state.offset_px), state.offset_px > 0.0 ? "below" : "above",
                  state.matches, state.sigma_px, state.offset_px > 0.0 ? "up" : "down",
                  std::abs(deg_from_rad(state.turn_rad)));
    return text;
}

std::string rig_restored_text(const RigWatchState& state) {
    char text[200];
    std::snprintf(text, sizeof text,
                  "The cameras see each other's points where the calibration expects them again "
                  "(%.2f px beside, median of %d matches).",
                  std::abs(state.offset_px), state.matches);
    return text;
}

}  // namespace kambara
