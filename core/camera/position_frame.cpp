// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/camera/position_frame.h"

#include <string>

namespace kambara {

Result<RigidTransform> T_frame_from_left(const Rig& rig, std::string_view frame) {
    if (frame == "left") {
        return RigidTransform{};
    }
    const RigidTransform T_rig_from_left = rig.left.T_camera_from_rig.inverse();
    if (frame == "rig") {
        return T_rig_from_left;
    }
    if (frame != "level" && frame != "vehicle") {
        return Error{"There is no frame \"" + std::string(frame) + "\".",
                     "Give left, rig, level or vehicle."};
    }
    if (!rig.mount) {
        return Error{"The rig file does not say how the rig is mounted.",
                     "Find it with level, which writes it into the rig file, or choose the frame "
                     "left or rig."};
    }
    if (frame == "level") {
        return RigidTransform{R_level_from_rig(*rig.mount), Eigen::Vector3d::Zero()} *
               T_rig_from_left;
    }
    return T_vehicle_from_rig(*rig.mount) * T_rig_from_left;
}

}  // namespace kambara
