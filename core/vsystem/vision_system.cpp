// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/vsystem/vision_system.h"

#include <chrono>
#include <condition_variable>
#include <deque>
#include <future>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "core/vsystem/calibration_views.h"
#include "core/vsystem/observer_list.h"
#include "core/vsystem/picture_fit.h"
#include "core/vsystem/pipeline.h"

namespace kambara {
namespace {

constexpr int patience_rounds = 100;  // of a source's own patience, 50 ms each
constexpr int silent_rounds = 20;     // likewise: a second
constexpr std::chrono::milliseconds head_interval{100};

struct WaitingCommand {
    Command command;
    std::promise<Result<Reply>> reply;
};

class VisionSystem final : public VsystemInterface {
  public:
    VisionSystem(VisionSystemParts parts, const VisionSystemOptions& options, Clock& clock)
        : rig_(parts.rig),
          pipeline_(
              parts.rig, parts.head, std::move(parts.vehicle), options, clock,
              [this](SnapshotPtr snapshot) { publish(std::move(snapshot)); },
              [this](const Event& event) { in_order(outgoing_events_, event, events_); }),
          source_(make_source(std::move(parts.grabbers), options, clock)),
          live_(!options.every_frame) {
        pipeline_.set_frames_total(source_->frames());
    }

    ~VisionSystem() override {
        thread_.request_stop();
        if (thread_.joinable()) {
            thread_.join();
        }
        for (auto& waiting : commands_) {
            waiting.reply.set_value(closing());
        }
    }

    // Waits for the first pair, then hands everything to the pipeline's thread.
    Result<Done> open(bool start_paused) {
        for (int round = 0; round < patience_rounds; ++round) {
            auto next = source_->next({});
            if (!next) {
                return next.error();
            }
            if (std::holds_alternative<EndOfSource>(*next)) {
                return Error{"The source has no pictures.", "Check that it is the right one."};
            }
            if (auto* images = std::get_if<ImageSet>(&*next)) {
                pipeline_.set_run(start_paused ? RunState::paused : RunState::running);
                pipeline_.process(std::move(*images), source_->frames_lost());
                thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
                return Done{};
            }
        }
        return Error{"No pictures have come from the cameras within five seconds.",
                     "Check that they are connected and that nothing else uses them."};
    }

    Result<Reply> execute(const Command& command) override {
        if (const auto* calibrate = std::get_if<Calibrate>(&command)) {
            return run_calibration(*calibrate);
        }
        if (std::this_thread::get_id() == thread_.get_id()) {
            return carry_out(command);  // from an observer, which is between two pairs already
        }
        std::future<Result<Reply>> reply;
        {
            std::lock_guard lock(mutex_);
            commands_.push_back({command, {}});
            reply = commands_.back().reply.get_future();
        }
        work_.notify_all();
        return reply.get();
    }

    SnapshotPtr latest() const override {
        std::lock_guard lock(mutex_);
        return latest_;
    }

    Result<ImageSet> images() const override {
        const auto snapshot = latest();
        if (!snapshot || !snapshot->pictures.stereo.left.picture) {
            return Error{"There are no pictures yet.", "Wait for the source to deliver."};
        }
        return snapshot->pictures;
    }

    Rig rig() const override {
        std::lock_guard lock(mutex_);
        return rig_;
    }

    std::unique_ptr<Observation> observe(SnapshotObserver observer) override {
        return snapshots_.add(std::move(observer));
    }
    std::unique_ptr<Observation> observe_events(EventObserver observer) override {
        return events_.add(std::move(observer));
    }

  private:
    static std::unique_ptr<FrameSource> make_source(Grabbers grabbers,
                                                    const VisionSystemOptions& options,
                                                    Clock& clock) {
        if (!options.every_frame) {
            return make_live_source(std::move(grabbers), clock);
        }
        auto source = make_sequential_source(std::move(grabbers));
        return options.in_real_time ? make_paced_source(std::move(source), clock)
                                    : std::move(source);
    }

    static Error closing() { return {"The vision system is closing.", "Open it again to go on."}; }

    void publish(SnapshotPtr snapshot) {
        {
            std::lock_guard lock(mutex_);
            latest_ = snapshot;
        }
        in_order(outgoing_snapshots_, std::move(snapshot), snapshots_);
    }

    // An observer may execute commands that publish in turn: what they publish waits until everyone
    // has seen what came before it.
    template <class Item>
    void in_order(std::deque<Item>& outgoing, Item item, ObserverList<Item>& observers) {
        outgoing.push_back(std::move(item));
        if (outgoing.size() > 1) {
            return;
        }
        while (!outgoing.empty()) {
            observers.notify(outgoing.front());
            outgoing.pop_front();
        }
    }

