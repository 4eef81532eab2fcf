// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/vsystem/pipeline.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <utility>

#include "core/pointing/aim.h"
#include "core/pointing/pan_tilt_view.h"

namespace kambara {
namespace {

constexpr std::size_t pairs_remembered = 30;
constexpr std::int64_t tell_again_ns = 500'000'000;
constexpr std::int64_t second_ns = 1'000'000'000;
constexpr double shortest_rate_span_s = 0.2;  // less says nothing about a rate

// In grey, and filtered over time where that is asked for.
Frame prepared(Frame frame, std::optional<TemporalFilter>& filter) {
    frame.picture = grey_from(frame.picture);
    if (filter && frame.picture) {
        frame.picture = std::make_shared<const Image>(filter->filter(*frame.picture));
    }
    return frame;
}

}  // namespace

Pipeline::Pipeline(Rig rig, const std::shared_ptr<PanTiltCamera>& head,
                   std::shared_ptr<VehicleFeed> vehicle, const VisionSystemOptions& options,
                   const Clock& clock, Publish publish, Announce announce)
    : rig_(std::move(rig)),
      options_(options),
      clock_(clock),
      publish_(std::move(publish)),
      announce_(std::move(announce)),
      targets_(rig_, options.tracker, options.threads),
      watch_(rig_),
      head_(head ? std::make_unique<HeadWorker>(head,
                                                options.every_frame
                                                    ? HeadWorker::Threading::inline_calls
                                                    : HeadWorker::Threading::own_thread,
                                                clock)
                 : nullptr),
      vehicle_(std::move(vehicle)),
      steering_(options.steering, head ? head->limits() : HeadLimits{}),
      servo_(rig_, options.tracker) {
    if (options.temporal) {
        left_filter_.emplace(*options.temporal);
        right_filter_.emplace(*options.temporal);
    }
    tell_backlash();
}

void Pipeline::process(ImageSet images, std::uint64_t frames_lost) {
    images_ = std::move(images);
    frames_lost_ = frames_lost;
    if (silent_) {
        silent_ = false;
        announce(Event::Kind::note, "Pictures are coming again.");
    }
    remembered_.push_back({prepared(images_.stereo.left, left_filter_),
                           prepared(images_.stereo.right, right_filter_)});
    if (remembered_.size() > pairs_remembered) {
        remembered_.pop_front();
    }
    const TargetStates before = targets_.states();
    const std::int64_t started_ns = clock_.now_ns();
    if (vehicle_) {
        for (const VehicleMotion& motion : vehicle_->take(images_.stereo.left.time_ns)) {
            const auto taken = take_vehicle_motion(motion);
            if (!taken && !vehicle_refused_) {
                announce(Event::Kind::warning, taken.error().text());
            }
            vehicle_refused_ = !taken;
        }
    }
    targets_.process(remembered_.back());
    look_through_head();
    watch_rig();
    steer();
    const std::int64_t now_ns = clock_.now_ns();
    processing_ms_ = static_cast<double>(now_ns - started_ns) * 1e-6;
    note_changes(before);
    handled_ns_.push_back(now_ns);
    while (now_ns - handled_ns_.front() > second_ns) {
        handled_ns_.pop_front();
    }
    latency_ms_ = images_.arrived_ns > 0 ? static_cast<double>(now_ns - images_.arrived_ns) * 1e-6
                                         : processing_ms_;
    publish();
}

void Pipeline::note_changes(const TargetStates& before) {
    const TargetStates after = targets_.states();
    std::map<int, TrackState> all = before.of;
    all.insert(after.of.begin(), after.of.end());
    const auto state_in = [](const TargetStates& states, int id) {
        const auto found = states.of.find(id);
        return found == states.of.end() ? TrackState::idle : found->second;
    };
    for (const auto& [id, any] : all) {
        const TrackState was = state_in(before, id);
        const TrackState is = state_in(after, id);
        if (was == is) {
            continue;
        }
        const FollowedTarget* target = targets_.find(id);
        const std::string reason = target != nullptr ? target->tracker.estimate().reason : "";
        const bool worse = is == TrackState::doubtful || is == TrackState::lost;
        announce(worse ? Event::Kind::warning : Event::Kind::note,
                 (all.size() > 1 ? "Target " + std::to_string(id) + ": " : "") + to_string(was) +
                     " -> " + to_string(is) + (reason.empty() ? "" : ": " + reason));
    }
    if (before.steered && after.steered && before.steered != after.steered) {
        announce(Event::Kind::note,
                 "The head is steered to target " + std::to_string(*after.steered) + " now.");
    }
}

// Every target that is followed for sure tells whether the cameras still stand as calibrated.
void Pipeline::watch_rig() {
    for (const FollowedTarget& target : targets_.all()) {
        const TrackEstimate& estimate = target.tracker.estimate();
        if (estimate.frame == images_.stereo.left.index && estimate.state == TrackState::tracking &&
            estimate.position) {
            watch_.add(images_.stereo.left.time_ns, estimate.position->epipolar);
        }
    }
    // While nothing is judged, the last verdict stands.
    if (watch_.state() && watch_.state()->moved != rig_moved_told_) {
        rig_moved_told_ = watch_.state()->moved;
        if (rig_moved_told_) {
            announce(Event::Kind::warning, rig_moved_text(*watch_.state()));
        } else {
            announce(Event::Kind::note, rig_restored_text(*watch_.state()));
        }
    }
}

void Pipeline::announce(Event::Kind kind, std::string text) {
    announce_({kind, images_.stereo.left.index, images_.stereo.left.time_ns, std::move(text)});
}

void Pipeline::fell_silent() {
    silent_ = true;
    handled_ns_.clear();
    announce(Event::Kind::fault,
             "No pictures have come for a second. Check that the cameras are connected.");
    publish();
}

double Pipeline::rate_hz() const {
    if (handled_ns_.size() < 2) {
        return 0.0;
    }
    const double span_s = static_cast<double>(handled_ns_.back() - handled_ns_.front()) * 1e-9;
    return span_s > shortest_rate_span_s ? static_cast<double>(handled_ns_.size() - 1) / span_s
                                         : 0.0;
}

void Pipeline::publish() {
    auto snapshot = std::make_shared<Snapshot>();
    snapshot->frame = images_.stereo.left.index;
    snapshot->time_ns = images_.stereo.left.time_ns;
    snapshot->run = run_;
    snapshot->failure = failure_;
    for (const FollowedTarget& target : targets_.all()) {
        snapshot->tracks.push_back({target.id, target.tracker.estimate()});
        if (target.tracker.estimate().frame != snapshot->frame || silent_) {
            snapshot->tracks.back().estimate.forget_place();
        }
    }
    snapshot->steered_target = targets_.states().steered;
    if (head_) {
        announce_head();
        head_told_ = head_now();
        snapshot->head = head_told_;
    }
    if (servo_.on()) {
        snapshot->servo = servo_.state(steers_alone_);
    }
    snapshot->rig_watch = watch_.state();
    snapshot->rate_hz = rate_hz();
    snapshot->processing_ms = processing_ms_;
    snapshot->latency_ms = latency_ms_;
    snapshot->frames_lost = frames_lost_;
    snapshot->frames_total = frames_total_;
    snapshot->pictures = images_;
    publish_(std::move(snapshot));
}

void Pipeline::set_run(RunState run, std::optional<Error> failure) {
    if (run == run_) {
        return;
    }
    run_ = run;
    failure_ = std::move(failure);
    if (run == RunState::ended) {
        announce(Event::Kind::note, "The source has come to its end.");
    } else if (run == RunState::failed && failure_) {
        announce(Event::Kind::fault, failure_->text());
    }
    if (images_.stereo.left.picture) {
        publish();
    }
}

Result<Reply> Pipeline::select(const SelectTemplate& command) {
    const std::int64_t wanted = command.frame.value_or(images_.stereo.left.index);
    const StereoFrame* seen = remembered(wanted);
    if (seen == nullptr) {
        return Error{"Frame " + std::to_string(wanted) + " is no longer remembered.",
                     "Choose the template in a newer picture."};
    }
    const TargetStates before = targets_.states();
    return finish(targets_.set_template(command.target, *seen, command.rectangle), before);
}

Result<Reply> Pipeline::start(const StartTracking& command) {
    if (remembered_.empty()) {
        return Error{"There is no picture to start from.", "Wait for the next one."};
    }
    const TargetStates before = targets_.states();
    const auto started = targets_.start(command.target, remembered_);
    if (started) {
        steer();
    }
    return finish(started, before);
}

// How a command to the targets went: what it changed is told and shown.
Result<Reply> Pipeline::finish(const Result<Done>& done, const TargetStates& before) {
    if (!done) {
        return done.error();
    }
    note_changes(before);
    publish();
    return Reply(Done{});
}

const StereoFrame* Pipeline::remembered(std::int64_t frame) const {
    if (held_ && held_->left.index == frame) {
        return &*held_;
    }
    const auto seen = std::find_if(remembered_.begin(), remembered_.end(),
                                   [&](const auto& pair) { return pair.left.index == frame; });
    return seen == remembered_.end() ? nullptr : &*seen;
}

Result<Reply> Pipeline::hold(const HoldFrame& command) {
    const StereoFrame* seen = remembered(command.frame);
    if (seen == nullptr) {
        return Error{"Frame " + std::to_string(command.frame) + " is no longer remembered.",
                     "Hold a newer picture."};
    }
    held_ = StereoFrame(*seen);
    return Reply(Done{});
}

void Pipeline::wound() {
    const TargetStates before = targets_.states();
    targets_.wound();
    servo_.wound();
    watch_.reset();
    remembered_.clear();
    for (auto* filter : {&left_filter_, &right_filter_}) {
        if (*filter) {
            (*filter)->reset();
        }
    }
    handled_ns_.clear();
    note_changes(before);
}

Result<Reply> Pipeline::stop(const StopTracking& command) {
    const TargetStates before = targets_.states();
    return finish(targets_.stop(command.target), before);
}

Result<Reply> Pipeline::update_template(const UpdateTemplate& command) {
    if (const auto updated = targets_.update_template(command.target); !updated) {
        return updated.error();
    }
    const TargetStates states = targets_.states();
    const int id = command.target.value_or(states.steered.value_or(1));
    announce(Event::Kind::note,
             (states.of.size() > 1 ? "Target " + std::to_string(id) + ": " : "") +
                 std::string("The template was updated by command."));
    publish();
    return Reply(Done{});
}

Result<Reply> Pipeline::clear(const ClearTemplate& command) {
    const TargetStates before = targets_.states();
    return finish(targets_.clear(command.target), before);
}

Result<Reply> Pipeline::steer_to(const SteerTo& command) {
    const TargetStates before = targets_.states();
    const auto done = targets_.steer_to(command.target);
    if (done) {
        steer();
    }
    return finish(done, before);
}

// Of the target that the head is to look at; null while it is not seen for sure.
const StereoTracker* Pipeline::steered_tracker() const {
    const FollowedTarget* target = targets_.steered();
    const bool seen_now = target != nullptr && target->tracker.started() && !silent_ &&
                          target->tracker.estimate().frame == images_.stereo.left.index;
    const bool sure = seen_now && target->tracker.estimate().state == TrackState::tracking &&
                      target->tracker.estimate().position;
    return sure ? &target->tracker : nullptr;
}

// Led from the picture's exposure to the moment when the head is there. In step with a recording,
// the head is told at the picture's time.
std::optional<HeadAim> Pipeline::aim_at(const StereoTracker& tracker) const {
    const std::int64_t now_ns = clock_.now_ns();
    const bool leads =
        options_.steering.leads && tracker.estimate().motion && !options_.every_frame;
    if (!leads) {
        const auto& position = tracker.estimate().position;
        return HeadAim{angles_towards(rig_, position->point_in_left_mm), {}, now_ns, now_ns};
    }
    const std::int64_t pictured_ns =
        images_.stereo.left.time_ns + static_cast<std::int64_t>(std::llround(age_s(now_ns) * 1e9));
    return led_aim(
        rig_, [&](std::int64_t time_ns) { return tracker.expected_in_left_mm(time_ns); },
        pictured_ns, now_ns, head_->lag_s());
}

double Pipeline::age_s(std::int64_t now_ns) const {
    const double waited_s =
        images_.arrived_ns > 0 ? static_cast<double>(now_ns - images_.arrived_ns) * 1e-9 : 0.0;
    return options_.steering.camera_latency_s + waited_s;
}

// By the pan-tilt camera's own picture, led likewise.
std::optional<HeadAim> Pipeline::aim_alone() const {
    const std::int64_t now_ns = clock_.now_ns();
    const bool leads = options_.steering.leads && !options_.every_frame;
    const double ahead_s = leads ? age_s(now_ns) + head_->lag_s() : 0.0;
    const auto seen = servo_.alone(images_.stereo.left.time_ns +
                                   static_cast<std::int64_t>(std::llround(ahead_s * 1e9)));
    if (!seen) {
        return std::nullopt;
    }
    HeadAim aim{seen->angles, {}, now_ns, now_ns};
    if (leads) {
        aim.rate_rad_s = seen->rate_rad_s;
        aim.time_ns += static_cast<std::int64_t>(std::llround(head_->lag_s() * 1e9));
    }
    return aim;
}

std::optional<HeadAim> Pipeline::wanted_aim(const StereoTracker* target) {
    steers_alone_ = servo_.on() && (target == nullptr || servo_.apart());
    if (steers_alone_) {
        auto aim = aim_alone();
        steers_alone_ = aim.has_value();
        return aim;
    }
    auto aim = target != nullptr ? aim_at(*target) : std::nullopt;
    if (aim) {
        aim->angles = servo_.corrected(aim->angles);
    }
    return aim;
}

// Where the head looked when its camera's newest picture was exposed.
std::optional<HeadAngles> Pipeline::angles_of_pan_tilt_picture() {
    const std::int64_t after_left_ns = images_.pan_tilt.time_ns - images_.stereo.left.time_ns;
    const bool one_clock = std::abs(after_left_ns) < second_ns;
    const auto late_ns =
        static_cast<std::int64_t>(std::llround(options_.steering.camera_latency_s * 1e9));
    return head_->axes_when(images_.arrived_ns + (one_clock ? after_left_ns : 0) - late_ns);
}

// Over the zoom of its calibration, which is taken to be the widest. By the lens's own views, both
// in air: the rig's lens may be a wet one.
double Pipeline::magnified_now() const {
    return head_->magnification();
}

void Pipeline::look_through_head() {
    if (!servo_.on() || !head_ || !images_.pan_tilt.picture) {
        return;
    }
    const auto angles = angles_of_pan_tilt_picture();
    if (!angles) {
        return;
    }
    const bool is_new = pan_tilt_grey_.index != images_.pan_tilt.index || !pan_tilt_grey_.picture;
    if (is_new) {
        pan_tilt_grey_ = images_.pan_tilt;
        pan_tilt_grey_.picture = grey_from(pan_tilt_grey_.picture);
    }
    const FollowedTarget* steered = targets_.steered();
    const bool followed = steered != nullptr && steered->tracker.started();
    servo_.see({pan_tilt_grey_, *angles, steered_tracker(),
                followed ? std::optional(steered->id) : std::nullopt, magnified_now()});
}

void Pipeline::steer() {
    if (!head_ || !rig_.pan_tilt) {
        steering_.nothing_wanted();
        return;
    }
    auto aim = wanted_aim(steered_tracker());
    if (!aim) {
        steering_.nothing_wanted();
        return;
    }
    // A command that the head did not take is given again.
    const auto last = head_->move_failed() ? std::nullopt : aimed_;
    if (const auto command =
            steering_.command_for(aim->angles, last, images_.stereo.left.time_ns)) {
        aim->angles = head_->encoders_for(*command);
        head_->follow(*aim);
        aimed_ = command;
        commanded_ = aim->angles;
        followed_ns_ = aim->computed_ns;
    } else if (!options_.every_frame && steering_.automatic() && commanded_ &&
               aim->computed_ns - followed_ns_ > tell_again_ns) {
        // An aim that became old on its way was dropped by the head's driver; one that reached it
        // on its way may have turned it round, and its backlash with it.
        if (aimed_ && head_->astray(*aimed_)) {
            commanded_ = head_->encoders_for(*aimed_);
        }
        head_->follow({*commanded_, {}, aim->computed_ns, aim->computed_ns});
        followed_ns_ = aim->computed_ns;
    }
}

Result<Reply> Pipeline::tell_vehicle_motion(const TellVehicleMotion& command) {
    if (const auto taken = take_vehicle_motion(command.motion); !taken) {
        return taken.error();
    }
    return Reply(Done{});
}

// A stamp far ahead would make all later motion look old.
Result<Done> Pipeline::take_vehicle_motion(const VehicleMotion& motion) {
    const std::int64_t ahead_ns = motion.time_ns - images_.stereo.left.time_ns;
    if (images_.stereo.left.picture && ahead_ns > second_ns) {
        return Error{"The vehicle's motion is stamped " +
                         std::to_string(static_cast<double>(ahead_ns) * 1e-9) +
                         " s later than the newest picture.",
                     "Set the clocks of both alike."};
    }
    if (!targets_.add_vehicle_motion(motion)) {
        return Error{"The vehicle's motion, or its deviation, is no number.",
                     "Check what sends it."};
    }
    return Done{};
}

void Pipeline::use_rig(const Rig& rig) {
    rig_ = rig;
    tell_backlash();
    targets_.use_rig(rig_);
    servo_.use_rig(rig_);
    watch_ = RigWatch(rig_);
    rig_moved_told_ = false;
    announce(Event::Kind::note, "A new calibration is in use. Choose the template again.");
    publish();
}

}  // namespace kambara
