// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/stereo/rig_watch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/base/angles.h"
#include "core/camera/nominal_rig.h"

namespace kambara {
namespace {

constexpr double rate_hz = 30.0;

// A rig file that says that its calibration left nothing.
Rig exact_rig() {
    Rig rig = nominal_rig();
    rig.provenance.stereo_rms_px = 0.0;
    return rig;
}

std::int64_t time_of(int frame) {
    return static_cast<std::int64_t>(frame * 1e9 / rate_hz);
}

// Offsets as matches leave them: noise from frame to frame, an error that goes with the place and
// changes slowly, and now and then a match that is wrong.
class Matches {
  public:
    explicit Matches(unsigned seed) : random_(seed) {}
    EpipolarOffset next(double moved_px = 0.0) {
        std::uniform_real_distribution<double> unit(0.0, 1.0);
        slow_ += 0.05 * (0.04 * normal_(random_) - slow_);
        const double wrong = unit(random_) < 0.03 ? 1.5 * normal_(random_) : 0.0;
        return {moved_px + slow_ + 0.05 * normal_(random_) + wrong, 0.03, std::nullopt};
    }

  private:
    std::mt19937 random_;
    std::normal_distribution<double> normal_;
    double slow_ = 0.0;
};

TEST(RigWatch, StaysQuietForAnHourOfOrdinaryMatches) {
    RigWatch watch(exact_rig());
    Matches matches(1);
    double largest_px = 0.0;
    for (int i = 0; i < 60 * 60 * 30; ++i) {
        watch.add(time_of(i), matches.next());
        if (watch.state()) {
            ASSERT_FALSE(watch.state()->moved) << rig_moved_text(*watch.state());
            largest_px = std::max(largest_px, std::abs(watch.state()->offset_px));
        }
    }
    std::printf("largest median in an hour: %.3f px\n", largest_px);
    EXPECT_GT(largest_px, 0.0);
}

// 0.05 degrees of the right camera, 0.33 px.
TEST(RigWatch, NoticesAKnockWithinSecondsAndSaysWhichWay) {
    const double focal_px = pinhole_parameters(nominal_rig().right->lens).fy_px;
    for (const double turn_deg : {0.05, -0.05}) {
        const double px = focal_px * std::tan(rad_from_deg(turn_deg));
        for (unsigned seed = 0; seed < 20; ++seed) {
            RigWatch watch(exact_rig());
            Matches matches(seed);
            int frame = 0;
            for (; frame < 300; ++frame) {
                watch.add(time_of(frame), matches.next());
            }
            ASSERT_FALSE(watch.state()->moved);
            int noticed = -1;
            for (; frame < 600; ++frame) {
                watch.add(time_of(frame), matches.next(px));
                if (noticed < 0 && watch.state()->moved) {
                    noticed = frame - 300;
                }
            }
            ASSERT_GE(noticed, 0);
            EXPECT_LT(noticed / rate_hz, 4.0);
            EXPECT_NEAR(deg_from_rad(watch.state()->turn_rad), turn_deg, 0.01);
            const std::string text = rig_moved_text(*watch.state());
            EXPECT_NE(text.find(turn_deg > 0.0 ? "below" : "above"), std::string::npos) << text;
            EXPECT_NE(text.find("calibrate"), std::string::npos);
        }
    }
}

TEST(RigWatch, IsRestoredWhenTheCamerasComeBack) {
    RigWatch watch(exact_rig());
    Matches matches(2);
    for (int i = 0; i < 200; ++i) {
        watch.add(time_of(i), matches.next(0.5));
    }
    EXPECT_TRUE(watch.state()->moved);
    for (int i = 200; i < 500; ++i) {
        watch.add(time_of(i), matches.next());
    }
    EXPECT_FALSE(watch.state()->moved);
    watch.reset();
    EXPECT_FALSE(watch.state());
}

TEST(RigWatch, SaysNothingByFewMatchesOrOldOnes) {
    RigWatch watch(exact_rig());
    Matches matches(3);
    for (int i = 0; i < 19; ++i) {
        watch.add(time_of(i), matches.next(3.0));
        EXPECT_FALSE(watch.state());
    }
    watch.add(time_of(10000), matches.next(3.0));  // the others are past
    EXPECT_FALSE(watch.state());
}

TEST(RigWatch, BeginsAnewAfterAGap) {
    RigWatch watch(exact_rig());
    Matches matches(5);
    for (int i = 0; i < 120; ++i) {
        watch.add(time_of(i), matches.next(0.5));
    }
    ASSERT_TRUE(watch.state() && watch.state()->moved);
    // Set right in the meantime but for less than the verdict needs; more than it takes to keep it.
    for (int i = 1000; i < 1120; ++i) {
        watch.add(time_of(i), matches.next(0.15));
    }
    ASSERT_TRUE(watch.state());
    EXPECT_GT(watch.state()->offset_px, 0.5 * 4.0 * watch.state()->sigma_px);
    EXPECT_FALSE(watch.state()->moved);
}

// A calibration that is known badly leaves more; a rig file that tells its residuals says so too.
TEST(RigWatch, WeighsWhatTheCalibrationLeavesOpen) {
    Rig rig = nominal_rig();
    rig.provenance.stereo_rms_px = 0.3;
    RigWatch by_rms(rig);
    RigWatch by_covariance(exact_rig());
    RigWatch exact(exact_rig());
    Matches matches(4);
    for (int i = 0; i < 100; ++i) {
        EpipolarOffset match = matches.next(0.5);
        by_rms.add(time_of(i), match);
        exact.add(time_of(i), match);
        match.calibration_sigma_px = 0.2;
        by_covariance.add(time_of(i), match);
    }
    EXPECT_TRUE(exact.state()->moved);
    EXPECT_FALSE(by_rms.state()->moved);
    EXPECT_FALSE(by_covariance.state()->moved);
}

}  // namespace
}  // namespace kambara
