// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/geometry/ray.h"
#include "core/geometry/rigid_transform.h"
#include "hardware/simulated/held_target.h"
#include "hardware/simulated/simulated_profile.h"
#include "hardware/simulated/snow.h"
#include "hardware/simulated/tile_texture.h"
#include "hardware/simulated/water.h"

namespace kambara {

/// A speck in the water.
struct Particle {
    Eigen::Vector3d start_mm;
    Eigen::Vector3d drift_mm_s;
    double radius_mm;
    double brightness_grey;
};

/// What there is to see, in the rig's frame: a textured seabed that lies level under a vehicle
/// whose cameras look 15 degrees down, and in front of it either a textured square on a smooth path
/// or a calibration target in still poses, or where somebody holds it. A surface's level is float,
/// grey, or Colour; it is as seen close by in daylight, while what water and lamps make of it is
/// Lighting's. Immutable but for the hand that holds the target; any thread.
class Scene {
  public:
    static constexpr double target_half_side_mm = 150.0;

    /// With a hand: where that holds the calibration target, T_left_from_rig telling its frame.
    explicit Scene(const SimulatedProfile& profile, std::shared_ptr<HeldTarget> hand = {},
                   const RigidTransform& T_left_from_rig = {});

    /// There are two seabeds, which may take turns.
    static constexpr int seabeds = 2;
    int seabed_at(double time_s) const;

    /// How far away the seabed is along a ray, or `no_seabed`.
    double seabed_range_mm(const Ray& ray_in_rig) const;
    static constexpr double no_seabed = -1.0;

    /// The level of a seabed where a ray meets it; `spread` is the ray's width per distance.
    template <class Level>
    Level seabed(int which, const Ray& ray_in_rig, double range_mm, double spread) const;

    /// How bright the light is, 1 at first.
    double light(double time_s) const;
    /// Width of the blur that the water makes of a point at the target's distance.
    double blur_px(double time_s) const {
        return blur_px_at(T_rig_from_target(time_s).t_mm.norm());
    }
    /// And at any other.
    double blur_px_at(double range_mm) const;
    double blur_px_a_length() const { return profile_.blur_px; }  ///< of attenuation

    /// The pose of the thing in front of the seabed. For the moving target: its centre, x and y
    /// along its sides. For a calibration target: its own frame W.
    RigidTransform T_rig_from_target(double time_s) const;

    /// Where a still thing last changed its pose: equal numbers mean equal pictures. -1: it moves.
    std::int64_t still_since(double time_s) const;

    /// The flat sheets of the thing in front, in its own frame.
    const std::vector<TargetPatch>& sheets() const { return sheets_; }

    /// The level of a point on a sheet.
    template <class Level>
    Level surface(std::size_t sheet, float across_mm, float down_mm) const;

    const Water& water() const { return water_; }
    bool has_lamps() const { return profile_.lamps; }
    const Snow& snow() const { return snow_; }
    const std::vector<Particle>& particles() const { return particles_; }
    Eigen::Vector3d particle_place_mm(const Particle& particle, double time_s) const;

  private:
    RigidTransform own_pose(double time_s) const;
    std::optional<HeldTarget::At> held_at(double time_s) const;

    struct Mark {
        float left, top, right, bottom;  // in a sheet's own coordinates, mm
        bool dark, round;
        bool covers(float across_mm, float down_mm) const;
    };

    void arrange_calibration_target(const Target& target);
    float seabed_grey(int which, const Eigen::Vector3d& hit, double footprint_mm) const;
    float sheet_grey(std::size_t sheet, float across_mm, float down_mm) const;

    SimulatedProfile profile_;
    std::shared_ptr<HeldTarget> hand_;
    RigidTransform T_left_from_rig_;
    Water water_;
    Snow snow_;
    std::unique_ptr<TileTexture> tones_;  // of the seabeds, where there is colour
    std::unique_ptr<TileTexture> seabed_[seabeds];
    std::unique_ptr<TileTexture> pattern_;
    std::vector<TargetPatch> sheets_;
    std::vector<std::vector<Mark>> marks_;                 // on each sheet, the topmost last
    Eigen::Vector3d middle_mm_ = Eigen::Vector3d::Zero();  // of the calibration target
    double typical_range_mm_ = 1000.0;
    std::vector<Particle> particles_;
    double phase_[5] = {};
};

template <>
float Scene::seabed(int which, const Ray& ray_in_rig, double range_mm, double spread) const;
template <>
Colour Scene::seabed(int which, const Ray& ray_in_rig, double range_mm, double spread) const;
template <>
float Scene::surface(std::size_t sheet, float across_mm, float down_mm) const;
template <>
Colour Scene::surface(std::size_t sheet, float across_mm, float down_mm) const;

}  // namespace kambara
