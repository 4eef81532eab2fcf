// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/camera/head_model.h"

#include <Eigen/Geometry>

namespace kambara {

RigidTransform T_camera_from_rig(const HeadModel& model, const HeadAngles& angles) {
    const RigidTransform T_pan_from_base{rotation_about_y(angles.pan_rad).transpose(),
                                         {0.0, 0.0, -model.tilt_axis_ahead_mm}};
    const Eigen::Matrix3d skewed =
        Eigen::AngleAxisd(model.tilt_axis_skew_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    const RigidTransform T_tilt_from_pan{(skewed * rotation_about_x(angles.tilt_rad)).transpose(),
                                         Eigen::Vector3d::Zero()};
    return model.T_camera_from_tilt * T_tilt_from_pan * T_pan_from_base * model.T_base_from_rig;
}

HeadAngles axes_at(const HeadModel& model, const HeadAngles& encoder,
                   const HeadApproach& approach) {
    return {encoder.pan_rad - 0.5 * approach.pan * model.pan_backlash_rad,
            encoder.tilt_rad - 0.5 * approach.tilt * model.tilt_backlash_rad};
}

}  // namespace kambara
