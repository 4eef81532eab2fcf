// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>

#include "core/base/vehicle_motion.h"
#include "core/devices/vehicle_feed.h"
#include "core/geometry/rigid_transform.h"
#include "hardware/simulated/simulated_profile.h"

namespace kambara {

/// The vehicle that carries the simulated rig: it swings about its vertical axis, as one that looks
/// to and fro, and sways sideways, as the profile says. At time 0 it looks straight ahead; the
/// world's frame is the rig's then. Immutable; any thread.
class SimulatedVehicle {
  public:
    explicit SimulatedVehicle(const SimulatedProfile& profile) : profile_(profile) {}

    bool moves() const { return profile_.turn_rad_s != 0.0 || profile_.sway_mm_s != 0.0; }
    RigidTransform T_rig_from_world(double time_s) const;
    /// Its exact motion, the sigmas those of the profile's state feed.
    VehicleMotion motion(std::int64_t time_ns) const;

  private:
    SimulatedProfile profile_;
};

/// The vehicle's state estimator: its motion a hundred times a second, with noise, and late (the
/// profile's feed keys). The same profile gives the same samples. Null where the vehicle does not
/// move or has no such feed.
std::unique_ptr<VehicleFeed> make_simulated_feed(const SimulatedProfile& profile);

}  // namespace kambara