    bool flowing() const { return pipeline_.run() == RunState::running || steps_ > 0; }

    void run(const std::stop_token& stop) {
        while (!stop.stop_requested()) {
            std::deque<WaitingCommand> commands;
            {
                std::unique_lock lock(mutex_);
                wait_for_work(lock, stop);
                commands.swap(commands_);
            }
            for (auto& waiting : commands) {
                waiting.reply.set_value(carry_out(waiting.command));
            }
            if (stop.stop_requested()) {
                return;
            }
            if (flowing()) {
                take_next(stop);
            } else {
                pipeline_.watch_head();
            }
        }
    }

    // The head goes on turning, or falls silent, whether pictures come or not.
    void wait_for_work(std::unique_lock<std::mutex>& lock, const std::stop_token& stop) {
        const auto come = [this] { return !commands_.empty(); };
        if (flowing()) {
            return;
        }
        if (pipeline_.has_head()) {
            work_.wait_for(lock, stop, head_interval, come);
        } else {
            work_.wait(lock, stop, come);
        }
    }

    void take_next(const std::stop_token& stop) {
        auto next = source_->next(stop);
        if (stop.stop_requested()) {
            return;
        }
        if (const auto fault = source_->take_fault()) {
            in_order(outgoing_events_, Event{Event::Kind::fault, -1, 0, fault->text()}, events_);
        }
        if (next && std::holds_alternative<NothingYet>(*next)) {
            if (live_ && ++empty_rounds_ == silent_rounds) {
                pipeline_.fell_silent();
            }
            if (pipeline_.silent()) {
                pipeline_.watch_head();
            }
            return;
        }
        empty_rounds_ = 0;
        if (!next) {
            steps_ = 0;
            pipeline_.set_run(RunState::failed, next.error());
        } else if (std::holds_alternative<EndOfSource>(*next)) {
            steps_ = 0;
            pipeline_.set_run(RunState::ended);
        } else {
            steps_ = steps_ > 0 ? steps_ - 1 : 0;
            pipeline_.process(std::move(std::get<ImageSet>(*next)), source_->frames_lost());
        }
    }

    Result<Reply> flow(const Flow& flow) {
        if (pipeline_.run() == RunState::ended || pipeline_.run() == RunState::failed) {
            return Error{"The source is over: there are no more pictures to take.",
                         "Go back to an earlier frame, or open it again."};
        }
        if (flow.kind == Flow::Kind::step) {
            ++steps_;
        } else {
            pipeline_.set_run(flow.kind == Flow::Kind::run ? RunState::running : RunState::paused);
        }
        return Reply(Done{});
    }

    Result<Reply> seek(const Seek& command) {
        if (pipeline_.run() == RunState::failed) {
            return Error{"The source has failed: it can't be wound.", "Open it again."};
        }
        if (const auto done = source_->seek(command.frame); !done) {
            return done.error();
        }
        pipeline_.wound();
        pipeline_.set_run(RunState::paused);
        steps_ = 1;
        return Reply(Done{});
    }

