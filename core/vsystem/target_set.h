// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/result.h"
#include "core/base/worker_pool.h"
#include "core/camera/rig.h"
#include "core/image/frame.h"
#include "core/tracking/stereo_tracker.h"

namespace kambara {

/// One target that was chosen.
struct FollowedTarget {
    int id = 0;
    StereoTracker tracker;
    std::optional<std::int64_t> template_frame;  ///< that it was chosen in, until it is started
};

/// What became of the targets, for comparing before and after.
struct TargetStates {
    std::map<int, TrackState> of;
    std::optional<int> steered;
};

/// The targets that are followed, up to most_targets, by ascending id; the head is steered to one
/// of them. Each has a tracker of its own: they are followed at the same time, on several threads,
/// with the same results as one after the other. A refused call changes nothing. Owned and used by
/// one thread.
class TargetSet {
  public:
    /// `threads` to follow them on; 0 for as many as the machine has cores.
    TargetSet(Rig rig, const TrackerOptions& options, int threads);

    const std::vector<FollowedTarget>& all() const { return targets_; }
    const FollowedTarget* find(int id) const;  ///< null where there is no such target
    /// The one that the head is steered to; null while there is none.
    const FollowedTarget* steered() const { return find(steered_); }
    TargetStates states() const;

    /// Cuts the template of a target that there is or is not yet; without `id`, the steered one's.
    Result<Done> set_template(std::optional<int> id, const StereoFrame& pair,
                              const Rectangle& rectangle);
    /// Starts one, or all, and follows them from the pair that they were chosen in to the last one
    /// of `pairs`, of which there is one at least.
    Result<Done> start(std::optional<int> id, const std::deque<StereoFrame>& pairs);
    Result<Done> stop(std::optional<int> id);
    Result<Done> clear(std::optional<int> id);
    /// Without `id`, the steered one's.
    Result<Done> update_template(std::optional<int> id);
    Result<Done> steer_to(int id);

    /// How the vehicle moves, which moves what is followed.
    bool add_vehicle_motion(const VehicleMotion& motion) { return vehicle_->add(motion); }
    void process(const StereoFrame& pair);
    /// Stops all: no pair seen so far says where they are.
    void wound();
    /// Forgets all, for another calibration.
    void use_rig(const Rig& rig);

  private:
    FollowedTarget* own(int id);
    Result<std::vector<FollowedTarget*>> chosen(std::optional<int> id);

    Rig rig_;
    TrackerOptions options_;
    std::shared_ptr<TransformCache> transforms_ = std::make_shared<TransformCache>();
    std::shared_ptr<VehicleTrack> vehicle_ = std::make_shared<VehicleTrack>();
    std::vector<FollowedTarget> targets_;
    int steered_ = 1;
    WorkerPool workers_;
};

}  // namespace kambara
