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
#include "hardware/simulated/simulated_vehicle.h"

namespace kambara {

enum class FixedCamera { left, right };

/// A simulated rig in its surroundings: pictures, and the truth behind them. Immutable, so any
/// thread may ask for any frame in any order, and always gets the same; unless a hand holds the
/// target: then frames are to be asked for about in their order.
class SimulatedWorld {
  public:
    /// With a hand: a calibration target is where that holds it, as long as it does.
    explicit SimulatedWorld(const SimulatedProfile& profile, std::shared_ptr<HeldTarget> hand = {});

    const SimulatedProfile& profile() const { return profile_; }
    /// As it was calibrated, which knows nothing of the head's axes.
    const Rig& rig() const { return rig_; }
    /// With how the head's camera really moves, where that is not about its own centre.
    Rig true_rig() const;
    std::int64_t time_ns(std::int64_t frame) const;

    /// Grey, or of three channels where the profile wants colour.
    Image picture(FixedCamera camera, std::int64_t frame) const;
    /// The pan-tilt camera's picture with the head's axes at the angles and its lens zoomed in so
    /// far.
    Image pan_tilt_picture(std::int64_t frame, const HeadAngles& angles,
                           double magnification = 1.0) const;

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
    template <class Level>
    struct Views {
        Views(const Scene& scene, const Rig& rig)
            : left(scene, rig.left), right(scene, *rig.right), pan_tilt(scene, *rig.pan_tilt) {}
        CameraView<Level> left;
        CameraView<Level> right;
        CameraView<Level> pan_tilt;
    };

    double time_s(std::int64_t frame) const;
    /// Where the camera is in the world.
    RigidTransform T_camera_from_world(const Camera& camera, std::int64_t frame) const;
    template <class Level>
    Image fixed_picture(const Views<Level>& views, FixedCamera camera, std::int64_t frame) const;
    template <class Level>
    Image turned_picture(const Views<Level>& views, std::int64_t frame, const HeadAngles& angles,
                         double magnification) const;

    SimulatedProfile profile_;
    Rig rig_;
    std::optional<HeadModel> head_;
    Scene scene_;  // in the world's frame
    SimulatedVehicle vehicle_;
    std::optional<Views<float>> grey_;  // the one or the other
    std::optional<Views<Colour>> colour_;
    SensorNoise noise_;
};

}  // namespace kambara
