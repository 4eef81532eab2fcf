// SPDX-License-Identifier: GPL-3.0-or-later
#include "hardware/simulated/lamps.h"

#include <algorithm>
#include <cmath>

#include "core/base/angles.h"

namespace kambara {
namespace {

using Eigen::Array3d;
using Eigen::Vector3d;

// Off the cameras' axes, which lie at x = 0 and 450: what is near the cameras gets little light.
const Vector3d lamp_places_mm[] = {{-500.0, -200.0, 0.0}, {950.0, -200.0, 0.0}};
const Vector3d aimed_at_mm(225.0, 100.0, 1500.0);
constexpr double brightest_veil_grey = 100.0;
constexpr double beam_sigma_rad = rad_from_deg(20.0);

}  // namespace

Lamps::Lamps(const Water& water) : water_(water) {
    scale_ = 1.0 / light_at(aimed_at_mm)[1];
    std::vector<double> ranges_mm;
    for (double range_mm = 50.0; range_mm < 10000.0; range_mm *= 1.1) {
        ranges_mm.push_back(range_mm);
    }
    const double veil =
        along({{0.0, 0.0, 0.0}, aimed_at_mm.normalized()}, ranges_mm).back().veil[1];
    scale_ *= std::min(1.0, brightest_veil_grey / std::max(veil, 1e-9));
}

Array3d Lamps::light_at(const Vector3d& point_in_rig_mm) const {
    Array3d sum = Array3d::Zero();
    for (const Vector3d& place : lamp_places_mm) {
        const Vector3d way = point_in_rig_mm - place;
        const double distance_m = std::max(0.05, 1e-3 * way.norm());
        const double cosine = 1e-3 * way.dot((aimed_at_mm - place).normalized()) / distance_m;
        const double off_axis = std::acos(std::clamp(cosine, -1.0, 1.0)) / beam_sigma_rad;
        const double pattern = std::exp(-0.5 * off_axis * off_axis);
        sum += pattern / (distance_m * distance_m) * (-distance_m * water_.attenuation_per_m).exp();
    }
    return scale_ * sum;
}

std::vector<Lamps::Along> Lamps::along(const Ray& ray, const std::vector<double>& ranges_mm) const {
    // In sunlight, which is the same everywhere, the same sum is B (1 - exp(-b z)).
    const Array3d sent_back_per_m = water_.backscatter_per_m * water_.veil_grey / water_.sunlight;
    std::vector<Along> along;
    along.reserve(ranges_mm.size());
    Array3d veil = Array3d::Zero();
    Array3d before = Array3d::Zero();  // lamps light nothing at the camera's own window
    double before_m = 0.0;
    for (const double range_mm : ranges_mm) {
        const double range_m = 1e-3 * range_mm;
        const Array3d light = light_at(ray.at(range_mm));
        const Array3d here = sent_back_per_m * light * (-range_m * water_.backscatter_per_m).exp();
        veil += 0.5 * (range_m - before_m) * (before + here);
        along.push_back({light * (-range_m * water_.attenuation_per_m).exp(), veil});
        before = here;
        before_m = range_m;
    }
    return along;
}

}  // namespace kambara
