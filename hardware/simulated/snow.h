// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace kambara {

/// A flake of marine snow.
struct Flake {
    Eigen::Vector3f start_mm;
    Eigen::Vector3f drift_mm_s;
    float diameter_mm;
    float grey;  ///< level in which it would be seen without water between
};

/// Marine snow in the water before the rig: flakes of 0.5 to 5 mm whose number falls with the
/// fourth power of their diameter (Junge's law), carried sideways by a slow current. In the rig's
/// frame; what leaves the box on one side comes in on the other. Immutable; any thread.
class Snow {
  public:
    static constexpr double thinnest_mm = 0.5;
    static constexpr double thickest_mm = 5.0;

    Snow(double per_litre, std::uint32_t seed);

    static double box_litres();
    const std::vector<Flake>& flakes() const { return flakes_; }
    static Eigen::Vector3f place_mm(const Flake& flake, double time_s);

  private:
    std::vector<Flake> flakes_;
};

}  // namespace kambara
