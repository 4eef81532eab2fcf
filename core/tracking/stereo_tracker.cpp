// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/stereo_tracker.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/matching/noise.h"
#include "core/matching/texture.h"

namespace kambara {
namespace {

constexpr int frames_between_full_searches = 5;
constexpr double preferred_by = 0.05;   // so much worse may the first template be and still decide
constexpr double surprise_kept = 0.8;   // from one pair to the next
constexpr double surprise_grows = 1.5;  // likewise, while it is not seen
constexpr double reach_by_surprise = 2.0;
constexpr double least_reach_px = 4.0;
// How far a look that changes may shift from one picture to the next, with no second picture to
// tell: a velocity that followed such slips would lead the search astray. By the recordings of one
// camera; 10 to 20 px do.
constexpr double slip_px = 20.0;
constexpr double range_share_unknown = 0.05;  // of a distance that only the last ones tell

double quality_of(const std::optional<TargetMeasurement>& measured) {
    return measured && !measured->ambiguous ? measured->quality : 0.0;
}

std::string percent(double share) {
    return std::to_string(static_cast<int>(std::lround(100.0 * share))) + " %";
}

}  // namespace

void TrackEstimate::forget_place() {
    left_px.reset();
    right_px.reset();
    position.reset();
    motion.reset();
    search.reset();
    quality = 0.0;
}

StereoTracker::StereoTracker(Rig rig, TrackerOptions options,
                             std::shared_ptr<TransformCache> transforms)
    : rig_(std::move(rig)),
      options_(options),
      clear_method_(options.search.method),
      transforms_(transforms ? std::move(transforms) : std::make_shared<TransformCache>()) {
    options_.search.transforms = transforms_.get();
    if (!rig_.right) {
        // A direction alone: a hundredth of a pixel does not matter, time does.
        options_.search.refined = Drawing::fast;
    }
}

Result<Done> StereoTracker::set_template(const StereoFrame& frame, const Rectangle& rectangle) {
    if (auto fit = check_template(*frame.left.picture, rectangle); !fit) {
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
    transforms_->keep(frame.left.picture);
    transforms_->keep(frame.right.picture);
    looks_.emplace(ReferencePatch{frame.left.picture,
                                  centre,
                                  Eigen::Vector2i(rectangle.width, rectangle.height),
                                  ray->at(options_.assumed_range_mm),
                                  {}});
    estimate_.template_size_px = looks_->first().size_px;
    become(TrackState::template_set, "");
    PatchMatch here;
    here.pixel = centre;
    here.likeness = 1.0;
    here.quality = 1.0;
    here.size_px = looks_->first().size_px;
    const Image& grey = *frame.left.picture;
    here.clearness = likeness_kept({}, grey, rectangle, grey, rectangle);
    see_clearness(here);
    here.covariance_px2 =
        options_.search.floor_px * options_.search.floor_px * Eigen::Matrix2d::Identity();
    auto detail = std::make_shared<SearchDetail>();
    SearchScope scope{looks_->first().point_in_rig_mm};
    scope.try_slopes = true;
    adopt(complete_from_left(rig_, options_, nullptr, frame, scope, here, detail.get()), frame);
    estimate_.search = std::move(detail);
    return Done{};
}

Result<Done> StereoTracker::start() {
    if (!looks_) {
        return Error{"There is no template to follow.", "Choose one in the left picture first."};
    }
    started_ = true;
    return Done{};
}

void StereoTracker::stop() {
    started_ = false;
    estimate_.forget_place();
    if (looks_) {
        become(TrackState::template_set, "");
    }
}

void StereoTracker::clear() {
    looks_.reset();
    slope_ = {};
    last_measured_.reset();
    sure_place_in_rig_mm_.reset();
    last_frame_.reset();
    predictor_.reset();
    options_.search.method = clear_method_;
    range_known_ = false;
    pairs_ = 0;
    started_ = false;
    place_unknown_ = false;
    surprise_px_ = 0.0;
    to_be_confirmed_ = false;
    frames_in_state_ = 0;
    estimate_ = {};
}

void StereoTracker::forget_motion() {
    predictor_.reset();
    last_frame_.reset();
    surprise_px_ = 0.0;
    place_unknown_ = true;
}

TrackEstimate StereoTracker::process(const StereoFrame& frame) {
    if (!started_ || !looks_) {
        if (frame.left.index != estimate_.frame) {
            estimate_.forget_place();  // it was measured in another pair
        }
        return estimate_;
    }
    transforms_->keep(frame.left.picture);
    transforms_->keep(frame.right.picture);
    ++frames_in_state_;
    const bool lost = estimate_.state == TrackState::lost || place_unknown_;
    const bool everywhere =
        place_unknown_ || (lost && frames_in_state_ % frames_between_full_searches == 1);
    estimate_.forget_place();
    estimate_.frame = frame.left.index;
    const SearchScope scope{expected_place(frame.left.time_ns),
                            range_known_,
                            lost,
                            everywhere,
                            place_unknown_,
                            reach_px(frame.left.time_ns),
                            ++pairs_ % options_.slopes_every == 0};
    const auto measured = measure(frame, scope);
    if (measured && measured->left.quality >= options_.good_quality) {
        see_clearness(measured->left);  // of the target, not of what is taken for it when lost
    }
    estimate_.quality = measured ? measured->left.quality : 0.0;
    if (!measured) {
        place_unknown_ = false;  // from here on it is Lost, which looks everywhere as well
        miss(lost ? "looking for it: nothing in the left picture is clearly it"
                  : "the predicted place is outside the left picture");
    } else if (says_nothing(options_, measured->left)) {
        miss("the likest place in the left picture is right with a probability of only " +
             percent(measured->left.quality));
    } else if (measured->ambiguous) {
        grow_surprise();
        judge(*measured);
        to_be_confirmed_ = true;
    } else {
        note_surprise(*measured, scope.expected_in_rig_mm);
        adopt(*measured, frame);
        judge(*measured);
        follow_change(*measured);
        learn_slope(*measured, frame);
        refresh_template(*measured, frame);
    }
    describe_size();
    return estimate_;
}

// How far off the prediction the target may well be in the left picture.
double StereoTracker::reach_px(std::int64_t time_ns) const {
    const double since_s = static_cast<double>(time_ns - seen_time_ns_) * 1e-9;
    if (!predictor_.has_velocity()) {
        return std::max(options_.fastest_px_s * since_s, least_reach_px);
    }
    const double stalled_s = std::max(0.0, since_s - Predictor::farthest_ahead_s);
    return least_reach_px + reach_by_surprise * surprise_px_ + options_.fastest_px_s * stalled_s;
}

void StereoTracker::note_surprise(const TargetMeasurement& measured,
                                  const Eigen::Vector3d& expected_in_rig_mm) {
    if (const auto expected = rig_.left.project(expected_in_rig_mm)) {
        const double now_px = (measured.left.pixel - *expected).norm();
        surprise_px_ = std::max(now_px, surprise_kept * surprise_px_);
    }
}

void StereoTracker::grow_surprise() {
    // Half the picture is as good as anywhere; more would take long to forget.
    const double most_px = 0.5 * std::max(rig_.left.width_px, rig_.left.height_px);
    surprise_px_ = std::min(std::max(surprise_px_, 1.0) * surprise_grows, most_px);
}

// While no distance is measured, none may be predicted: the one assumed stays, or the patch would
// be drawn ever smaller or larger.
Eigen::Vector3d StereoTracker::at_known_range(const Eigen::Vector3d& point_in_rig_mm) const {
    if (range_known_) {
        return point_in_rig_mm;
    }
    const Eigen::Vector3d eye = rig_.left.T_camera_from_rig.centre_mm();
    const double assumed_mm = (looks_->first().point_in_rig_mm - eye).norm();
    return eye + assumed_mm * (point_in_rig_mm - eye).normalized();
}

// Where the target is thought to be. Once it is lost, a place in sight and at the distance it was
// last tracked at, since a target that has left the picture comes back somewhere inside, and a
// motion towards or from the camera that goes on and on would soon make it too large or too small
// to be seen.
Eigen::Vector3d StereoTracker::expected_place(std::int64_t time_ns) const {
    const Eigen::Vector3d expected =
        predictor_.at(time_ns).value_or(looks_->first().point_in_rig_mm);
    if (estimate_.state != TrackState::lost && !place_unknown_) {
        return at_known_range(expected);
    }
    const auto pixel = rig_.left.project(expected);
    const Eigen::Vector3d last = sure_place_in_rig_mm_.value_or(looks_->first().point_in_rig_mm);
    const Eigen::Vector2d middle(0.5 * (rig_.left.width_px - 1), 0.5 * (rig_.left.height_px - 1));
    const Eigen::Vector2d half = 0.5 * looks_->first().size_px.cast<double>();
    const Eigen::Vector2d nearest =
        pixel ? Eigen::Vector2d(pixel->cwiseMax(half).cwiseMin(2.0 * middle - half)) : middle;
    return place_at_depth(rig_.left, nearest, last.z()).value_or(expected);
}

// Smoothing costs detail where there is no noise, and saves what there is where there is much.
void StereoTracker::see_clearness(const PatchMatch& match) {
    if (clear_method_ != MatchMethod{Measure::zncc, Transform::none, clear_method_.step}) {
        return;
    }
    if (match.clearness < options_.dim_clearness) {
        options_.search.method.transform = Transform::gaussian;
    } else if (match.clearness > options_.clear_clearness) {
        options_.search.method = clear_method_;
    }
}

// So well that no other look could fit better: noise counts, since the mean of many has less.
bool StereoTracker::fits_well(const PatchMatch& match) const {
    return match.likeness_in_noise() >= options_.good_enough_likeness;
}

// The first template decides unless a later one fits clearly better.
std::optional<TargetMeasurement> StereoTracker::measure(const StereoFrame& frame,
                                                        const SearchScope& scope) {
    auto detail = std::make_shared<SearchDetail>();
    auto best = search_target(rig_, options_, looks_->first(), frame, scope, detail.get());
    std::size_t best_look = 0;
    double to_beat = quality_of(best) + preferred_by;
    for (const std::size_t look : looks_->later_by_use()) {
        if (best && !best->ambiguous && fits_well(best->left)) {
            break;
        }
        auto other_detail = std::make_shared<SearchDetail>();
        auto other = search_target(rig_, options_, looks_->at(look), frame, scope,
                                   other_detail.get(), to_beat);
        if (quality_of(other) > to_beat) {
            to_beat = quality_of(other);
            best = std::move(other);
            detail = std::move(other_detail);
            best_look = look;
        }
    }
    estimate_.search = std::move(detail);
    measured_by_first_ = best_look == 0;
    if (best && best_look > 0) {
        looks_->used(best_look);
    }
    return best;
}

void StereoTracker::adopt(const TargetMeasurement& measured, const StereoFrame& frame) {
    last_measured_ = measured;
    last_frame_ = frame;
    place_unknown_ = false;
    seen_time_ns_ = frame.left.time_ns;
    estimate_.frame = frame.left.index;
    estimate_.left_px = measured.left.pixel;
    estimate_.right_px.reset();
    if (measured.right) {
        estimate_.right_px = measured.right->pixel;
    }
    estimate_.position = measured.position;
    estimate_.quality = measured.quality;
    estimate_.reason = measured.fault;
    // How a lost one came here is not known; before the first position all lay at an assumed
    // distance.
    if (estimate_.state == TrackState::lost || (measured.position && !range_known_)) {
        predictor_.reset();
    }
    predictor_.update(frame.left.time_ns, measured.point_in_rig_mm,
                      covariance_in_rig_mm2(measured));
    estimate_.motion = motion_in_left();
    if (measured.position && !range_known_ && measured.quality >= options_.good_quality) {
        anchor(measured.point_in_rig_mm);
        if (measured.right->slope) {
            looks_->first().slope = *measured.right->slope;
        }
    }
}

// Without a position, the left pixel's alone: across the ray known, along it hardly.
Eigen::Matrix3d StereoTracker::covariance_in_rig_mm2(const TargetMeasurement& measured) const {
    const Eigen::Matrix3d& R = rig_.left.T_camera_from_rig.R;
    if (measured.position) {
        return R.transpose() * measured.position->covariance_mm2 * R;
    }
    const Eigen::Vector3d& point = measured.point_in_rig_mm;
    const Eigen::Vector3d ray = point - rig_.left.T_camera_from_rig.centre_mm();
    Eigen::Matrix<double, 2, 3> pixel_by_point;
    double across_mm = least_reach_px;
    if (rig_.left.project(point, pixel_by_point)) {
        const double px_by_mm = pixel_by_point.norm() / std::sqrt(2.0);
        const double slip = range_known_ ? 0.0 : slip_px;
        across_mm = std::sqrt(measured.left.covariance_px2.trace() + slip * slip) / px_by_mm;
    }
    return across_mm * across_mm * Eigen::Matrix3d::Identity() +
           range_share_unknown * range_share_unknown * ray * ray.transpose();
}

std::optional<Eigen::Vector3d> StereoTracker::expected_in_left_mm(std::int64_t time_ns) const {
    const auto in_rig_mm = predictor_.at(time_ns);
    return in_rig_mm ? std::optional<Eigen::Vector3d>(rig_.left.T_camera_from_rig * *in_rig_mm)
                     : std::nullopt;
}

std::optional<MotionEstimate> StereoTracker::motion_in_left() const {
    auto motion = predictor_.motion();
    if (motion) {
        const RigidTransform& T_left_from_rig = rig_.left.T_camera_from_rig;
        motion->point_mm = T_left_from_rig * motion->point_mm;
        motion->velocity_mm_s = T_left_from_rig.R * motion->velocity_mm_s;
        motion->acceleration_mm_s2 = T_left_from_rig.R * motion->acceleration_mm_s2;
        motion->velocity_covariance_mm2_s2 =
            T_left_from_rig.R * motion->velocity_covariance_mm2_s2 * T_left_from_rig.R.transpose();
    }
    return motion;
}

// From the first position on, the template's own distance is known and its size can be followed.
void StereoTracker::anchor(const Eigen::Vector3d& point_in_rig_mm) {
    const Eigen::Vector3d eye = rig_.left.T_camera_from_rig.centre_mm();
    ReferencePatch& first = looks_->first();
    if (const auto ray = rig_.left.unproject(first.centre_px)) {
        first.point_in_rig_mm = ray->at((point_in_rig_mm - eye).norm());
        range_known_ = true;
    }
}

void StereoTracker::judge(const TargetMeasurement& measured) {
    // What confirms must be surer than what goes on.
    const bool unsure = measured.left.unrivalled < options_.found_quality;
    const bool confirmed = !std::exchange(to_be_confirmed_, to_be_confirmed_ && unsure);
    if (!measured.fault.empty()) {
        become(TrackState::doubtful, measured.fault);
    } else if (!confirmed) {
        become(TrackState::doubtful, "seen again after doubt: the next picture decides");
    } else if (measured.quality < options_.good_quality) {
        become(TrackState::doubtful,
               "the match is right with a probability of only " + percent(measured.quality));
    } else {
        become(TrackState::tracking, "");
        sure_place_in_rig_mm_ = measured.point_in_rig_mm;
    }
    if (estimate_.state == TrackState::doubtful && frames_in_state_ >= options_.doubtful_frames) {
        become(TrackState::lost, "doubtful for too long: " + estimate_.reason);
        estimate_.forget_place();
    }
}

void StereoTracker::miss(const std::string& why) {
    become(TrackState::lost, why);
    options_.search.method = clear_method_;  // what was last seen may not have been the target
    grow_surprise();
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
