// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pointing/head_axes.h"

#include <gtest/gtest.h>

#include <random>

#include "core/camera/head_model.h"

namespace kambara {
namespace {

constexpr HeadAngles backlash{rad_from_deg(0.4), rad_from_deg(0.25)};

void expect_near(const HeadAngles& a, const HeadAngles& b, double tolerance_rad) {
    EXPECT_NEAR(a.pan_rad, b.pan_rad, tolerance_rad);
    EXPECT_NEAR(a.tilt_rad, b.tilt_rad, tolerance_rad);
}

// After a way longer than the play the side it came from says all.
TEST(HeadAxes, AreWhereTheModelHasThemAfterALongWay) {
    HeadModel model;
    model.pan_backlash_rad = backlash.pan_rad;
    model.tilt_backlash_rad = backlash.tilt_rad;
    HeadAxes axes(backlash);
    axes.see({});
    HeadAngles at{};
    std::mt19937 random(5);
    std::uniform_real_distribution<double> any(-0.4, 0.4);
    for (int i = 0; i < 200; ++i) {
        const HeadAngles next{any(random), any(random)};
        if (std::abs(next.pan_rad - at.pan_rad) < backlash.pan_rad ||
            std::abs(next.tilt_rad - at.tilt_rad) < backlash.tilt_rad) {
            continue;
        }
        const HeadApproach from{next.pan_rad > at.pan_rad ? 1 : -1,
                                next.tilt_rad > at.tilt_rad ? 1 : -1};
        axes.see(next);
        at = next;
        expect_near(axes.at(at), axes_at(model, at, from), 1e-12);
    }
}

TEST(HeadAxes, StandStillWhileTheEncodersCrossThePlay) {
    HeadAxes axes(backlash);
    axes.see({});
    axes.see({0.2, 0.2});
    const HeadAngles stood = axes.at({0.2, 0.2});
    for (const double back : {0.3, 0.6, 0.9}) {
        const HeadAngles encoders{0.2 - back * backlash.pan_rad, 0.2 - back * backlash.tilt_rad};
        axes.see(encoders);
        expect_near(axes.at(encoders), stood, 1e-12);
    }
}

TEST(HeadAxes, EndWhereTheyShouldFromBothSides) {
    HeadAxes axes(backlash);
    HeadAngles encoders{};
    axes.see(encoders);
    std::mt19937 random(6);
    std::uniform_real_distribution<double> any(-0.4, 0.4);
    for (int i = 0; i < 200; ++i) {
        const HeadAngles wanted{any(random), any(random)};
        encoders = axes.encoders_for(wanted);
        axes.see(encoders);
        expect_near(axes.at(encoders), wanted, rad_from_deg(0.06) + 1e-12);
        EXPECT_FALSE(axes.astray(wanted));
        EXPECT_EQ(axes.encoders_for(wanted), encoders) << "there already: it is left alone";
    }
    // It overshot, and was drawn back to where it was told.
    axes.see({encoders.pan_rad + 0.1, encoders.tilt_rad});
    const HeadAngles wanted = axes.at({encoders.pan_rad + 0.1, encoders.tilt_rad});
    axes.see(encoders);
    EXPECT_TRUE(axes.astray(wanted));
}

TEST(HeadAxes, WithoutBacklashAreTheEncoders) {
    HeadAxes axes;
    axes.see({0.1, 0.2});
    axes.see({-0.3, 0.1});
    EXPECT_EQ(axes.at({-0.3, 0.1}), (HeadAngles{-0.3, 0.1}));
    EXPECT_EQ(axes.encoders_for({-0.3001, 0.1}), (HeadAngles{-0.3001, 0.1}));
}

}  // namespace
}  // namespace kambara
