// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>

#include "core/base/clock.h"
#include "core/devices/grabber_base.h"
#include "core/devices/pan_tilt_camera.h"
#include "hardware/simulated/simulated_world.h"

namespace kambara {

/// How simulated time passes.
struct SimulatedPace {
    /// Live: frames come when `clock` has reached their time, counted from `start_ns`; who comes
    /// late gets the newest and has lost those between. `clock` outlives the grabber.
    Clock* clock = nullptr;
    std::int64_t start_ns = 0;
    /// Not live: every frame, as fast as it is asked for, and this clock is moved on to its time.
    std::shared_ptr<ManualClock> driven;
    /// Live: only every n-th frame is delivered.
    std::int64_t every = 1;
};

/// A fixed camera of the simulated rig as a real source. Its own counter starts near wrap-around.
std::unique_ptr<GrabberBase> make_simulated_grabber(
    const std::shared_ptr<const SimulatedWorld>& world, FixedCamera camera, std::int64_t start,
    const SimulatedPace& pace);

/// The pan-tilt camera, drawn for where its head looks and how far it is zoomed in: by a
/// SimulatedHead's axes, or what another head tells. As long as the head does not say where it
/// looks, frames are invalid and hold no picture.
std::unique_ptr<GrabberBase> make_simulated_grabber(
    const std::shared_ptr<const SimulatedWorld>& world, std::shared_ptr<PanTiltCamera> head,
    std::int64_t start, const SimulatedPace& pace);

}  // namespace kambara
