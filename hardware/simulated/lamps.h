// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/geometry/ray.h"
#include "hardware/simulated/water.h"

namespace kambara {

/// Two white lamps beside the fixed cameras, aimed at what lies before them, as the only light.
class Lamps {
  public:
    /// What they make of a ray's way up to some range: a surface of level J is seen there as
    /// J kept + veil.
    struct Along {
        Eigen::Array3d kept = Eigen::Array3d::Ones();
        Eigen::Array3d veil = Eigen::Array3d::Zero();
    };

    explicit Lamps(const Water& water);

    /// Light on a place, for each lamp at the distance d its pattern times exp(-c d) / d^2; scaled
    /// so that green is 1, as sunlight is, 1.5 m before the rig. In very turbid water it is less,
    /// as a camera would be stopped down: straight ahead, the veil is 100 grey levels at the most.
    Eigen::Array3d light_at(const Eigen::Vector3d& point_in_rig_mm) const;

    /// At each of the rising ranges. The veil is summed in slabs between them: each sends back its
    /// own light, attenuated on the way.
    std::vector<Along> along(const Ray& ray_in_rig, const std::vector<double>& ranges_mm) const;

  private:
    Water water_;
    double scale_ = 1.0;
};

}  // namespace kambara
