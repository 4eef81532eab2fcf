// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/clock.h"
#include "core/stereo/rig_watch.h"
#include "core/vsystem/head_worker.h"
#include "core/vsystem/pan_tilt_servo.h"
#include "core/vsystem/target_set.h"
#include "core/vsystem/vision_system.h"

namespace kambara {

/// The state that the pipeline's thread owns: what is tracked, where the head goes, what was seen
/// lately. Knows nothing of threads, queues and observers; VisionSystem runs it.
class Pipeline {
  public:
    using Publish = std::function<void(SnapshotPtr)>;
    using Announce = std::function<void(Event)>;

    Pipeline(Rig rig, const std::shared_ptr<PanTiltCamera>& head,
             std::shared_ptr<VehicleFeed> vehicle, const VisionSystemOptions& options,
             const Clock& clock, Publish publish, Announce announce);

    /// Tracks, positions, steers and publishes a snapshot.
    void process(ImageSet images, std::uint64_t frames_lost);

    Result<Reply> select(const SelectTemplate& command);
    Result<Reply> start(const StartTracking& command);
    Result<Reply> stop(const StopTracking& command);
    Result<Reply> update_template(const UpdateTemplate& command);
    Result<Reply> clear(const ClearTemplate& command);
    Result<Reply> steer_to(const SteerTo& command);
    Result<Reply> move_head(const MoveHead& command);
    Result<Reply> halt_head();
    Result<Reply> drive_head(const DriveHead& command);
    Result<Reply> centre_head(const CentreHead& command);
    void tell_backlash();
    Result<Reply> turn_head(const HeadWorker::Turn& command);
    Result<Reply> set_head(const HeadWorker::Setting& command);
    Result<Reply> hold(const HoldFrame& command);
    Result<Reply> steer_head(const SteerHead& command);
    Result<Reply> servo_head(const ServoHead& command);
    Result<Reply> select_in_pan_tilt(const SelectInPanTilt& command);
    Result<Reply> tell_vehicle_motion(const TellVehicleMotion& command);
    /// Takes a new calibration: forgets the template, which belongs to the old one.
    void use_rig(const Rig& rig);
    /// The source goes on with another frame: nothing seen before it says where the target is.
    void wound();
    /// The cameras deliver nothing any more: says so, and gives no position until they do.
    void fell_silent();
    bool silent() const { return silent_; }
    bool has_head() const { return head_ != nullptr; }
    /// While no pictures come: publishes what has changed about the head.
    void watch_head();
    void set_frames_total(std::int64_t frames) { frames_total_ = frames; }

    void set_run(RunState run, std::optional<Error> failure = std::nullopt);
    RunState run() const { return run_; }
    const ImageSet& images() const { return images_; }

  private:
    const StereoFrame* remembered(std::int64_t frame) const;
    const StereoTracker* steered_tracker() const;
    void take_by_hand(const std::optional<HeadAngles>& commanded);
    std::optional<HeadAim> aim_at(const StereoTracker& tracker) const;
    std::optional<HeadAim> aim_alone() const;
    std::optional<HeadAim> wanted_aim(const StereoTracker* target);
    double age_s(std::int64_t now_ns) const;
    std::optional<HeadAngles> angles_of_pan_tilt_picture();
    double magnified_now() const;
    void look_through_head();
    void steer();
    void publish();
    void announce(Event::Kind kind, std::string text);
    void announce_head();
    HeadSnapshot head_now();
    void watch_rig();
    Result<Done> take_vehicle_motion(const VehicleMotion& motion);
    void note_changes(const TargetStates& before);
    Result<Reply> finish(const Result<Done>& done, const TargetStates& before);
    double rate_hz() const;

    Rig rig_;
    const VisionSystemOptions options_;
    const Clock& clock_;
    Publish publish_;
    Announce announce_;
    TargetSet targets_;
    RigWatch watch_;
    bool rig_moved_told_ = false;
    std::unique_ptr<HeadWorker> head_;
    std::shared_ptr<VehicleFeed> vehicle_;
    bool vehicle_refused_ = false;  // what it told last; said once
    Steering steering_;
    PanTiltServo servo_;
    Frame pan_tilt_grey_;
    bool steers_alone_ = false;
    std::optional<HeadAngles> commanded_;
    std::optional<HeadSnapshot> head_told_;  // with the last snapshot
    std::optional<HeadAngles> aimed_;        // where its axes were, by steering
    std::int64_t followed_ns_ = 0;           // when the head was last told by steering
    ImageSet images_;
    std::optional<TemporalFilter> left_filter_;
    std::optional<TemporalFilter> right_filter_;
    std::deque<StereoFrame> remembered_;  // as they are searched, newest last
    std::optional<StereoFrame> held_;     // likewise, for as long as the operator looks at it
    std::int64_t frames_total_ = -1;
    bool silent_ = false;
    std::deque<std::int64_t> handled_ns_;
    double processing_ms_ = 0.0;
    double latency_ms_ = 0.0;
    std::uint64_t frames_lost_ = 0;
    RunState run_ = RunState::paused;
    std::optional<Error> failure_;
};

}  // namespace kambara
