// SPDX-License-Identifier: GPL-3.0-or-later
// The part of StereoTracker that keeps the template up with the target: turn, growth, fresh looks.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/matching/texture.h"
#include "core/tracking/plane_fit.h"
#include "core/tracking/stereo_tracker.h"

namespace kambara {
namespace {

constexpr int realigned_within_px = 5;

// A template of the target as it is seen now, about `pixel`, of the size it has now. Refused where
// it would reach out of the picture or lacks texture.
Result<ReferencePatch> cut_anew(const StereoFrame& frame, const TargetMeasurement& measured,
                                const Eigen::Vector2d& pixel, const Eigen::Vector2i& size) {
    const Eigen::Vector2d corner = pixel - 0.5 * (size.cast<double>() - Eigen::Vector2d::Ones());
    const Rectangle rectangle{static_cast<int>(std::lround(corner.x())),
                              static_cast<int>(std::lround(corner.y())), size.x(), size.y()};
    if (const auto fit = check_template(*frame.left.picture, rectangle); !fit) {
        return fit.error();
    }
    return ReferencePatch{frame.left.picture, pixel, size, measured.point_in_rig_mm, {}};
}

// The share of a measured step to take, when steps have the one deviation and measurements the
// other: theirs is told as if the pixels erred independently, which those of a target that bends or
// of a background do not.
double gain(double step_sigma, double measured_sigma) {
    constexpr double not_independent = 3.0;
    const double step = step_sigma * step_sigma;
    const double measured = not_independent * measured_sigma;
    return step / (step + measured * measured);
}

}  // namespace

Result<Done> StereoTracker::update_template() {
    const bool in_sight =
        estimate_.state == TrackState::tracking || estimate_.state == TrackState::doubtful;
    const bool now = last_measured_ && last_frame_ && estimate_.left_px &&
                     last_frame_->left.index == estimate_.frame;
    if (!in_sight || !now) {
        return Error{"The target is not in sight, so its template can't be updated.",
                     "Wait until it is tracked, or choose a new template."};
    }
    auto cut = cut_anew(*last_frame_, *last_measured_, last_measured_->left.pixel, size_now_px());
    if (!cut) {
        return cut.error();
    }
    cut->slope = looks_->first().slope_now();
    looks_.emplace(*cut);
    slope_ = {};
    estimate_.template_size_px = cut->size_px;
    describe_size();
    ++estimate_.template_updates;
    return Done{};
}

// What was measured is weighed against what a target is likely to do from one pair to the next.
void StereoTracker::follow_change(const TargetMeasurement& measured) {
    const bool sure = estimate_.state == TrackState::tracking;
    if (!measured.left.change || !sure) {
        return;
    }
    const MeasuredChange& change = *measured.left.change;
    PlanarChange step;
    step.turn_rad = gain(options_.turn_sigma_rad, change.turn_sigma_rad) * change.value.turn_rad;
    if (!rig_.right) {  // else its distance tells
        step.scale = std::pow(change.value.scale, gain(options_.growth_sigma, change.scale_sigma));
    }
    looks_->change(step);
}

// From the first pairs in which its distance is known: on one alone the slope is too uncertain to
// carry a template across the field.
void StereoTracker::learn_slope(const TargetMeasurement& measured, const StereoFrame& frame) {
    const bool sure = estimate_.state == TrackState::tracking && measured_by_first_;
    if (!sure || !range_known_ || !measured.position || slope_.is_settled()) {
        return;
    }
    ReferencePatch patch{frame.left.picture, measured.left.pixel, measured.left.size_px,
                         measured.point_in_rig_mm};
    patch.slope = looks_->first().slope_now();
    const auto fit =
        fit_plane(patch, rig_, *frame.right.picture, measured.position->point_in_left_mm.norm());
    if (!fit || fit->likeness < measured.right->likeness_in_noise()) {
        return;
    }
    const Eigen::Matrix2d back =
        Eigen::Rotation2Dd(-looks_->first().change.turn_rad).toRotationMatrix();
    slope_.add(back * fit->slope, back * fit->slope_covariance * back.transpose());
    if (const auto slope = slope_.value()) {
        looks_->lean(*slope);
    }
}

// Of the target, which a turned patch's own box exceeds.
Eigen::Vector2i StereoTracker::size_now_px() const {
    const Eigen::Vector2d size = estimate_.scale * looks_->first().size_px.cast<double>();
    constexpr double smallest = 7.0;
    return size.array().max(smallest).min(largest_template_px).round().cast<int>();
}

// The operator's rectangle as it would be drawn now.
void StereoTracker::describe_size() {
    const ReferencePatch& first = looks_->first();
    const bool known = range_known_ && sure_place_in_rig_mm_ && sure_place_in_rig_mm_->z() > 0.0;
    const double nearer = known ? first.point_in_rig_mm.z() / sure_place_in_rig_mm_->z() : 1.0;
    estimate_.scale = first.change.scale * nearer;
    estimate_.turn_rad = first.change.turn_rad;
}

// Where the first template says that the target is, close to where it was measured, or else the
// mean of what was seen of late. Empty where that is somewhere else, or where neither sees it any
// more: what is measured there may be something that hides it.
std::optional<Eigen::Vector2d> StereoTracker::aligned(const TargetMeasurement& measured,
                                                      const Image& grey) const {
    if (measured_by_first_) {
        return measured.left.pixel;
    }
    for (std::size_t anchor = 0; anchor < looks_->anchors(); ++anchor) {
        const auto seen =
            search_window(looks_->at(anchor), rig_.left, rig_.left, grey,
                          {measured.point_in_rig_mm, realigned_within_px, 0.0}, options_.search);
        if (seen && seen->likeness >= options_.seen_likeness) {
            const double off_px = (seen->pixel - measured.left.pixel).norm();
            return off_px <= options_.update_agreement_px ? std::optional(seen->pixel)
                                                          : std::nullopt;
        }
    }
    return std::nullopt;
}

void StereoTracker::refresh_template(const TargetMeasurement& measured, const StereoFrame& frame) {
    const bool safe = estimate_.state == TrackState::tracking && (range_known_ || !rig_.right);
    // In stereo the first template fits for long, and the mean is begun when it no longer does.
    const bool first_will_do = rig_.right && measured_by_first_ && fits_well(measured.left);
    if (!options_.automatic_update || !safe || first_will_do) {
        return;
    }
    const auto pixel = aligned(measured, *frame.left.picture);
    const auto place =
        pixel ? place_at_depth(rig_.left, *pixel, measured.point_in_rig_mm.z()) : std::nullopt;
    if (!place) {
        return;
    }
    looks_->blend(rig_.left, *frame.left.picture, *place, options_.blend_share);
    if (measured.left.likeness >= options_.update_likeness) {
        return;
    }
    if (auto cut = cut_anew(frame, measured, *pixel, measured.left.size_px)) {
        cut->slope = looks_->first().slope_now();
        looks_->add(*cut);
        ++estimate_.template_updates;
    }
}

}  // namespace kambara
