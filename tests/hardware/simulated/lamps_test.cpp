// SPDX-License-Identifier: GPL-3.0-or-later
// Lamps in water against sums over fine slabs, and the table that pictures are drawn from.
#include "hardware/simulated/lamps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/camera/nominal_rig.h"
#include "hardware/simulated/lighting.h"

namespace kambara {
namespace {

using Eigen::Array3d;
using Eigen::Vector3d;

Water preset_water(WaterKind kind) {
    const WaterPreset preset = preset_of(kind);
    return water_like(kind, preset.attenuation_per_m, preset.veil_grey, preset.forward_share);
}

const Vector3d ahead_mm(225.0, 100.0, 1500.0);

TEST(Lamps, ATargetAMetreAndAHalfAwayKeepsItsGrey) {
    for (const WaterKind kind : {WaterKind::grey, WaterKind::clear, WaterKind::coastal}) {
        EXPECT_NEAR(Lamps(preset_water(kind)).light_at(ahead_mm)[1], 1.0, 1e-12);
    }
    EXPECT_LT(Lamps(preset_water(WaterKind::harbour)).light_at(ahead_mm)[1], 1.0)
        << "the camera is stopped down";
}

TEST(Lamps, LightFallsWithTheSquareAndTheBeam) {
    // Far out on the axis between the lamps both are as good as on theirs.
    const Water water = preset_water(WaterKind::clear);
    const Lamps lamps(water);
    const Vector3d direction = ahead_mm.normalized();
    const auto between = [&](double from_m, double to_m) {
        return Array3d(lamps.light_at(1e3 * to_m * direction) /
                       lamps.light_at(1e3 * from_m * direction));
    };
    const Array3d fall = between(30.0, 40.0);
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(fall[c] / (9.0 / 16.0 * std::exp(-10.0 * water.attenuation_per_m[c])), 1.0,
                    0.03);
    }
    EXPECT_LT(lamps.light_at({225.0, 100.0, -500.0})[1], 1e-3) << "nothing goes backwards";
}

TEST(Lamps, TheVeilIsTheSumOfItsSlabs) {
    const Water water = preset_water(WaterKind::coastal);
    const Lamps lamps(water);
    const Ray ray{{0, 0, 0}, Vector3d(-0.2, -0.1, 1.0).normalized()};
    const double range_mm = 3000.0;
    // Plainly: many thin slabs, each lit as its middle.
    Array3d sum = Array3d::Zero();
    constexpr int slabs = 30000;
    for (int i = 0; i < slabs; ++i) {
        const double s_mm = (i + 0.5) * range_mm / slabs;
        sum += water.backscatter_per_m * water.veil_grey / water.sunlight *
               lamps.light_at(ray.at(s_mm)) * (-1e-3 * s_mm * water.backscatter_per_m).exp() *
               (1e-3 * range_mm / slabs);
    }
    std::vector<double> ranges_mm;
    for (double s_mm = 30.0; s_mm < range_mm; s_mm *= 1.09) {
        ranges_mm.push_back(s_mm);
    }
    ranges_mm.push_back(range_mm);
    const auto along = lamps.along(ray, ranges_mm);
    const Array3d kept =
        lamps.light_at(ray.at(range_mm)) * (-1e-3 * range_mm * water.attenuation_per_m).exp();
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(along.back().veil[c] / sum[c], 1.0, 0.01);
        EXPECT_NEAR(along.back().kept[c], kept[c], 1e-12);
    }
    // What lies between 0.3 and 2 m makes most of it.
    const auto near = lamps.along(ray, {300.0, 400.0, 600.0, 900.0, 1300.0, 2000.0});
    EXPECT_GT(near.back().veil[1] - near.front().veil[1], 0.75 * along.back().veil[1]);
}

TEST(Lamps, TheTableGivesWhatTheRaysDo) {
    const Rig rig = nominal_rig(Medium::water);
    const Water water = preset_water(WaterKind::coastal);
    const Lamps lamps(water);
    for (const Camera* camera : {&rig.left, &*rig.right}) {
        const PixelRays rays(*camera);
        const Lighting<Colour> light(water, *camera, rays, camera->T_camera_from_rig);
        for (const auto& [x, y] : {std::pair(20, 15), {333, 251}, {600, 100}, {639, 479}}) {
            const Ray ray = camera->unproject(Eigen::Vector2d(x, y)).value();
            std::vector<double> ranges_mm;
            for (double s_mm = 20.0; s_mm < 1650.0; s_mm += 10.0) {
                ranges_mm.push_back(s_mm);
            }
            const Lamps::Along exact = lamps.along(ray, ranges_mm).back();
            const double range_mm = ranges_mm.back();
            const Colour black = light.seen(Colour::Zero(), x, y, range_mm);
            const Colour white = light.seen(Colour::Constant(100.0F), x, y, range_mm);
            for (int c = 0; c < 3; ++c) {
                EXPECT_NEAR(static_cast<double>(black[c]) / exact.veil[c], 1.0, 0.02);
                EXPECT_NEAR(static_cast<double>(white[c] - black[c]) / (100.0 * exact.kept[c]), 1.0,
                            0.02);
            }
        }
    }
}

TEST(Lamps, TheWaterNearbyOutshinesWhatIsFar) {
    const Rig rig = nominal_rig(Medium::water);
    const Water water = preset_water(WaterKind::coastal);
    const PixelRays rays(rig.left);
    const Lighting<float> light(water, rig.left, rays, rig.left.T_camera_from_rig);
    const float veil = light.seen(0.0F, 320, 240, 8000.0);
    EXPECT_GT(veil, 5.0F * (light.seen(200.0F, 320, 240, 8000.0) - veil));
    EXPECT_GT(light.seen(0.0F, 320, 240, 2000.0), 0.8F * veil) << "and saturates early";
}

}  // namespace
}  // namespace kambara
