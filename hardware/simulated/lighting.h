// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <vector>

#include "core/camera/rig.h"
#include "hardware/simulated/pixel_rays.h"
#include "hardware/simulated/water.h"

namespace kambara {

/// What a pixel's level is in a grey picture, float: water's green; and in a coloured one, Colour.
template <class Level>
struct Channels;

template <>
struct Channels<float> {
    using Rates = double;
    static constexpr int count = 1;
    static double of(const Eigen::Array3d& colours) { return colours[1]; }
    static float level(double rate) { return static_cast<float>(rate); }
    static double exp(double rate) { return std::exp(rate); }
    static float flat(float grey) { return grey; }
};

template <>
struct Channels<Colour> {
    using Rates = Eigen::Array3d;
    static constexpr int count = 3;
    static Eigen::Array3d of(const Eigen::Array3d& colours) { return colours; }
    static Colour level(const Eigen::Array3d& rates) { return rates.cast<float>(); }
    static Eigen::Array3d exp(const Eigen::Array3d& rates) {
        return {std::exp(rates[0]), std::exp(rates[1]), std::exp(rates[2])};  // Eigen's is slower
    }
    static Colour flat(float grey) { return Colour::Constant(grey); }
};

/// Light and water between a camera's pixels and what they look at: sunlight, by Water's closed
/// form, or lamps, from a table over the picture and the range. Immutable; any thread.
template <class Level>
class Lighting {
  public:
    /// Sunlight.
    explicit Lighting(const Water& water);

    /// Lamps on the rig, for a camera that stands so.
    Lighting(const Water& water, const Camera& camera, const PixelRays& rays,
             const RigidTransform& T_camera_from_rig);

    /// The level in which a surface is seen by the pixel (x, y) at a range, without its blurred
    /// share.
    Level seen(const Level& surface, double x_px, double y_px, double range_mm) const;

    /// The share that is scattered forward: to be blurred and added.
    Level scattered(const Level& surface, double x_px, double y_px, double range_mm) const;

    /// What a speck that shines `peak` brighter than the water there adds.
    Level added(float peak, double x_px, double y_px, double range_mm) const;

    /// Water without an end.
    Level endless(double x_px, double y_px) const;

    bool scatters_forward() const { return forward_share_ > 0.0; }

  private:
    using Rates = typename Channels<Level>::Rates;
    struct Node {
        Level kept;
        Level veil;
    };

    Node node(double x_px, double y_px, double range_mm) const;

    Rates attenuation_per_m_;
    Rates backscatter_per_m_;
    Level veil_;
    Level sunlight_;
    bool one_rate_;  // attenuation and backscatter alike
    double forward_share_;
    int across_ = 0;  // of the lamps' table, and down
    int down_ = 0;
    std::vector<Node> nodes_;  // row by row, and at each place by range
};

extern template class Lighting<float>;
extern template class Lighting<Colour>;

}  // namespace kambara
