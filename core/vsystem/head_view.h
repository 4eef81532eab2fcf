// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/calibration/target.h"
#include "core/camera/rig.h"
#include "core/image/image.h"
#include "core/pointing/head_calibration.h"

namespace kambara {

/// What three cameras saw of a target at one moment.
struct HeadPictures {
    ImagePtr left;
    ImagePtr right;
    ImagePtr pan_tilt;
};

/// The target's pose from its corners in both fixed pictures: each corner's position, then the
/// target, whose shape is known, laid upon them (Umeyama 1991). The rig must have a right camera.
/// Refuses, saying why: no picture, one of another size than the rig was calibrated for, a target
/// that is not found or shares fewer than eight corners.
Result<RigidTransform> target_in_rig(const Rig& rig, const Target& target, const Image& left,
                                     const Image& right);

/// A view for calibrate_head(): the places of the target's corners from the fixed cameras, where
/// these see them, and where the head's camera does while the encoders tell `encoder`. The target
/// and the head are still. Refuses as above, and where the head's camera sees fewer than eight
/// corners. The rig must have all three cameras.
Result<HeadView> head_view_from(const Rig& rig, const Target& target, const HeadPictures& pictures,
                                const HeadAngles& encoder, const HeadApproach& approach);

}  // namespace kambara
