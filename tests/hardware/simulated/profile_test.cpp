// SPDX-License-Identifier: GPL-3.0-or-later
#include "hardware/simulated/simulated_profile.h"

#include <gtest/gtest.h>

#include <string>

namespace kambara {
namespace {

TEST(SimulatedProfile, ReadsItsKeys) {
    const auto profile = simulated_profile(
        "default?seed=3&noise=1.5&particles=0&haze=0&medium=water&frames=300&rate=25"
        "&blur=0.8&step=0.4&swap=5");
    ASSERT_TRUE(profile.ok()) << profile.error().text();
    EXPECT_EQ(profile->name, "default");
    EXPECT_EQ(profile->seed, 3U);
    EXPECT_EQ(profile->noise_grey, 1.5);
    EXPECT_EQ(profile->particles, 0);
    EXPECT_EQ(profile->haze_per_m, 0.0);
    EXPECT_EQ(profile->medium, Medium::water);
    EXPECT_EQ(profile->frames, 300);
    EXPECT_EQ(profile->rate_hz, 25.0);
    EXPECT_EQ(profile->blur_px, 0.8);
    EXPECT_EQ(profile->step, 0.4);
    EXPECT_EQ(profile->swap_s, 5.0);
    EXPECT_FALSE(profile->calibration_target);
}

TEST(SimulatedProfile, AKindOfWaterSetsWhatIsNotSaid) {
    const auto coastal = simulated_profile("default?water=coastal");
    ASSERT_TRUE(coastal.ok()) << coastal.error().text();
    EXPECT_EQ(coastal->medium, Medium::water);
    EXPECT_NEAR(coastal->haze_per_m, 0.33, 0.01);
    EXPECT_GT(coastal->snow_per_litre, 0.0);
    EXPECT_GT(coastal->forward_share, 0.0);
    EXPECT_EQ(coastal->particles, 0);
    EXPECT_FALSE(coastal->colour);
    EXPECT_FALSE(coastal->lamps);
    const auto own = simulated_profile(
        "default?haze=0.7&medium=air&veil=50&forward=0.1&blur=3&snow=0&water=harbour&particles=9"
        "&colour=1&lamps=1");
    ASSERT_TRUE(own.ok()) << own.error().text();
    EXPECT_EQ(own->water, WaterKind::harbour);
    EXPECT_EQ(own->medium, Medium::air);
    EXPECT_EQ(own->haze_per_m, 0.7);
    EXPECT_EQ(own->veil_grey, 50.0);
    EXPECT_EQ(own->forward_share, 0.1);
    EXPECT_EQ(own->blur_px, 3.0);
    EXPECT_EQ(own->snow_per_litre, 0.0);
    EXPECT_EQ(own->particles, 9);
    EXPECT_TRUE(own->colour);
    EXPECT_TRUE(own->lamps);
}

TEST(SimulatedProfile, ShowsCalibrationTargets) {
    EXPECT_EQ(simulated_profile("chessboard")->calibration_target,
              Target(ChessboardTarget{9, 6, 30.0}));
    EXPECT_EQ(simulated_profile("chessboard?target=chessboard:7x5:40")->calibration_target,
              Target(ChessboardTarget{7, 5, 40.0}));
    EXPECT_EQ(simulated_profile("two-plane-24")->calibration_target, Target(two_plane_24()));
}

TEST(SimulatedProfile, RefusesWhatItDoesNotKnowAndSaysWhatThereIs) {
    for (const char* text : {"",
                             "ocean",
                             "default?depth=3",
                             "default?seed",
                             "default?seed=",
                             "default?seed=-1",
                             "default?seed=4294967296",
                             "default?noise=nan",
                             "default?haze=inf",
                             "default?rate=0",
                             "default?rate=1e9",
                             "default?frames=0",
                             "default?particles=1e3",
                             "default?medium=oil",
                             "default?water=grey",
                             "default?colour=2",
                             "default?lamps=yes",
                             "default?forward=1.1",
                             "default?veil=300",
                             "default?snow=101",
                             "default?noise=1&&seed=2",
                             "default?noise=1 ",
                             "default?target=chessboard:9x6:30",
                             "chessboard?target=chessboard:1x1:30"}) {
        const auto profile = simulated_profile(text);
        ASSERT_FALSE(profile.ok()) << text;
        EXPECT_NE(profile.error().remedy.find("two-plane-24"), std::string::npos) << text;
        EXPECT_NE(profile.error().remedy.find("medium"), std::string::npos) << text;
    }
    const auto absurd = simulated_profile("default?rate=-5");
    EXPECT_NE(absurd.error().cause.find("\"rate=-5\""), std::string::npos);
    EXPECT_NE(absurd.error().cause.find("0.1"), std::string::npos) << "the limits are named";
}

}  // namespace
}  // namespace kambara
