// SPDX-License-Identifier: GPL-3.0-or-later
#include "hardware/simulated/lighting.h"

#include <algorithm>
#include <cstddef>

#include "hardware/simulated/lamps.h"

namespace kambara {
namespace {

// The lamps' light changes little over 32 pixels, and over 7 % of the range.
constexpr int table_step_px = 32;
constexpr int table_ranges = 96;
constexpr double nearest_mm = 30.0;
constexpr double farthest_mm = 20000.0;

double table_log_step() {
    static const double step = std::log(farthest_mm / nearest_mm) / (table_ranges - 1);
    return step;
}

std::vector<double> ranges_of_table() {
    std::vector<double> ranges;
    ranges.reserve(table_ranges);
    for (int i = 0; i < table_ranges; ++i) {
        ranges.push_back(nearest_mm * std::exp(i * table_log_step()));
    }
    return ranges;
}

// Where a value lies on the table's axis: the node before it, and how far on to the next.
struct Place {
    std::size_t index;
    float share;
};

Place place_of(double at, int nodes) {
    const double inside = std::clamp(at, 0.0, nodes - 1.001);
    const int index = static_cast<int>(inside);
    return {static_cast<std::size_t>(index), static_cast<float>(inside - index)};
}

}  // namespace

template <class Level>
Lighting<Level>::Lighting(const Water& water)
    : attenuation_per_m_(Channels<Level>::of(water.attenuation_per_m)),
      backscatter_per_m_(Channels<Level>::of(water.backscatter_per_m)),
      veil_(Channels<Level>::level(Channels<Level>::of(water.veil_grey))),
      sunlight_(Channels<Level>::level(Channels<Level>::of(water.sunlight))),
      one_rate_((water.attenuation_per_m == water.backscatter_per_m).all()),
      forward_share_(water.forward_share) {}

template <class Level>
Lighting<Level>::Lighting(const Water& water, const Camera& camera, const PixelRays& rays,
                          const RigidTransform& T_camera_from_rig)
    : Lighting(water) {
    const Lamps lamps(water);
    const RigidTransform T_rig_from_camera = T_camera_from_rig.inverse();
    const std::vector<double> ranges = ranges_of_table();
    across_ = (camera.width_px + table_step_px - 1) / table_step_px + 1;
    down_ = (camera.height_px + table_step_px - 1) / table_step_px + 1;
    for (int j = 0; j < down_; ++j) {
        for (int i = 0; i < across_; ++i) {
            const int x = std::min(i * table_step_px, camera.width_px);
            const int y = std::min(j * table_step_px, camera.height_px);
            const Eigen::Vector2f slope = *rays.from(x, y);
            const Eigen::Vector3d direction(slope.x(), slope.y(), 1.0);
            const Ray ray{T_rig_from_camera.t_mm, T_rig_from_camera.R * direction.normalized()};
            for (const Lamps::Along& at : lamps.along(ray, ranges)) {
                nodes_.push_back({Channels<Level>::level(Channels<Level>::of(at.kept)),
                                  Channels<Level>::level(Channels<Level>::of(at.veil))});
            }
        }
    }
}

template <class Level>
typename Lighting<Level>::Node Lighting<Level>::node(double x_px, double y_px,
                                                     double range_mm) const {
    const Place x = place_of(x_px / table_step_px, across_);
    const Place y = place_of(y_px / table_step_px, down_);
    const Place z = place_of(
        std::log(std::max(range_mm, nearest_mm) / nearest_mm) / table_log_step(), table_ranges);
    Node sum{Channels<Level>::flat(0.0F), Channels<Level>::flat(0.0F)};
    for (std::size_t corner = 0; corner < 4; ++corner) {
        const std::size_t i = corner % 2;
        const std::size_t j = corner / 2;
        const float weight = (i == 1 ? x.share : 1 - x.share) * (j == 1 ? y.share : 1 - y.share);
        const Node* near =
            nodes_.data() +
            ((y.index + j) * static_cast<std::size_t>(across_) + x.index + i) * table_ranges +
            z.index;
        sum.kept += weight * ((1 - z.share) * near[0].kept + z.share * near[1].kept);
        sum.veil += weight * ((1 - z.share) * near[0].veil + z.share * near[1].veil);
    }
    return sum;
}

template <class Level>
Level Lighting<Level>::seen(const Level& surface, double x_px, double y_px, double range_mm) const {
    if (!nodes_.empty()) {
        const Node at = node(x_px, y_px, range_mm);
        return at.kept * surface + at.veil;
    }
    const Level kept =
        Channels<Level>::level(Channels<Level>::exp(-attenuation_per_m_ * range_mm * 1e-3));
    if (one_rate_) {
        return veil_ + kept * (sunlight_ * surface - veil_);
    }
    const Level open =
        Channels<Level>::level(Channels<Level>::exp(-backscatter_per_m_ * range_mm * 1e-3));
    return kept * (sunlight_ * surface) + (1.0F - open) * veil_;
}

template <class Level>
Level Lighting<Level>::scattered(const Level& surface, double x_px, double y_px,
                                 double range_mm) const {
    // Beyond the cut nothing arrives, and the second factor would grow without bounds.
    const double range_m = 1e-3 * std::min(range_mm, farthest_mm);
    const Rates lost = attenuation_per_m_ * range_m;
    if (nodes_.empty()) {
        const Rates share =
            Channels<Level>::exp(-(1.0 - forward_share_) * lost) - Channels<Level>::exp(-lost);
        return Channels<Level>::level(share) * sunlight_ * surface;
    }
    const Rates gain = Channels<Level>::exp(forward_share_ * lost) - 1.0;
    return node(x_px, y_px, range_mm).kept * Channels<Level>::level(gain) * surface;
}

template <class Level>
Level Lighting<Level>::added(float peak, double x_px, double y_px, double range_mm) const {
    if (nodes_.empty()) {
        const Level above = Channels<Level>::flat(peak) + veil_;
        const Level kept =
            Channels<Level>::level(Channels<Level>::exp(-attenuation_per_m_ * range_mm * 1e-3));
        const Level with = veil_ + kept * (above - veil_);
        return sunlight_ * (with - veil_);
    }
    return peak * node(x_px, y_px, range_mm).kept;
}

template <class Level>
Level Lighting<Level>::endless(double x_px, double y_px) const {
    return nodes_.empty() ? veil_ : node(x_px, y_px, farthest_mm).veil;
}

template class Lighting<float>;
template class Lighting<Colour>;

}  // namespace kambara
