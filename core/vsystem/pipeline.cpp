// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/vsystem/pipeline.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "core/pointing/aim.h"

namespace kambara {
namespace {

constexpr std::size_t pairs_remembered = 30;
constexpr std::int64_t second_ns = 1'000'000'000;
constexpr double shortest_rate_span_s = 0.2;  // less says nothing about a rate
constexpr int only_track_id = 1;

// In grey, and filtered over time where that is asked for.
Frame prepared(Frame frame, std::optional<TemporalFilter>& filter) {
    frame.picture = grey_from(frame.picture);
    if (filter && frame.picture) {
        frame.picture = std::make_shared<const Image>(filter->filter(*frame.picture));
    }
    return frame;
}

}  // namespace

Pipeline::Pipeline(Rig rig, std::shared_ptr<PanTiltCamera> head, const VisionSystemOptions& options,
                   const Clock& clock, Publish publish, Announce announce)
    : rig_(std::move(rig)),
      options_(options),
      clock_(clock),
      publish_(std::move(publish)),
      announce_(std::move(announce)),
      tracker_(rig_, options.tracker),
      head_(head ? std::make_unique<HeadWorker>(head, options.every_frame
                                                          ? HeadWorker::Threading::inline_calls
                                                          : HeadWorker::Threading::own_thread)
                 : nullptr),
      steering_(options.steering, head ? head->limits() : HeadLimits{}) {
    if (options.temporal) {
        left_filter_.emplace(*options.temporal);
        right_filter_.emplace(*options.temporal);
    }
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
    track(remembered_.back(), tracker_.estimate().state);
    const std::int64_t now_ns = clock_.now_ns();
    handled_ns_.push_back(now_ns);
    while (now_ns - handled_ns_.front() > second_ns) {
        handled_ns_.pop_front();
    }
    latency_ms_ = images_.arrived_ns > 0 ? static_cast<double>(now_ns - images_.arrived_ns) * 1e-6
                                         : processing_ms_;
    publish();
}

void Pipeline::track(const StereoFrame& frame, TrackState before) {
    const std::int64_t started_ns = clock_.now_ns();
    const TrackEstimate estimate = tracker_.process(frame);
    const bool followed = tracker_.started();
    steer(followed ? estimate.position : std::nullopt);
    processing_ms_ = static_cast<double>(clock_.now_ns() - started_ns) * 1e-6;
    note_state_change(before);
}

void Pipeline::note_state_change(TrackState before) {
    const TrackEstimate& estimate = tracker_.estimate();
    if (estimate.state == before) {
        return;
    }
    const bool worse = estimate.state == TrackState::doubtful || estimate.state == TrackState::lost;
    announce(worse ? Event::Kind::warning : Event::Kind::note,
             to_string(before) + " -> " + to_string(estimate.state) +
                 (estimate.reason.empty() ? "" : ": " + estimate.reason));
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
    if (tracker_.estimate().state != TrackState::idle) {
        snapshot->tracks.push_back({only_track_id, tracker_.estimate()});
        if (tracker_.estimate().frame != snapshot->frame || silent_) {
            snapshot->tracks.back().estimate.forget_place();
        }
    }
    if (head_) {
        const auto reading = head_->reading();
        snapshot->head =
            HeadSnapshot{reading.status.angles, commanded_,           reading.status.moving,
                         steering_.automatic(), steering_.at_limit(), reading.fault};
    }
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
    const TrackState before = tracker_.estimate().state;
    if (const auto chosen = tracker_.set_template(*seen, command.rectangle); !chosen) {
        return chosen.error();
    }
    template_frame_ = wanted;
    note_state_change(before);
    publish();
    return Reply(Done{});
}

Result<Reply> Pipeline::start() {
    if (remembered_.empty()) {
        return Error{"There is no picture to start from.", "Wait for the next one."};
    }
    const TrackState before = tracker_.estimate().state;
    if (const auto started = tracker_.start(); !started) {
        return started.error();
    }
    // From the pair in which the template was chosen to the one at hand, as far as they are still
    // remembered: the target has moved on while the operator looked.
    const std::int64_t since = template_frame_.value_or(images_.stereo.left.index);
    const bool gapless = !remembered_.empty() && remembered_.front().left.index <= since + 1;
    if (template_frame_ && !gapless) {
        tracker_.forget_motion();  // it may be anywhere by now
    }
    for (const StereoFrame& pair : remembered_) {
        if (gapless && pair.left.index > since && pair.left.index < images_.stereo.left.index) {
            tracker_.process(pair);
        }
    }
    template_frame_.reset();
    track(remembered_.back(), before);
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
    const TrackState before = tracker_.estimate().state;
    tracker_.stop();
    tracker_.forget_motion();
    remembered_.clear();
    for (auto* filter : {&left_filter_, &right_filter_}) {
        if (*filter) {
            (*filter)->reset();
        }
    }
    handled_ns_.clear();
    template_frame_.reset();
    note_state_change(before);
}

Result<Reply> Pipeline::stop() {
    const TrackState before = tracker_.estimate().state;
    tracker_.stop();
    note_state_change(before);
    publish();
    return Reply(Done{});
}

Result<Reply> Pipeline::update_template() {
    if (const auto updated = tracker_.update_template(); !updated) {
        return updated.error();
    }
    announce(Event::Kind::note, "The template was updated by command.");
    publish();
    return Reply(Done{});
}

Result<Reply> Pipeline::clear() {
    const TrackState before = tracker_.estimate().state;
    tracker_.clear();
    note_state_change(before);
    publish();
    return Reply(Done{});
}

void Pipeline::steer(const std::optional<Position>& position) {
    if (!position || !rig_.pan_tilt) {
        steering_.nothing_wanted();
    }
    if (!head_ || !position || !rig_.pan_tilt) {
        return;
    }
    // A command that the head did not take is given again.
    const auto last = head_->move_failed() ? std::nullopt : commanded_;
    const HeadAngles wanted = angles_towards(rig_, position->point_in_left_mm);
    if (const auto command = steering_.command_for(wanted, last, images_.stereo.left.time_ns)) {
        head_->command(*command);
        commanded_ = command;
    }
}

Result<Reply> Pipeline::move_head(const MoveHead& command) {
    if (!head_) {
        return Error{"There is no pan-tilt head.", "Connect one, or name it when starting."};
    }
    const HeadLimits limits = head_->limits();
    if (within_limits(command.angles, limits) != command.angles) {
        return Error{"The head can't look there: it reaches " +
                         std::to_string(deg_from_rad(limits.pan_rad)) +
                         " degrees to the sides and " +
                         std::to_string(deg_from_rad(limits.tilt_rad)) + " up and down.",
                     "Give angles within these limits."};
    }
    steering_.set_automatic(false);
    steering_.nothing_wanted();
    head_->command(command.angles);
    commanded_ = command.angles;
    publish();
    return Reply(Done{});
}

Result<Reply> Pipeline::halt_head() {
    if (!head_) {
        return Error{"There is no pan-tilt head.", "Connect one, or name it when starting."};
    }
    steering_.set_automatic(false);
    head_->halt();
    commanded_.reset();
    publish();
    return Reply(Done{});
}

Result<Reply> Pipeline::steer_head(const SteerHead& command) {
    if (!head_) {
        return Error{"There is no pan-tilt head.", "Connect one, or name it when starting."};
    }
    if (command.automatic && !rig_.pan_tilt) {
        return Error{"The rig file does not say where the pan-tilt camera is.",
                     "Calibrate it with the others, then hand over the steering."};
    }
    steering_.set_automatic(command.automatic);
    publish();
    return Reply(Done{});
}

void Pipeline::use_rig(const Rig& rig) {
    rig_ = rig;
    tracker_ = StereoTracker(rig_, options_.tracker);
    announce(Event::Kind::note, "A new calibration is in use. Choose the template again.");
    publish();
}

}  // namespace kambara
