// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/angles.h"
#include "core/base/error.h"
#include "core/devices/head_state.h"
#include "core/image/frame.h"
#include "core/stereo/rig_watch.h"
#include "core/tracking/stereo_tracker.h"

namespace kambara {

/// The pictures of one instant. Shared, never written to again.
struct ImageSet {
    StereoFrame stereo;  ///< as the grabbers delivered them, colour or grey
    Frame pan_tilt;      ///< without a picture where there is no such camera
    /// When both pictures of the pair were there, on the system's clock; 0 where not noted.
    std::int64_t arrived_ns = 0;
};

/// One target in a snapshot.
struct TrackSnapshot {
    int id = 0;
    TrackEstimate estimate;
};

/// The pan-tilt head in a snapshot.
struct HeadSnapshot {
    HeadAngles angles;                    ///< where its encoders are, as it tells
    std::optional<HeadAngles> commanded;  ///< where it was last told to look
    bool moving = false;
    bool automatic = true;  ///< steered to the target; false: by hand
    bool at_limit = false;  ///< the target is beyond what the head can reach
    std::string fault;      ///< the device's last complaint; empty while all is well
    std::optional<LensStatus> lens = std::nullopt;  ///< empty where the head does not tell
    HeadAbilities abilities = {};
    HeadLimits limits = {};
    /// Where its axes are, and so where it looks: behind the encoders by what the head model's
    /// backlash leaves; without a model the same.
    HeadAngles axes = {};
    bool operator==(const HeadSnapshot&) const = default;
};

/// What the pan-tilt camera's own picture says of the steered target (ServoHead).
struct ServoSnapshot {
    bool on = false;
    TrackState state = TrackState::idle;
    std::string reason;                          ///< why the state is what it is
    std::optional<Eigen::Vector2d> pan_tilt_px;  ///< where it is seen; empty unless for sure
    Eigen::Vector2i template_size_px = Eigen::Vector2i::Zero();
    double quality = 0.0;
    std::optional<HeadAngles> correction;  ///< that the stereo pair's aim is given
    bool alone = false;                    ///< the head follows by this picture alone
    bool operator==(const ServoSnapshot&) const = default;
};

enum class RunState { paused, running, ended, failed };

/// What the system knew after one pair of pictures. Immutable; readers hold it as long as they
/// like. Everything but the pictures and how they were searched serialises (serialise.h).
struct Snapshot {
    std::int64_t frame = -1;   ///< number of the pair, counted from the source's first
    std::int64_t time_ns = 0;  ///< when the left picture was exposed, on the source's clock
    RunState run = RunState::paused;
    std::optional<Error> failure;       ///< why it failed, when it did
    std::vector<TrackSnapshot> tracks;  ///< by ascending id
    std::optional<int> steered_target;  ///< the one that the head is steered to; empty without any
    std::optional<HeadSnapshot> head;
    std::optional<ServoSnapshot> servo;  ///< while it is on
    double rate_hz = 0.0;                ///< pairs handled in a second, over the last one
    double processing_ms = 0.0;          ///< time spent on this pair
    double latency_ms = 0.0;             ///< from the pair's arrival to its result
    std::int64_t frames_total = -1;  ///< of a recording; -1 where there is no end or it is unknown
    /// Whether the cameras still stand as calibrated; empty while too few matches tell.
    std::optional<RigWatchState> rig_watch;
    std::uint64_t frames_lost = 0;  ///< that came while the pipeline was busy, or without a partner
    ImageSet pictures;
};

/// The target that the head is steered to; null where there is none.
const TrackSnapshot* steered_track(const Snapshot& snapshot);
/// What is known of it; Idle where there is none.
TrackEstimate steered_estimate(const Snapshot& snapshot);

using SnapshotPtr = std::shared_ptr<const Snapshot>;

/// Something an operator should be told, once: a change of state, a fault, an end.
struct Event {
    enum class Kind { note, warning, fault };
    Kind kind = Kind::note;
    std::int64_t frame = -1;
    std::int64_t time_ns = 0;
    std::string text;
    bool operator==(const Event&) const = default;
};

}  // namespace kambara