    // On the pipeline's thread.
    Result<Reply> carry_out(const Command& command) {
        struct Visitor {
            VisionSystem& self;
            Result<Reply> operator()(const SelectTemplate& c) { return self.pipeline_.select(c); }
            Result<Reply> operator()(const StartTracking& c) { return self.pipeline_.start(c); }
            Result<Reply> operator()(const StopTracking& c) { return self.pipeline_.stop(c); }
            Result<Reply> operator()(const UpdateTemplate& c) {
                return self.pipeline_.update_template(c);
            }
            Result<Reply> operator()(const ClearTemplate& c) { return self.pipeline_.clear(c); }
            Result<Reply> operator()(const SteerTo& c) { return self.pipeline_.steer_to(c); }
            Result<Reply> operator()(const MoveHead& c) { return self.pipeline_.move_head(c); }
            Result<Reply> operator()(const HaltHead&) { return self.pipeline_.halt_head(); }
            Result<Reply> operator()(const DriveHead& c) { return self.pipeline_.drive_head(c); }
            Result<Reply> operator()(const CentreHead& c) { return self.pipeline_.centre_head(c); }
            Result<Reply> operator()(const HomeHead& c) { return self.pipeline_.turn_head(c); }
            Result<Reply> operator()(const ResetHead& c) { return self.pipeline_.turn_head(c); }
            Result<Reply> operator()(const RecallPreset& c) { return self.pipeline_.turn_head(c); }
            Result<Reply> operator()(const ZoomHead& c) { return self.pipeline_.set_head(c); }
            Result<Reply> operator()(const FocusHead& c) { return self.pipeline_.set_head(c); }
            Result<Reply> operator()(const AutofocusHead& c) { return self.pipeline_.set_head(c); }
            Result<Reply> operator()(const KeepPreset& c) { return self.pipeline_.set_head(c); }
            Result<Reply> operator()(const Seek& c) { return self.seek(c); }
            Result<Reply> operator()(const HoldFrame& c) { return self.pipeline_.hold(c); }
            Result<Reply> operator()(const SteerHead& c) { return self.pipeline_.steer_head(c); }
            Result<Reply> operator()(const ServoHead& c) { return self.pipeline_.servo_head(c); }
            Result<Reply> operator()(const SelectInPanTilt& c) {
                return self.pipeline_.select_in_pan_tilt(c);
            }
            Result<Reply> operator()(const CaptureView&) {
                return self.views_.capture(self.pipeline_.images());
            }
            Result<Reply> operator()(const Calibrate&) {
                self.take_over();
                return Reply(Done{});
            }
            Result<Reply> operator()(const Flow& c) { return self.flow(c); }
            Result<Reply> operator()(const TellVehicleMotion& c) {
                return self.pipeline_.tell_vehicle_motion(c);
            }
        };
        return std::visit(Visitor{*this}, command);
    }

    // The computation runs on the caller's thread, so that the pictures keep flowing; only its
    // result is handed to the pipeline.
    Result<Reply> run_calibration(const Calibrate& command) {
        auto outcome = views_.calibrate(command, rig());
        if (!outcome || outcome->second.rig_text.empty()) {
            return outcome ? Result<Reply>(Reply(outcome->second)) : Result<Reply>(outcome.error());
        }
        {
            std::lock_guard lock(mutex_);
            calibrated_ = outcome->first;
        }
        if (std::this_thread::get_id() == thread_.get_id()) {
            take_over();
            return Reply(outcome->second);
        }
        std::future<Result<Reply>> taken;
        {
            std::lock_guard lock(mutex_);
            commands_.push_back({command, {}});
            taken = commands_.back().reply.get_future();
        }
        work_.notify_all();
        if (const auto reply = taken.get(); !reply) {
            return reply.error();
        }
        return Reply(outcome->second);
    }

    void take_over() {
        std::optional<Rig> rig;
        {
            std::lock_guard lock(mutex_);
            rig = std::exchange(calibrated_, std::nullopt);
            if (rig) {
                rig_ = *rig;
            }
        }
        if (rig) {
            pipeline_.use_rig(*rig);
        }
    }

    ObserverList<SnapshotPtr> snapshots_;
    ObserverList<Event> events_;
    std::deque<SnapshotPtr> outgoing_snapshots_;
    std::deque<Event> outgoing_events_;
    mutable std::mutex mutex_;
    std::condition_variable_any work_;
    std::deque<WaitingCommand> commands_;
    SnapshotPtr latest_ = std::make_shared<const Snapshot>();
    Rig rig_;
    std::optional<Rig> calibrated_;  // waiting to be taken over
    CalibrationViews views_;
    // From here on, the pipeline's thread alone.
    Pipeline pipeline_;
    std::unique_ptr<FrameSource> source_;
    int steps_ = 0;
    const bool live_;
    int empty_rounds_ = 0;
    std::jthread thread_;
};

}  // namespace

Result<std::unique_ptr<VsystemInterface>> open_vision_system(VisionSystemParts parts,
                                                             const VisionSystemOptions& options,
                                                             Clock& clock) {
    if (!parts.grabbers.left) {
        return Error{"There is no left camera.", "Name a source for the left pictures."};
    }
    auto rig = fitted_to_pictures(parts.rig, parts.grabbers);
    if (!rig) {
        return rig.error();
    }
    parts.rig = std::move(*rig);
    if (options.tracker.position.method != PositionMethod::reprojection) {
        if (const auto suits = check_position_method(parts.rig, options.tracker.position.method);
            !suits) {
            return suits.error();
        }
    }
    auto system = std::make_unique<VisionSystem>(std::move(parts), options, clock);
    if (const auto opened = system->open(options.start_paused); !opened) {
        return opened.error();
    }
    return std::unique_ptr<VsystemInterface>(std::move(system));
}

}  // namespace kambara
