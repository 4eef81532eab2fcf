// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "core/base/clock.h"
#include "core/base/result.h"
#include "core/devices/pan_tilt_camera.h"
#include "core/devices/vehicle_feed.h"
#include "core/matching/temporal_filter.h"
#include "core/pointing/steering.h"
#include "core/vsystem/frame_source.h"
#include "core/vsystem/vsystem_interface.h"

namespace kambara {

/// What a vision system is put together from.
struct VisionSystemParts {
    Rig rig;
    Grabbers grabbers;
    std::shared_ptr<PanTiltCamera> head;  ///< null where there is none
    /// The vehicle's state estimator; null where there is none, or where it comes as commands.
    std::shared_ptr<VehicleFeed> vehicle = nullptr;
};

struct VisionSystemOptions {
    TrackerOptions tracker;
    SteeringOptions steering;
    /// Both pictures are filtered over time before the target is looked for in them; for cameras
    /// and targets that stand still.
    std::optional<TemporalOptions> temporal;
    /// Threads that several targets are shared out among; 0 for as many as the machine has cores.
    /// Their results are the same with any number.
    int threads = 0;
    /// Every frame is handled, in step with the grabbers (recordings, simulations that may run
    /// faster than life). Otherwise the cameras are live, have threads of their own, and the newest
    /// pair wins.
    bool every_frame = false;
    /// With every_frame: no faster than the time stamps say, as a recording is watched.
    bool in_real_time = false;
    /// Holds after the first pair until told to run (Flow).
    bool start_paused = false;
};

/// Opens the in-process vision system and waits for its first pair of pictures. Refuses pictures
/// that do not fit the calibration, a source that fails at once, and a live one that stays silent
/// for five seconds. A calibration made at another resolution of the same shape is scaled. `clock`
/// outlives the system and times it (rate, processing time).
///
/// One pipeline thread owns all state. Commands wait in a queue until it is between two pairs;
/// snapshots leave it as shared immutable values: one a pair, one a command that changes anything,
/// and, while no pictures come, one whenever something has changed about the head.
///
///              open                Flow::run                source's end
///   (pictures) ----> paused <------------------> running ----------------> ended
///                      |    Flow::pause, Seek       |    (Seek leads back)
///                      +------ source's fault ------+------> failed
Result<std::unique_ptr<VsystemInterface>> open_vision_system(VisionSystemParts parts,
                                                             const VisionSystemOptions& options,
                                                             Clock& clock);

}  // namespace kambara
