// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/vsystem/pan_tilt_servo.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/camera/zoom.h"
#include "core/pointing/aim.h"
#include "core/pointing/pan_tilt_view.h"
#include "core/tracking/patch_search.h"
#include "core/vsystem/picture_fit.h"

namespace kambara {
namespace {

// What a wrong mount may be off by: five degrees in the nominal camera at its widest, 1.7 where it
// enlarges three times.
constexpr int look_radius_px = 64;
constexpr int pictures_between_checks = 15;
constexpr int pictures_between_tries = 3;
constexpr double most_magnified = 3.0;  // a look drawn larger has too little detail
constexpr int largest_cut_px = 41;      // larger ones take long
constexpr double farthest_from_look_px = 3.0;
constexpr double assumed_range_mm = 1500.0;
constexpr double second_ns = 1e9;
constexpr std::int64_t stale_after_ns = 400'000'000;
// A step of the motors in a thirtieth of a second, halved.
constexpr double turn_sigma_rad_s = 0.02;

// The pan-tilt camera as the only one, in its own frame.
Rig alone_in(const Camera& camera) {
    Rig rig;
    rig.left = camera;
    rig.left.T_camera_from_rig = RigidTransform{};
    return rig;
}

Rectangle about(const Eigen::Vector2d& middle, const Eigen::Vector2i& size) {
    return {static_cast<int>(std::lround(middle.x() - 0.5 * (size.x() - 1))),
            static_cast<int>(std::lround(middle.y() - 0.5 * (size.y() - 1))), size.x(), size.y()};
}

}  // namespace

PanTiltServo::PanTiltServo(const Rig& rig, const TrackerOptions& options) : options_(options) {
    use_rig(rig);
}

void PanTiltServo::use_rig(const Rig& rig) {
    rig_ = rig;
    tracker_.reset();
    on_ = on_ && rig_.pan_tilt.has_value();
    forget();
}

void PanTiltServo::forget() {
    if (rig_.pan_tilt) {
        tracker_ = std::make_unique<StereoTracker>(alone_in(*rig_.pan_tilt), options_);
        turns_ = std::make_shared<VehicleTrack>();
        tracker_->follow_vehicle(turns_);
    }
    aim_.forget();
    last_angles_.reset();
    sure_ = false;
    by_hand_ = false;
    apart_ = false;
    pictures_until_check_ = 0;
}

void PanTiltServo::wound() {
    forget();
    last_index_ = -1;
}

Result<Done> PanTiltServo::set_on(bool on) {
    if (on && !rig_.pan_tilt) {
        return Error{"The rig file does not say where the pan-tilt camera is.",
                     "Calibrate it with the others first."};
    }
    if (!on) {
        forget();
    }
    on_ = on;
    return Done{};
}

Result<Done> PanTiltServo::select(const Frame& grey, const HeadAngles& angles, double magnified,
                                  const Rectangle& rectangle) {
    if (!on_ || !tracker_) {
        return Error{"The pan-tilt picture is not followed.", "Switch that on first."};
    }
    if (!fits(*grey.picture, *rig_.pan_tilt)) {
        return Error{"The pan-tilt pictures are " + std::to_string(grey.picture->width()) + " x " +
                         std::to_string(grey.picture->height()) + ", the calibration is for " +
                         std::to_string(rig_.pan_tilt->width_px) + " x " +
                         std::to_string(rig_.pan_tilt->height_px) + ".",
                     "Calibrate at this resolution, or set the camera to that one."};
    }
    if (auto cut = tracker_->set_template({grey, {}}, rectangle); !cut) {
        return cut;
    }
    (void)tracker_->start();
    aim_.forget();
    by_hand_ = true;
    apart_ = false;
    note_turn(angles, grey.time_ns, magnified);
    last_index_ = grey.index - 1;  // this picture is followed as well
    return Done{};
}

// What the head turned since the last picture, in the camera's own axes; more where that moves a
// magnified picture more.
void PanTiltServo::note_turn(const HeadAngles& angles, std::int64_t time_ns, double magnified) {
    if (last_angles_ && time_ns > last_time_ns_) {
        const Eigen::Matrix3d R_last_from_now =
            pan_tilt_camera_at(rig_, *last_angles_).T_camera_from_rig.R *
            pan_tilt_camera_at(rig_, angles).T_camera_from_rig.R.transpose();
        const Eigen::AngleAxisd turned(R_last_from_now);
        VehicleMotion motion;
        motion.turn_rad_s = magnified * second_ns / static_cast<double>(time_ns - last_time_ns_) *
                            turned.angle() * turned.axis();
        motion.turn_sigma_rad_s = turn_sigma_rad_s;
        motion.velocity_sigma_mm_s = 0.0;
        for (const std::int64_t at_ns : {last_time_ns_ + 1, time_ns}) {
            motion.time_ns = at_ns;
            turns_->add(motion);
        }
    } else if (!last_angles_) {
        VehicleMotion motion;
        motion.time_ns = time_ns;
        motion.velocity_sigma_mm_s = 0.0;
        turns_->add(motion);
    }
    last_angles_ = angles;
    last_time_ns_ = time_ns;
}

bool PanTiltServo::follows() const {
    return tracker_ && tracker_->started();
}

double PanTiltServo::range_mm(const Seen& seen) const {
    if (seen.stereo == nullptr || !seen.stereo->estimate().position) {
        return assumed_range_mm;
    }
    const Eigen::Vector3d in_rig =
        rig_.left.T_camera_from_rig.inverse() * seen.stereo->estimate().position->point_in_left_mm;
    return (pan_tilt_camera_at(rig_, seen.angles).T_camera_from_rig * in_rig).norm();
}

// Where the look that the stereo pair follows is seen; it shows the same point of the target.
std::optional<PatchMatch> PanTiltServo::found_by_look(const Seen& seen) const {
    const ReferencePatch* look = seen.stereo->look();
    if (look == nullptr || seen.magnified > most_magnified) {
        return std::nullopt;
    }
    Camera camera = pan_tilt_camera_at(rig_, seen.angles);
    camera.lens = zoomed(camera.lens, seen.magnified);
    PatchSearchOptions search = options_.search;
    search.measure_change = false;
    search.transforms = nullptr;
    WindowScope scope{rig_.left.T_camera_from_rig.inverse() *
                      seen.stereo->estimate().position->point_in_left_mm};
    scope.radius_px = look_radius_px;
    scope.reach_px = look_radius_px;
    auto match = search_window(*look, rig_.left, camera, *seen.grey.picture, scope, search);
    const bool sure = match && !match->on_border && match->quality >= options_.found_quality &&
                      match->unrivalled >= options_.unrivalled_quality;
    return sure ? match : std::nullopt;
}

bool PanTiltServo::cut(const Frame& grey, const Rectangle& rectangle) {
    return tracker_->set_template({grey, {}}, rectangle) && tracker_->start() &&
           tracker_->process({grey, {}}).state == TrackState::tracking;
}

void PanTiltServo::check_by_look(const Seen& seen) {
    const bool tracking = follows() && tracker_->estimate().state == TrackState::tracking;
    if (by_hand_) {
        return;
    }
    if (!tracking) {
        pictures_until_check_ = std::min(pictures_until_check_, pictures_between_tries);
    }
    if (--pictures_until_check_ > 0) {
        return;
    }
    const auto match = found_by_look(seen);
    pictures_until_check_ = match ? pictures_between_checks : pictures_between_tries;
    if (!match) {
        return;
    }
    const bool agrees =
        tracking && tracker_->estimate().left_px &&
        (*tracker_->estimate().left_px - match->pixel).norm() < farthest_from_look_px;
    if (!agrees) {
        cut(seen.grey, about(match->pixel, match->size_px.cwiseMin(largest_cut_px)));
    }
}

void PanTiltServo::see(const Seen& seen) {
    if (!on_ || !tracker_ || !seen.grey.picture || !seen.grey.valid ||
        seen.grey.index == last_index_) {
        return;
    }
    if (seen.target != target_) {
        target_ = seen.target;
        if (!by_hand_) {
            forget();
        }
    }
    last_index_ = seen.grey.index;
    sure_ = false;
    if (!fits(*seen.grey.picture, *rig_.pan_tilt)) {
        return;
    }
    note_turn(seen.angles, seen.grey.time_ns, seen.magnified);
    if (follows()) {
        tracker_->process({seen.grey, {}});
    }
    if (seen.stereo != nullptr) {
        check_by_look(seen);
    }
    const TrackEstimate& estimate = tracker_->estimate();
    const bool tracking = follows() && estimate.state == TrackState::tracking &&
                          estimate.frame == seen.grey.index && estimate.left_px;
    if (!tracking) {
        return;
    }
    const Eigen::Vector2d pixel =
        pixel_at_calibrated_zoom(*rig_.pan_tilt, *estimate.left_px, seen.magnified);
    const auto wanted = angles_to_centre(rig_, seen.angles, pixel, range_mm(seen));
    if (!wanted) {
        return;
    }
    sure_ = true;
    aim_.see(*wanted, seen.grey.time_ns);
    if (seen.stereo == nullptr) {
        return;
    }
    const auto place = seen.stereo->expected_in_left_mm(seen.grey.time_ns);
    const auto by_stereo =
        angles_towards(rig_, place.value_or(seen.stereo->estimate().position->point_in_left_mm));
    apart_ = !aim_.compare(by_stereo, *wanted, seen.grey.time_ns);
    if (apart_ && !by_hand_) {
        forget();  // it crept onto something else
    }
}

HeadAngles PanTiltServo::corrected(const HeadAngles& by_stereo) const {
    if (!on_ || !aim_.correction()) {
        return by_stereo;
    }
    return {by_stereo.pan_rad + aim_.correction()->pan_rad,
            by_stereo.tilt_rad + aim_.correction()->tilt_rad};
}

std::optional<ServoAim::Alone> PanTiltServo::alone(std::int64_t time_ns) const {
    const bool fresh = time_ns - last_time_ns_ < stale_after_ns;
    return on_ && sure_ && fresh ? aim_.alone(time_ns) : std::nullopt;
}

ServoSnapshot PanTiltServo::state(bool steers_alone) const {
    ServoSnapshot state;
    state.on = on_;
    if (!on_ || !tracker_) {
        return state;
    }
    const TrackEstimate& estimate = tracker_->estimate();
    state.state = estimate.state;
    state.reason = estimate.reason;
    if (sure_) {
        state.pan_tilt_px = estimate.left_px;
    }
    state.quality = estimate.quality;
    state.template_size_px = estimate.template_size_px;
    state.correction = aim_.correction();
    state.alone = steers_alone;
    return state;
}

}  // namespace kambara
