// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "core/base/result.h"
#include "core/camera/rig.h"

namespace kambara {

/// The frame in which positions are told (geometry: frames; mount.h): left, the left camera's; rig;
/// level, the rig's turned level; vehicle. Gives the way there from the left camera's frame.
/// Refuses a name it does not know, and level or vehicle where the rig's mount is not known.
Result<RigidTransform> T_frame_from_left(const Rig& rig, std::string_view frame);

}  // namespace kambara
