// SPDX-License-Identifier: GPL-3.0-or-later
// Coloured pictures of water, end to end.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "hardware/simulated/simulated_world.h"

namespace kambara {
namespace {

SimulatedWorld world_of(const std::string& text) {
    return SimulatedWorld(simulated_profile(text).value());
}

// Mean and standard deviation of a channel in a rectangle.
struct Spread {
    double mean = 0.0;
    double deviation = 0.0;
};

Spread spread_of(const Image& picture, const Rectangle& of, int channel) {
    double sum = 0.0;
    double squares = 0.0;
    for (int y = of.y; y < of.y + of.height; ++y) {
        for (int x = of.x; x < of.x + of.width; ++x) {
            const double value = picture.at(x, y, channel);
            sum += value;
            squares += value * value;
        }
    }
    const double n = of.width * of.height;
    return {sum / n, std::sqrt(std::max(0.0, squares / n - sum / n * sum / n))};
}

TEST(ColourPicture, HasThreeChannelsFromEveryCameraAndItsGreenIsTheGreyPicture) {
    const std::string base = "default?noise=0&water=coastal&lamps=1&seed=4";
    const SimulatedWorld colour(simulated_profile(base + "&colour=1").value());
    const SimulatedWorld grey(simulated_profile(base).value());
    const Image of_colour = colour.picture(FixedCamera::right, 9);
    const Image of_grey = grey.picture(FixedCamera::right, 9);
    ASSERT_EQ(of_colour.channels(), 3);
    ASSERT_EQ(of_grey.channels(), 1);
    EXPECT_EQ(colour.pan_tilt_picture(9, {}).channels(), 3);
    EXPECT_EQ(grey.pan_tilt_picture(9, {}).channels(), 1);
    // But for the target's coloured discs.
    int differing = 0;
    for (int y = 0; y < of_grey.height(); ++y) {
        for (int x = 0; x < of_grey.width(); ++x) {
            differing += std::abs(of_colour.at(x, y, 1) - of_grey.at(x, y)) > 1 ? 1 : 0;
        }
    }
    EXPECT_LT(differing, of_grey.width() * of_grey.height() / 50);
}

TEST(ColourPicture, TheTargetsContrastFallsAsTheBeamDoesInEveryChannel) {
    // The same frame in more and less attenuating water: what is left of the contrast is
    // exp(-c z), as the water between has taken it from each channel.
    const std::string base = "default?noise=0&colour=1&water=clear&forward=0&blur=0&snow=0";
    const SimulatedWorld pure(simulated_profile(base + "&haze=0").value());
    {
        constexpr double haze = 0.25;
        const SimulatedWorld hazy(
            simulated_profile(base + "&haze=" + std::to_string(haze)).value());
        const Rectangle target = pure.suggested_template(61);
        const double range_m = 1e-3 * pure.T_left_from_target(0).t_mm.norm();
        const Water water = water_like(WaterKind::clear, haze, 88.0, 0.0);
        const Image clean = pure.picture(FixedCamera::left, 0);
        const Image dimmed = hazy.picture(FixedCamera::left, 0);
        for (int c = 0; c < 3; ++c) {
            const double left =
                spread_of(dimmed, target, c).deviation / spread_of(clean, target, c).deviation;
            EXPECT_NEAR(left, std::exp(-water.attenuation_per_m[c] * range_m), 0.02)
                << "channel " << c << ", haze " << haze;
        }
    }
}

TEST(ColourPicture, RedDiesBeforeGreenInCoastalWater) {
    const auto world = [](const char* haze) {
        return SimulatedWorld(
            simulated_profile(std::string("default?noise=0&colour=1&water=coastal&snow=0&haze=") +
                              haze)
                .value());
    };
    const SimulatedWorld pure = world("0");
    const SimulatedWorld coastal = world("0.6");
    const Rectangle target = pure.suggested_template(61);
    const Image clean = pure.picture(FixedCamera::left, 0);
    const Image seen = coastal.picture(FixedCamera::left, 0);
    const auto left = [&](int c) {
        return spread_of(seen, target, c).deviation / spread_of(clean, target, c).deviation;
    };
    EXPECT_LT(left(2), 0.85 * left(1));
    EXPECT_LT(left(0), 0.85 * left(1));
}

TEST(ColourPicture, EndlessWaterHasTheVeilsColour) {
    for (const char* name : {"clear", "harbour"}) {
        const WaterKind kind = water_kind(name).value();
        const SimulatedWorld world =
            world_of(std::string("default?noise=0&colour=1&snow=0&water=") + name);
        const Image picture = world.picture(FixedCamera::left, 0);
        const Water water =
            water_like(kind, preset_of(kind).attenuation_per_m, preset_of(kind).veil_grey, 0.0);
        for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(picture.at(320, 4, c), water.veil_grey[c], 1.0) << name;
        }
    }
}

// How fine a picture's detail is: its second differences, per standard deviation.
double fineness(const Image& picture, const Rectangle& of) {
    double sum = 0.0;
    for (int y = of.y; y < of.y + of.height; ++y) {
        for (int x = of.x; x < of.x + of.width; ++x) {
            sum += std::abs(picture.at(x - 1, y) - 2.0 * picture.at(x, y) + picture.at(x + 1, y));
        }
    }
    return sum / (of.width * of.height) / spread_of(picture, of, 0).deviation;
}

TEST(ColourPicture, ForwardScatterSoftensTheTargetAndBringsBackLight) {
    const std::string base = "default?noise=0&water=coastal&haze=0.8&snow=0&seed=3";
    const SimulatedWorld sharp(simulated_profile(base + "&forward=0&blur=0").value());
    const SimulatedWorld soft(simulated_profile(base + "&forward=0.5&blur=3").value());
    const Rectangle target = sharp.suggested_template(61);
    const Image of_sharp = sharp.picture(FixedCamera::left, 0);
    const Image of_soft = soft.picture(FixedCamera::left, 0);
    EXPECT_GT(spread_of(of_soft, target, 0).mean, spread_of(of_sharp, target, 0).mean + 3.0);
    EXPECT_LT(fineness(of_soft, target), 0.8 * fineness(of_sharp, target));
}

TEST(ColourPicture, IsTheSameInAnyOrderAndInstance) {
    const std::string text = "default?colour=1&water=harbour&lamps=1&seed=6&step=0.3";
    const SimulatedWorld one(simulated_profile(text).value());
    const SimulatedWorld other(simulated_profile(text).value());
    constexpr std::array<std::int64_t, 2> frames{0, 95};
    std::array<Image, 2> forward;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        forward[i] = one.picture(FixedCamera::left, frames[i]);
    }
    for (std::size_t i = frames.size(); i-- > 0;) {
        EXPECT_EQ(other.picture(FixedCamera::left, frames[i]), forward[i]);
    }
    EXPECT_EQ(one.pan_tilt_picture(3, {0.2, 0.1}), other.pan_tilt_picture(3, {0.2, 0.1}));
}

}  // namespace
}  // namespace kambara
