// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "core/base/clock.h"
#include "core/base/result.h"
#include "core/camera/rig.h"
#include "core/vsystem/vision_system.h"

namespace kambara {

class HeldTarget;
class SimulatedWorld;

/// What the command line names: pictures, a rig file, a head.
struct SourceOptions {
    std::string left;
    std::string right;  ///< empty: one camera only (with sim: the simulated right camera)
    std::string
        pan_tilt;  ///< sim:..., a real head's URI; empty: none (with sim: the simulated head)
    /// A real head that is open already, in place of the one `pan_tilt` names.
    std::shared_ptr<PanTiltCamera> head = nullptr;
    std::string rig;  ///< a rig file; may be empty with sim:, and with one camera alone
    std::int64_t start = 0;
    bool live = false;               ///< in real time; else as fast as it goes, every frame
    bool pan_tilt_pictures = false;  ///< draw the simulated pan-tilt camera's pictures too
    double pictures_rate_hz = 10.0;  ///< of single pictures, which carry no time
};

/// Everything a vision system is made of, opened, and what belongs to it.
struct Sources {
    VisionSystemParts parts;
    bool every_frame = true;
    /// The head is a real one: what is steered by recordings goes no faster than they did.
    bool real_head = false;
    /// Where the pictures come from a simulation: its truth.
    std::shared_ptr<const SimulatedWorld> world;
    /// Live, where the simulation shows a calibration target: the hand that can hold it.
    std::shared_ptr<HeldTarget> hand;
    /// The simulation's own time, where it does not run in real time.
    std::shared_ptr<ManualClock> simulated_time;
};

/// Opens what the options name. `clock` is the machine's and outlives what is opened.
Result<Sources> open_sources(const SourceOptions& options, Clock& clock);

}  // namespace kambara
