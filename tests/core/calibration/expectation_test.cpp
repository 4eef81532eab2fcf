// SPDX-License-Identifier: GPL-3.0-or-later
// A calibration held against an expected rig, in the same medium or the other one (geometry:
// water): f_w = n f_a, kappa1 less by (1 - 1/n^2) / (2 f_a^2).
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/core/calibration/rig_samples.h"

namespace kambara {
namespace {

using testing_support::options_for;
using testing_support::Showing;
using testing_support::views_of;

Rig without_head(Rig rig) {
    rig.pan_tilt.reset();
    return rig;
}

Rig dry() {
    return without_head(nominal_rig(Medium::air));
}
Rig wet() {
    return without_head(nominal_rig(Medium::water));
}

TsaiLens& lens_of(Camera& camera) {
    return std::get<TsaiLens>(camera.lens);
}

CalibrationReport calibrated(const Rig& truth, Medium said, const Rig& expected) {
    std::mt19937 random(7);
    Showing how;
    how.views = 8;
    how.noise_px = 0.03;
    how.pan_tilt = false;
    const Target target = two_plane_24();
    auto options = options_for(truth, false);
    options.held_out = false;
    options.medium = said;
    options.expected = expected;
    return calibrate_rig(views_of(truth, target, how, random), target, options);
}

bool said(const CalibrationReport& report, const std::string& words) {
    return std::any_of(report.reasons.begin(), report.reasons.end(),
                       [&](const auto& reason) { return reason.find(words) != std::string::npos; });
}

TEST(Expectation, AnHonestCalibrationFitsBothMedia) {
    for (const Rig& expected : {dry(), wet()}) {
        for (const Medium medium : {Medium::air, Medium::water}) {
            const auto report = calibrated(medium == Medium::air ? dry() : wet(), medium, expected);
            EXPECT_NE(report.verdict, Verdict::refused);
            EXPECT_FALSE(said(report, "focal length is"));
            EXPECT_FALSE(said(report, "kappa1"));
            EXPECT_EQ(report.rig.medium, medium);
        }
    }
}

TEST(Expectation, PicturesOfTheOtherMediumAreRefused) {
    struct Case {
        Rig truth;
        Medium said;
        Rig expected;
        const char* due;
    };
    for (const Case& c : {Case{dry(), Medium::water, dry(), "1.335 should be"},
                          Case{dry(), Medium::water, wet(), "1.000 should be"},
                          Case{wet(), Medium::air, dry(), "1.000 should be"},
                          Case{wet(), Medium::air, wet(), "0.749 should be"}}) {
        const auto report = calibrated(c.truth, c.said, c.expected);
        EXPECT_EQ(report.verdict, Verdict::refused);
        EXPECT_TRUE(said(report, c.due));
        EXPECT_TRUE(said(report, "the pictures look taken in the other medium"));
    }
}

TEST(Expectation, AnotherLensIsRefusedAndNotTakenForWater) {
    Rig zoomed = dry();
    lens_of(zoomed.left).f_mm *= 1.15;
    const auto report = calibrated(zoomed, Medium::air, dry());
    EXPECT_EQ(report.verdict, Verdict::refused);
    EXPECT_TRUE(said(report, "The left camera's focal length is 1.1"));
    EXPECT_TRUE(said(report, "another lens, zoom or target size"));
    EXPECT_FALSE(said(report, "The right camera's focal length"));
    EXPECT_FALSE(said(report, "other medium"));
}

TEST(Expectation, FivePercentOfTheFocalLengthIsTheBound) {
    for (const double factor : {0.97, 1.03}) {
        Rig near = dry();
        lens_of(near.left).f_mm *= factor;
        EXPECT_NE(calibrated(dry(), Medium::air, near).verdict, Verdict::refused);
    }
    for (const double factor : {0.93, 1.07}) {
        Rig far = dry();
        lens_of(far.left).f_mm *= factor;
        EXPECT_EQ(calibrated(dry(), Medium::air, far).verdict, Verdict::refused);
    }
}

TEST(Expectation, AnotherKappaIsWarnedOf) {
    Rig expected = dry();
    lens_of(*expected.right).kappa1_per_mm2 += 0.02;
    const auto report = calibrated(dry(), Medium::air, expected);
    EXPECT_NE(report.verdict, Verdict::refused);
    EXPECT_TRUE(said(report, "The right camera's kappa1 is 0.035"));
    EXPECT_TRUE(said(report, "0.055"));
    EXPECT_FALSE(said(report, "The left camera's kappa1"));
    // A lens that bends in water as it did in air had no water before it.
    Rig strange = wet();
    lens_of(strange.left).kappa1_per_mm2 = 0.037709;
    EXPECT_TRUE(said(calibrated(strange, Medium::water, dry()), "The left camera's kappa1 is"));
}

TEST(Expectation, LensesOfOtherKindsAreComparedByWhatTheyBend) {
    Rig truth = dry();
    truth.left.lens = BrownLens(450.0, 450.0, 320.0, 240.0, {-0.10, 0.01, 0.0, 0.0, 0.0});
    truth.right->lens = BrownLens(450.0, 450.0, 320.0, 240.0, {-0.10, 0.01, 0.0, 0.0, 0.0});
    EXPECT_FALSE(said(calibrated(truth, Medium::air, truth), "bends"));
    Rig other = truth;
    other.right->lens = BrownLens(450.0, 450.0, 320.0, 240.0, {-0.25, 0.05, 0.0, 0.0, 0.0});
    const auto report = calibrated(truth, Medium::air, other);
    EXPECT_NE(report.verdict, Verdict::refused);
    EXPECT_TRUE(said(report, "The right camera's lens bends by"));
    EXPECT_FALSE(said(report, "The left camera's lens bends by"));
}

// The expected rig may have been calibrated at another size of the pictures.
TEST(Expectation, HoldsAtAnotherResolution) {
    const auto report = calibrated(dry(), Medium::air, scaled_to(dry(), 320, 240));
    EXPECT_NE(report.verdict, Verdict::refused);
    EXPECT_FALSE(said(report, "kappa1"));
}

}  // namespace
}  // namespace kambara
