// SPDX-License-Identifier: GPL-3.0-or-later
// Sunlight in water against the closed forms of the light model.
#include "hardware/simulated/water.h"

#include <gtest/gtest.h>

#include <cmath>

#include "hardware/simulated/lighting.h"

namespace kambara {
namespace {

constexpr WaterKind kinds[] = {WaterKind::grey, WaterKind::clear, WaterKind::coastal,
                               WaterKind::harbour};

Water preset_water(WaterKind kind) {
    const WaterPreset preset = preset_of(kind);
    return water_like(kind, preset.attenuation_per_m, preset.veil_grey, preset.forward_share);
}

// What is left of the difference of two surfaces at a range.
Colour contrast(const Lighting<Colour>& light, double range_mm) {
    return light.seen(Colour::Constant(200.0F), 0, 0, range_mm) -
           light.seen(Colour::Constant(100.0F), 0, 0, range_mm);
}

TEST(Water, PresetsHaveTheirPublishedAttenuation) {
    // At 520 nm; green, 540 nm, differs by Jerlov's curve.
    EXPECT_NEAR(preset_of(WaterKind::clear).attenuation_per_m, 0.0987 * 0.0852 / 0.0776, 1e-9);
    EXPECT_NEAR(preset_of(WaterKind::coastal).attenuation_per_m, 0.35 * 0.196 / 0.208, 1e-9);
    EXPECT_NEAR(preset_of(WaterKind::harbour).attenuation_per_m, 2.0 * 0.702 / 0.846, 1e-9);
    for (const WaterKind kind : kinds) {
        EXPECT_EQ(preset_water(kind).sunlight[1], 1.0);
        EXPECT_NEAR(preset_water(kind).attenuation_per_m[1], preset_of(kind).attenuation_per_m,
                    1e-12);
    }
}

TEST(Water, ColoursDieInTheOrderTheyShould) {
    const Eigen::Array3d clear = preset_water(WaterKind::clear).attenuation_per_m;
    EXPECT_LT(clear[0], clear[1]) << "blue goes farthest";
    EXPECT_LT(3.0 * clear[1], clear[2]);
    const Eigen::Array3d coastal = preset_water(WaterKind::coastal).attenuation_per_m;
    EXPECT_LT(coastal[1], coastal[0]) << "green goes farthest";
    EXPECT_LT(1.5 * coastal[1], coastal[2]);
    const Eigen::Array3d harbour = preset_water(WaterKind::harbour).attenuation_per_m;
    EXPECT_GT(harbour[0], 2.0 * harbour[1]) << "blue dies first";
}

TEST(Lighting, ContrastFallsAsTheBeamDoes) {
    for (const WaterKind kind : kinds) {
        const Water water = preset_water(kind);
        const Lighting<Colour> light(water);
        const Colour near = contrast(light, 0.0);
        for (const double range_mm : {300.0, 1500.0, 4000.0}) {
            const Colour far = contrast(light, range_mm);
            for (int c = 0; c < 3; ++c) {
                EXPECT_NEAR(static_cast<double>(far[c] / near[c]),
                            std::exp(-water.attenuation_per_m[c] * range_mm * 1e-3), 1e-4);
            }
        }
    }
}

TEST(Lighting, TheVeilClosesTowardsEndlessWater) {
    for (const WaterKind kind : kinds) {
        const Water water = preset_water(kind);
        const Lighting<Colour> light(water);
        for (const double range_mm : {500.0, 2000.0}) {
            const Colour black = light.seen(Colour::Zero(), 0, 0, range_mm);
            for (int c = 0; c < 3; ++c) {
                EXPECT_NEAR(static_cast<double>(black[c]),
                            water.veil_grey[c] *
                                (1.0 - std::exp(-water.backscatter_per_m[c] * range_mm * 1e-3)),
                            1e-3);
            }
        }
        const Colour far = light.seen(Colour::Constant(200.0F), 0, 0, 500e3);
        EXPECT_TRUE((far - water.veil_grey.cast<float>()).abs().maxCoeff() < 1e-3F);
        EXPECT_TRUE((light.endless(0, 0) - water.veil_grey.cast<float>()).abs().maxCoeff() < 1e-3F);
    }
}

TEST(Lighting, WhatIsScatteredForwardIsAShareOfWhatIsLost) {
    Water water = preset_water(WaterKind::coastal);
    const double range_m = 2.5;
    for (const double share : {0.0, 0.4, 1.0}) {
        water.forward_share = share;
        const Lighting<Colour> light(water);
        const Colour scattered = light.scattered(Colour::Constant(150.0F), 0, 0, 1e3 * range_m);
        for (int c = 0; c < 3; ++c) {
            const double lost = water.attenuation_per_m[c] * range_m;
            EXPECT_NEAR(
                static_cast<double>(scattered[c]),
                150.0 * water.sunlight[c] * (std::exp(-(1.0 - share) * lost) - std::exp(-lost)),
                1e-3);
        }
    }
}

TEST(Lighting, GreyIsTheGreenOfColour) {
    for (const WaterKind kind : kinds) {
        const Water water = preset_water(kind);
        const Lighting<Colour> colour(water);
        const Lighting<float> grey(water);
        EXPECT_FLOAT_EQ(grey.seen(120.0F, 0, 0, 1700.0),
                        colour.seen(Colour::Constant(120.0F), 0, 0, 1700.0)[1]);
        EXPECT_FLOAT_EQ(grey.scattered(120.0F, 0, 0, 1700.0),
                        colour.scattered(Colour::Constant(120.0F), 0, 0, 1700.0)[1]);
        EXPECT_NEAR(grey.added(50.0F, 0, 0, 1700.0), colour.added(50.0F, 0, 0, 1700.0)[1], 1e-4F);
    }
}

}  // namespace
}  // namespace kambara
