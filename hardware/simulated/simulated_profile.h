// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/angles.h"
#include "core/base/result.h"
#include "core/calibration/target.h"
#include "core/camera/rig.h"
#include "hardware/simulated/water.h"

namespace kambara {

/// Where the textured target goes.
enum class TargetPath {
    swimming,  ///< to and fro on a smooth path
    stations,  ///< to the range experiment's places, one after the other (station_path.h)
    plumb,     ///< straight up and down, 1.3 m before the rig
};

/// What is simulated. The same profile gives the same pictures, always.
struct SimulatedProfile {
    std::string name = "default";
    std::uint32_t seed = 1;
    Medium medium = Medium::air;  ///< which lenses the nominal rig has
    double rate_hz = 30.0;
    double noise_grey = 2.0;  ///< standard deviation of a pixel, grey levels
    bool colour = false;      ///< pictures of three channels; else grey, which is the green
    WaterKind water = WaterKind::grey;
    bool lamps = false;           ///< the rig's own, and no sunlight
    double haze_per_m = 0.25;     ///< light is lost as exp(-haze range); in green, as is the veil
    double veil_grey = 70.0;      ///< of endless water
    int particles = 60;           ///< specks drifting in front of the cameras
    double snow_per_litre = 0.0;  ///< marine snow: flakes of 0.5 to 5 mm
    double forward_share = 0.0;   ///< of the light lost, how much arrives blurred all the same
    /// The blur, so many pixels for each attenuation length (haze times range): of the forward
    /// share where there is one, else of the whole picture, as for the target's range.
    double blur_px = 0.0;
    double step = 0.0;  ///< share of the light that is missing in every other 3 seconds
    double swap_s =
        0.0;  ///< after so many seconds another seabed lies behind, then the first again
    double nearest_mm = 1350.0;   ///< of the moving target's path, along the rig's z axis
    double farthest_mm = 2550.0;  ///< likewise
    double circle_mm = 0.0;       ///< above 0: the moving target goes round on a circle instead
    int likes = 0;                ///< copies of the moving target beside it, carried along
    double turn_rad_s = 0.0;      ///< the vehicle's largest turn rate, swinging to and fro
    double sway_mm_s = 0.0;       ///< its largest speed to the sides, likewise
    double turn_period_s = 2.0;   ///< of one swing
    bool feed = true;             ///< a vehicle that moves tells how (VehicleFeed),
    double feed_delay_s = 0.02;   ///< so late,
    double feed_turn_noise_rad_s = 0.01;     ///< with this noise on each component
    double feed_velocity_noise_mm_s = 20.0;  ///< likewise
    double knock_s = -1.0;  ///< from then on the right camera looks down by knock_rad; <0: never
    double knock_rad = 0.0;
    /// The pan-tilt camera does not turn about its own centre: that lies ahead of the tilt axis by
    /// the arm, and this ahead of the pan axis, and is not quite square to it. At home all of it is
    /// where the nominal rig has it.
    double head_arm_mm = 0.0;
    double head_ahead_mm = 0.0;
    double head_skew_rad = 0.0;
    HeadAngles head_backlash;  ///< of both axes alike
    std::int64_t frames = -1;  ///< the source ends after so many; -1: never
    /// A calibration target shown in still poses, a second each, instead of the moving target.
    std::optional<Target> calibration_target;
    TargetPath path = TargetPath::swimming;
};

/// How its head's camera really moves, the pan-tilt camera being there when it is at home; empty
/// where that is about its own centre, without backlash.
std::optional<HeadModel> true_head(const SimulatedProfile& profile, const Camera& pan_tilt_at_home);

/// Reads `NAME?key=value&key=value`. Names: default (a textured target on a smooth path),
/// chessboard (9x6:30 unless target= says otherwise), two-plane-24, stations (the range
/// experiment's 75 places, a second each), plumb (moved straight up and down). Keys: seed, noise,
/// colour, lamps, water (clear, coastal, harbour: sets veil and medium and those between, each of
/// which may be given as well), haze, veil, forward, blur, snow, particles, step, swap, nearest,
/// farthest, likes, circle (m; at 0.3 m/s, 1.5 m away), turn (degrees a second), sway (m/s), swing
/// (s), feed, feed_delay (s), feed_noise (degrees a second), knock (s), knock_deg, arm, ahead (mm),
/// skew, backlash (degrees), frames, rate, medium (air, water), target.
Result<SimulatedProfile> simulated_profile(std::string_view text);

}  // namespace kambara
