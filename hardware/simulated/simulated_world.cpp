// SPDX-License-Identifier: GPL-3.0-or-later
#include "hardware/simulated/simulated_world.h"

#include <Eigen/Geometry>
#include <cmath>
#include <utility>

#include "core/camera/nominal_rig.h"

namespace kambara {
namespace {

constexpr std::uint32_t pan_tilt_number = 1;  // cameras 0, 1, 2: left, pan-tilt, right

// From home, the head pans about the camera's y axis and tilts about the x axis carried along.
Eigen::Matrix3d R_home_from_turned(const HeadAngles& angles) {
    return rotation_about_y(angles.pan_rad) * rotation_about_x(angles.tilt_rad);
}

// The channels' levels, interleaved.
const float* numbers(const std::vector<float>& grey) {
    return grey.data();
}
const float* numbers(const std::vector<Colour>& colours) {
    return colours.data()->data();
}

}  // namespace

SimulatedWorld::SimulatedWorld(const SimulatedProfile& profile, std::shared_ptr<HeldTarget> hand)
    : profile_(profile),
      rig_(nominal_rig(profile.medium)),
      head_(true_head(profile, *rig_.pan_tilt)),
      scene_(profile, std::move(hand), rig_.left.T_camera_from_rig),
      vehicle_(profile),
      noise_(profile.noise_grey, profile.seed) {
    if (profile.colour) {
        colour_.emplace(scene_, rig_);
    } else {
        grey_.emplace(scene_, rig_);
    }
}

Rig SimulatedWorld::true_rig() const {
    Rig rig = rig_;
    rig.head = head_;
    return rig;
}

std::int64_t SimulatedWorld::time_ns(std::int64_t frame) const {
    return static_cast<std::int64_t>(
        std::llround(static_cast<double>(frame) * 1e9 / profile_.rate_hz));
}

double SimulatedWorld::time_s(std::int64_t frame) const {
    return static_cast<double>(frame) / profile_.rate_hz;
}

RigidTransform SimulatedWorld::T_camera_from_world(const Camera& camera, std::int64_t frame) const {
    return vehicle_.moves() ? camera.T_camera_from_rig * vehicle_.T_rig_from_world(time_s(frame))
                            : camera.T_camera_from_rig;
}

template <class Level>
Image SimulatedWorld::fixed_picture(const Views<Level>& views, FixedCamera camera,
                                    std::int64_t frame) const {
    const bool left = camera == FixedCamera::left;
    const Camera& lens = left ? rig_.left : *rig_.right;
    const CameraView<Level>& view = left ? views.left : views.right;
    const bool knocked = !left && profile_.knock_s >= 0.0 && time_s(frame) >= profile_.knock_s;
    RigidTransform T = T_camera_from_world(lens, frame);
    if (knocked) {
        T = RigidTransform{rotation_about_x(profile_.knock_rad), Eigen::Vector3d::Zero()} * T;
    }
    const auto levels =
        vehicle_.moves() || knocked ? view.draw_turned(time_s(frame), T) : view.draw(time_s(frame));
    return noise_.digitised(numbers(levels), lens.width_px, lens.height_px, Channels<Level>::count,
                            left ? 0U : 2U, frame);
}

template <class Level>
Image SimulatedWorld::turned_picture(const Views<Level>& views, std::int64_t frame,
                                     const HeadAngles& angles, double magnification) const {
    const Camera& camera = *rig_.pan_tilt;
    const RigidTransform T_turned_from_home =
        head_ ? kambara::T_camera_from_rig(*head_, angles) * camera.T_camera_from_rig.inverse()
              : RigidTransform{R_home_from_turned(angles).transpose(), Eigen::Vector3d::Zero()};
    const auto levels = views.pan_tilt.draw_turned(
        time_s(frame), T_turned_from_home * T_camera_from_world(camera, frame), magnification);
    return noise_.digitised(numbers(levels), camera.width_px, camera.height_px,
                            Channels<Level>::count, pan_tilt_number, frame);
}

Image SimulatedWorld::picture(FixedCamera camera, std::int64_t frame) const {
    return colour_ ? fixed_picture(*colour_, camera, frame) : fixed_picture(*grey_, camera, frame);
}

Image SimulatedWorld::pan_tilt_picture(std::int64_t frame, const HeadAngles& angles,
                                       double magnification) const {
    return colour_ ? turned_picture(*colour_, frame, angles, magnification)
                   : turned_picture(*grey_, frame, angles, magnification);
}

RigidTransform SimulatedWorld::T_left_from_target(std::int64_t frame) const {
    return T_camera_from_world(rig_.left, frame) * scene_.T_rig_from_target(time_s(frame));
}

std::optional<Eigen::Vector2d> SimulatedWorld::target_point_under(const Eigen::Vector2d& left_px,
                                                                  std::int64_t frame) const {
    const auto ray = kambara::unproject(rig_.left.lens, left_px);
    if (!ray || profile_.calibration_target) {
        return std::nullopt;
    }
    const Ray in_target = T_left_from_target(frame).inverse() * *ray;
    const Eigen::Vector3d at = in_target.at(-in_target.origin_mm.z() / in_target.direction.z());
    if (at.head<2>().cwiseAbs().maxCoeff() > Scene::target_half_side_mm) {
        return std::nullopt;
    }
    return Eigen::Vector2d(at.head<2>());
}

Eigen::Vector3d SimulatedWorld::point_in_left_mm(const Eigen::Vector2d& target_point_mm,
                                                 std::int64_t frame) const {
    return T_left_from_target(frame) *
           Eigen::Vector3d(target_point_mm.x(), target_point_mm.y(), 0.0);
}

Rectangle SimulatedWorld::suggested_template(int size_px, std::int64_t frame) const {
    const auto centre = kambara::project(rig_.left.lens, T_left_from_target(frame).t_mm);
    const double corner = 0.5 * (size_px - 1);
    return {static_cast<int>(std::lround(centre->x() - corner)),
            static_cast<int>(std::lround(centre->y() - corner)), size_px, size_px};
}

}  // namespace kambara
