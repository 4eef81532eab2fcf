// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <optional>

#include "core/base/angles.h"
#include "core/camera/rig.h"
#include "core/image/image.h"
#include "core/image/rectangle.h"
#include "hardware/simulated/camera_view.h"
#include "hardware/simulated/scene.h"
#include "hardware/simulated/sensor_noise.h"
#include "hardware/simulated/simulated_profile.h"

namespace kambara {

enum class FixedCamera { left, right };

/// A simulated rig in its surroundings: pictures, and the truth behind them. Immutable, so any
/// thread may ask for any frame in any order, and always gets the same.
class SimulatedWorld {
  public:
    explicit SimulatedWorld(const SimulatedProfile& profile);

    const SimulatedProfile& profile() const { return profile_; }
    const Rig& rig() const { return rig_; }
    std::int64_t time_ns(std::int64_t frame) const;

    Image picture(FixedCamera camera, std::int64_t frame) const;
    /// The pan-tilt camera's picture with the head at the angles.
    Image pan_tilt_picture(std::int64_t frame, const HeadAngles& angles) const;

    /// Pose of the target in the left camera's frame: the moving target's centre and sides, or a
    /// calibration target's own frame.
    RigidTransform T_left_from_target(std::int64_t frame) const;
    /// Where the left pixel's ray meets the moving target, in the target's own coordinates, mm from
    /// its centre; empty where it passes by.
    std::optional<Eigen::Vector2d> target_point_under(const Eigen::Vector2d& left_px,
                                                      std::int64_t frame) const;
    /// The place of that point of the target in a frame.
    Eigen::Vector3d point_in_left_mm(const Eigen::Vector2d& target_point_mm,
                                     std::int64_t frame) const;
    /// A square of `size_px` about the target's centre in the left picture.
    Rectangle suggested_template(int size_px, std::int64_t frame = 0) const;

  private:
    double time_s(std::int64_t frame) const;

    SimulatedProfile profile_;
    Rig rig_;
    Scene scene_;
    CameraView left_;
    CameraView right_;
    CameraView pan_tilt_;
    SensorNoise noise_;
};

}  // namespace kambara
