// SPDX-License-Identifier: GPL-3.0-or-later
#include "hardware/simulated/snow.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <string>
#include <vector>

#include "hardware/simulated/simulated_world.h"

namespace kambara {
namespace {

SimulatedProfile profile_of(const std::string& text) {
    return simulated_profile(text).value();
}

TEST(Snow, IsAsDenseAsToldAndFallsWithTheFourthPowerOfSize) {
    const Snow snow(10.0, 3);
    const auto count = static_cast<double>(snow.flakes().size());
    EXPECT_NEAR(count / Snow::box_litres(), 10.0, 0.001);
    const auto thicker_than = [&](double diameter_mm) {
        return static_cast<double>(
            std::count_if(snow.flakes().begin(), snow.flakes().end(), [&](const Flake& flake) {
                return static_cast<double>(flake.diameter_mm) > diameter_mm;
            }));
    };
    EXPECT_EQ(thicker_than(Snow::thinnest_mm - 1e-3), count);
    EXPECT_EQ(thicker_than(Snow::thickest_mm + 1e-3), 0.0);
    // The histogram's slope on logarithmic axes, over one octave and two.
    const auto density = [&](double from_mm, double to_mm) {
        return (thicker_than(from_mm) - thicker_than(to_mm)) / (to_mm - from_mm);
    };
    EXPECT_NEAR(std::log2(density(1.0, 1.1) / density(0.5, 0.55)), -4.0, 0.15);
    EXPECT_NEAR(0.5 * std::log2(density(2.0, 2.2) / density(0.5, 0.55)), -4.0, 0.15);
}

TEST(Snow, DriftsSteadilyInsideItsBox) {
    const Snow snow(0.05, 1);
    Eigen::Vector3f low = Eigen::Vector3f::Constant(1e9F);
    Eigen::Vector3f high = -low;
    double drift_mm_s = 0.0;
    for (const Flake& flake : snow.flakes()) {
        for (const double time_s : {0.0, 12.0, 5000.0}) {
            const Eigen::Vector3f place = Snow::place_mm(flake, time_s);
            low = low.cwiseMin(place);
            high = high.cwiseMax(place);
        }
        drift_mm_s +=
            static_cast<double>(flake.drift_mm_s.x()) / static_cast<double>(snow.flakes().size());
    }
    EXPECT_GE(low.z(), 30.0F) << "not inside the camera";
    EXPECT_NEAR((high - low).prod() * 1e-6, Snow::box_litres(), 0.05 * Snow::box_litres());
    EXPECT_NEAR(drift_mm_s, 150.0, 10.0);
}

TEST(Snow, ShowsBeforeATargetAndNotBehindIt) {
    const std::string base = "chessboard?noise=0&particles=0&haze=0";
    const SimulatedProfile profile = profile_of(base + "&snow=3");
    const SimulatedWorld with(profile);
    const SimulatedWorld without(profile_of(base));
    const Scene scene(profile);
    const Camera& camera = with.rig().left;
    const RigidTransform T_target_from_rig = scene.T_rig_from_target(0.0).inverse();
    const Image full = with.picture(FixedCamera::left, 0);
    const Image clear = without.picture(FixedCamera::left, 0);
    int behind = 0;
    int changed_behind = 0;
    int shown_before = 0;
    for (const Flake& flake : scene.snow().flakes()) {
        const Eigen::Vector3d place = Snow::place_mm(flake, 0.0).cast<double>();
        const Eigen::Vector3d on_target = T_target_from_rig * place;
        const auto pixel = camera.project(place);
        if (!pixel || !camera.sees(*pixel) || flake.diameter_mm < 1.5F) {
            continue;
        }
        const int x = static_cast<int>(std::lround(pixel->x()));
        const int y = static_cast<int>(std::lround(pixel->y()));
        // The board's axis looks away from the camera.
        const Ray ray = camera.unproject(*pixel).value();
        const Ray in_target = T_target_from_rig * ray;
        const Eigen::Vector3d hit =
            in_target.at(-in_target.origin_mm.z() / in_target.direction.z());
        const bool over_board =
            hit.x() > 0.0 && hit.x() < 240.0 && hit.y() > 0.0 && hit.y() < 150.0;
        const bool is_before = on_target.z() * in_target.origin_mm.z() > 0.0;
        if (over_board && !is_before) {
            ++behind;
            changed_behind += full.at(x, y) != clear.at(x, y) ? 1 : 0;
        } else if (is_before && place.z() > 200.0) {
            shown_before += full.at(x, y) != clear.at(x, y) ? 1 : 0;
        }
    }
    EXPECT_GT(behind, 10);
    EXPECT_LE(changed_behind, behind / 5) << "some lie behind another flake";
    EXPECT_GT(shown_before, 10);
}

// By geometry: what share of the template the discs of thick flakes cover, in the densest snow.
TEST(Snow, HidesATemplateForAFewFramesNowAndThen) {
    const SimulatedWorld world(profile_of("default?medium=water"));
    const Camera& camera = world.rig().left;
    const double f_px = pinhole_parameters(camera.lens).fx_px;
    const Snow snow(100.0, 2);
    std::vector<Flake> thick;
    std::copy_if(snow.flakes().begin(), snow.flakes().end(), std::back_inserter(thick),
                 [](const Flake& flake) { return flake.diameter_mm > 1.2F; });
    constexpr int frames = 900;
    int times = 0;
    int longest = 0;
    int run = 0;
    for (int frame = 0; frame < frames; ++frame) {
        const Rectangle place = world.suggested_template(31, frame);
        double hidden_share = 0.0;
        for (const Flake& flake : thick) {
            const Eigen::Vector3d at = Snow::place_mm(flake, frame / 30.0).cast<double>();
            const double radius_px = 0.5 * static_cast<double>(flake.diameter_mm) * f_px / at.z();
            if (radius_px < 4.0) {
                continue;
            }
            const auto pixel = camera.project(at);
            if (pixel && std::abs(pixel->x() - place.centre_x_px()) < 18.0 &&
                std::abs(pixel->y() - place.centre_y_px()) < 18.0) {
                hidden_share += 3.14 * radius_px * radius_px / (31.0 * 31.0);
            }
        }
        const bool is_hidden = hidden_share > 0.1;
        times += is_hidden && run == 0 ? 1 : 0;
        run = is_hidden ? run + 1 : 0;
        longest = std::max(longest, run);
    }
    std::printf("a tenth of the template and more hidden %d times, at most %d frames\n", times,
                longest);
    EXPECT_GE(times, 4);
    EXPECT_LE(longest, 5);
}

}  // namespace
}  // namespace kambara
