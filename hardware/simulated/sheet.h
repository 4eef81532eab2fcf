// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "core/calibration/target.h"

namespace kambara {

/// A flat rectangle before a camera: where the camera's rays meet it.
class Sheet {
  public:
    /// Where a ray meets the sheet's plane: along its two edges, mm, and how deep, mm of z. Not
    /// positive: behind the camera, or nowhere.
    struct Meeting {
        float u_mm, v_mm, depth_mm;
    };

    explicit Sheet(const TargetPatch& in_camera);

    /// Along the ray of the given x/z and y/z.
    Meeting meet(const Eigen::Vector2f& slope) const {
        const Eigen::Vector3f direction(slope.x(), slope.y(), 1.0F);
        const float depth = offset_ / normal_.dot(direction);
        const Eigen::Vector3f from_origin = depth * direction - origin_;
        return {from_origin.dot(across_), from_origin.dot(down_), depth};
    }

    bool covers(float u_mm, float v_mm) const {
        return u_mm >= 0.0F && v_mm >= 0.0F && u_mm < width_mm_ && v_mm < height_mm_;
    }

    /// Whether the sheet lies between the camera and a point of its frame.
    bool hides(const Eigen::Vector3d& point_in_camera_mm) const;

  private:
    Eigen::Vector3f origin_;
    Eigen::Vector3f across_;  // of unit length, as are down_ and normal_
    Eigen::Vector3f down_;
    Eigen::Vector3f normal_;
    float offset_;
    float width_mm_;
    float height_mm_;
};

}  // namespace kambara
