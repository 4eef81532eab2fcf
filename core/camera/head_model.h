// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/angles.h"
#include "core/geometry/rigid_transform.h"

namespace kambara {

/// Where a head's camera is at which angles (geometry: pan-tilt mapping, STR-4). The base's frame
/// is the rig's turned by the mount's angle: the pan axis is its y axis, z looks ahead at pan 0.
/// The tilt axis, near x, is carried along by the pan axis, ahead of it by the first lever arm, and
/// carries the camera, whose centre is off it by the second.
///     p_camera = T_camera_from_tilt Rx(tilt)^T Rz(skew)^T (Ry(pan)^T p_base - (0, 0, arm))
struct HeadModel {
    RigidTransform T_base_from_rig;
    double tilt_axis_ahead_mm = 0.0;    ///< the first lever arm
    double tilt_axis_skew_rad = 0.0;    ///< turned about z, from square to the pan axis
    RigidTransform T_camera_from_tilt;  ///< the second lever arm, and the offsets of the angles
    /// How much farther the encoder goes than the axis when the direction is turned round: half of
    /// it is missing after an approach from below, and too much after one from above.
    double pan_backlash_rad = 0.0;
    double tilt_backlash_rad = 0.0;
};

/// The camera's pose at the axes' own angles.
RigidTransform T_camera_from_rig(const HeadModel& model, const HeadAngles& angles);

/// From which side an axis came to where it is: 1 from below (it grew), -1 from above, 0 unknown.
struct HeadApproach {
    int pan = 0;
    int tilt = 0;
};

/// The axes' own angles when the encoders tell these.
HeadAngles axes_at(const HeadModel& model, const HeadAngles& encoder, const HeadApproach& approach);

}  // namespace kambara
