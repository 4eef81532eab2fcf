// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "core/camera/rig.h"
#include "core/image/frame.h"
#include "core/image/rectangle.h"

namespace kambara::testing_support {

/// A flat, endless, smooth pattern, by itself square to the rig's z axis, drawn for tests by
/// casting one ray a sample through the lens: shares no drawing code with the project.
struct TexturedPlane {
    Eigen::Vector3d origin_in_rig_mm{0.0, 0.0, 1500.0};  ///< moves the pattern with it
    double contrast_grey = 55.0;
    double offset_grey = 125.0;
    double size = 1.0;                                ///< of the pattern
    Eigen::Vector2d slope = Eigen::Vector2d::Zero();  ///< change of z by x and by y

    double grey_at(double u_mm, double v_mm) const;
};

Image drawn(const TexturedPlane& plane, const Camera& camera);
/// Only the part; the rest is even grey.
Image drawn(const TexturedPlane& plane, const Camera& camera, const Rectangle& part);

StereoFrame drawn_pair(const TexturedPlane& plane, const Rig& rig, std::int64_t index,
                       double rate_hz = 30.0);

}  // namespace kambara::testing_support
