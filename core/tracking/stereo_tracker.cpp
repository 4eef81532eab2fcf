// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/stereo_tracker.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/matching/texture.h"

namespace kambara {
namespace {

constexpr int frames_between_full_searches = 5;
constexpr double preferred_by = 0.05;  // so much worse may the first template be and still decide

// A template of the target as it is seen now, of the size it has now. Refused where it would reach
// out of the picture or lacks texture.
Result<ReferencePatch> cut_anew(const StereoFrame& frame, const TargetMeasurement& measured) {
    const Eigen::Vector2i size = measured.left.size_px;
    const Eigen::Vector2d corner =
        measured.left.pixel - 0.5 * (size.cast<double>() - Eigen::Vector2d::Ones());
    const Rectangle rectangle{static_cast<int>(std::lround(corner.x())),
                              static_cast<int>(std::lround(corner.y())), size.x(), size.y()};
    if (const auto fit = check_template(*frame.left.picture, rectangle); !fit) {
        return fit.error();
    }
    return ReferencePatch{frame.left.picture, measured.left.pixel, size, measured.point_in_rig_mm};
}

std::string percent(double share) {
    return std::to_string(static_cast<int>(std::lround(100.0 * share))) + " %";
}

}  // namespace

void TrackEstimate::forget_place() {
    left_px.reset();
    right_px.reset();
    position.reset();
    search.reset();
    quality = 0.0;
}

StereoTracker::StereoTracker(Rig rig, TrackerOptions options)
    : rig_(std::move(rig)), options_(options) {}

Result<Done> StereoTracker::set_template(const StereoFrame& frame, const Rectangle& rectangle) {
    if (const auto fit = check_template(*frame.left.picture, rectangle); !fit) {
        return fit;
    }
    const Eigen::Vector2d centre(rectangle.centre_x_px(), rectangle.centre_y_px());
    const auto ray = rig_.left.unproject(centre);
    if (!ray) {
        return Error{"The template " + to_string(rectangle) +
                         " lies where the left lens's calibration does not reach.",
                     "Choose a place nearer to the middle of the picture."};
    }
    clear();
    first_ = ReferencePatch{frame.left.picture, centre,
                            Eigen::Vector2i(rectangle.width, rectangle.height),
                            ray->at(options_.assumed_range_mm)};
    estimate_.template_size_px = first_->size_px;
    become(TrackState::template_set, "");
    PatchMatch here;
    here.pixel = centre;
    here.quality = 1.0;
    here.size_px = first_->size_px;
    here.covariance_px2 =
        options_.search.floor_px * options_.search.floor_px * Eigen::Matrix2d::Identity();
    auto detail = std::make_shared<SearchDetail>();
    adopt(complete_from_left(rig_, options_, frame, SearchScope{first_->point_in_rig_mm}, here,
                             detail.get()),
          frame);
    estimate_.search = std::move(detail);
    return Done{};
}

Result<Done> StereoTracker::start() {
    if (!first_) {
        return Error{"There is no template to follow.", "Choose one in the left picture first."};
    }
    started_ = true;
    return Done{};
}

void StereoTracker::stop() {
    started_ = false;
    estimate_.forget_place();
    if (first_) {
        become(TrackState::template_set, "");
    }
}

void StereoTracker::clear() {
    first_.reset();
    latest_.reset();
    last_measured_.reset();
    sure_place_in_rig_mm_.reset();
    last_frame_.reset();
    predictor_.reset();
    range_known_ = false;
    started_ = false;
    place_unknown_ = false;
    frames_in_state_ = 0;
    frames_since_update_ = 0;
    estimate_ = {};
}

void StereoTracker::forget_motion() {
    predictor_.reset();
    last_frame_.reset();
    place_unknown_ = true;
}

Result<Done> StereoTracker::update_template() {
    const bool in_sight =
        estimate_.state == TrackState::tracking || estimate_.state == TrackState::doubtful;
    if (!in_sight || !last_measured_ || !last_frame_) {
        return Error{"The target is not in sight, so its template can't be updated.",
                     "Wait until it is tracked, or choose a new template."};
    }
    const auto cut = cut_anew(*last_frame_, *last_measured_);
    if (!cut) {
        return cut.error();
    }
    first_ = *cut;
    latest_.reset();
    ++estimate_.template_updates;
    return Done{};
}

TrackEstimate StereoTracker::process(const StereoFrame& frame) {
    if (!started_ || !first_) {
        if (frame.left.index != estimate_.frame) {
            estimate_.forget_place();  // it was measured in another pair
        }
        return estimate_;
    }
    ++frames_in_state_;
    ++frames_since_update_;
    const bool lost = estimate_.state == TrackState::lost || place_unknown_;
    const bool everywhere = lost && frames_in_state_ % frames_between_full_searches == 1;
    estimate_.forget_place();
    estimate_.frame = frame.left.index;
    const auto measured = measure(frame, expected_place(frame.left.time_ns), lost, everywhere);
    estimate_.quality = measured ? measured->left.quality : 0.0;
    if (!measured) {
        place_unknown_ = false;  // from here on it is Lost, which looks everywhere as well
        miss(lost ? "looking for it: nothing in the left picture is clearly it"
                  : "the predicted place is outside the left picture");
    } else if (measured->left.quality < options_.lost_quality) {
        miss("the most similar place in the left picture is only " +
             percent(measured->left.quality) + " alike");
    } else {
        adopt(*measured, frame);
        judge(*measured);
        refresh_template(*measured, frame);
    }
    return estimate_;
}

// Where the target is thought to be. Once it is lost, a place in sight and at the distance it was
// last tracked at, since a target that has left the picture comes back somewhere inside, and a
// motion towards or from the camera that goes on and on would soon make it too large or too small
// to be seen.
Eigen::Vector3d StereoTracker::expected_place(std::int64_t time_ns) const {
    const Eigen::Vector3d expected = predictor_.at(time_ns).value_or(first_->point_in_rig_mm);
    if (estimate_.state != TrackState::lost && !place_unknown_) {
        return expected;
    }
    const auto pixel = rig_.left.project(expected);
    const Eigen::Vector3d last = sure_place_in_rig_mm_.value_or(first_->point_in_rig_mm);
    const Eigen::Vector2d middle(0.5 * (rig_.left.width_px - 1), 0.5 * (rig_.left.height_px - 1));
    const Eigen::Vector2d half = 0.5 * first_->size_px.cast<double>();
    const Eigen::Vector2d nearest =
        pixel ? Eigen::Vector2d(pixel->cwiseMax(half).cwiseMin(2.0 * middle - half)) : middle;
    const auto ray = rig_.left.unproject(nearest);
    return ray ? ray->at((last - rig_.left.T_camera_from_rig.centre_mm()).norm()) : expected;
}

// With both templates, the first decides unless it fits clearly worse.
std::optional<TargetMeasurement> StereoTracker::measure(const StereoFrame& frame,
                                                        const Eigen::Vector3d& expected_in_rig_mm,
                                                        bool lost, bool everywhere) {
    const SearchScope scope{expected_in_rig_mm, range_known_, lost, everywhere};
    auto detail = std::make_shared<SearchDetail>();
    auto by_first = search_target(rig_, options_, *first_, frame, scope, detail.get());
    estimate_.search = std::move(detail);
    first_seen_px_.reset();
    if (by_first && by_first->left.quality >= options_.lost_quality) {
        first_seen_px_ = by_first->left.pixel;
    }
    if (!latest_ || (by_first && by_first->quality >= options_.update_quality)) {
        return by_first;
    }
    detail = std::make_shared<SearchDetail>();
    auto by_latest = search_target(rig_, options_, *latest_, frame, scope, detail.get());
    if (!by_latest || (by_first && by_first->quality >= by_latest->quality - preferred_by)) {
        return by_first;
    }
    estimate_.search = std::move(detail);
    return by_latest;
}

void StereoTracker::adopt(const TargetMeasurement& measured, const StereoFrame& frame) {
    last_measured_ = measured;
    last_frame_ = frame;
    place_unknown_ = false;
    estimate_.frame = frame.left.index;
    estimate_.left_px = measured.left.pixel;
    estimate_.right_px.reset();
    if (measured.right) {
        estimate_.right_px = measured.right->pixel;
    }
    estimate_.position = measured.position;
    estimate_.quality = measured.quality;
    estimate_.reason = measured.fault;
    if (measured.position && !range_known_) {
        predictor_.reset();  // what it has seen so far lay at an assumed distance
    }
    predictor_.update(frame.left.time_ns, measured.point_in_rig_mm);
    if (measured.position && !range_known_) {
        anchor(measured.point_in_rig_mm);
    }
}

// From the first position on, the template's own distance is known and its size can be followed.
void StereoTracker::anchor(const Eigen::Vector3d& point_in_rig_mm) {
    const Eigen::Vector3d eye = rig_.left.T_camera_from_rig.centre_mm();
    if (const auto ray = rig_.left.unproject(first_->centre_px)) {
        first_->point_in_rig_mm = ray->at((point_in_rig_mm - eye).norm());
        range_known_ = true;
    }
}

void StereoTracker::judge(const TargetMeasurement& measured) {
    if (!measured.fault.empty()) {
        become(TrackState::doubtful, measured.fault);
    } else if (measured.quality < options_.good_quality) {
        become(TrackState::doubtful, "the match is only " + percent(measured.quality) + " alike");
    } else {
        become(TrackState::tracking, "");
        sure_place_in_rig_mm_ = measured.point_in_rig_mm;
    }
    if (estimate_.state == TrackState::doubtful && frames_in_state_ >= options_.doubtful_frames) {
        become(TrackState::lost, "doubtful for too long: " + estimate_.reason);
        estimate_.forget_place();
    }
}

void StereoTracker::refresh_template(const TargetMeasurement& measured, const StereoFrame& frame) {
    // Where the first template still sees the target at all, it must be here.
    const bool agreed = !first_seen_px_ || (*first_seen_px_ - measured.left.pixel).norm() <
                                               options_.update_agreement_px;
    const bool safe = estimate_.state == TrackState::tracking && range_known_ && agreed;
    if (options_.automatic_update && safe && measured.quality < options_.update_quality &&
        frames_since_update_ >= options_.update_interval_frames) {
        frames_since_update_ = 0;
        if (const auto cut = cut_anew(frame, measured)) {
            latest_ = *cut;
            ++estimate_.template_updates;
        }
    }
}

void StereoTracker::miss(const std::string& why) {
    become(TrackState::lost, why);
    if (frames_in_state_ >= options_.give_up_frames) {
        started_ = false;
        become(TrackState::template_set, "given up: " + why);
    }
}

void StereoTracker::become(TrackState state, std::string reason) {
    if (state != estimate_.state) {
        frames_in_state_ = 0;
        estimate_.state = state;
    }
    estimate_.reason = std::move(reason);
}

}  // namespace kambara
