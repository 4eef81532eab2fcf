// SPDX-License-Identifier: GPL-3.0-or-later
// Rigs calibrated from rendered pictures, whose corners the detector finds.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/camera/nominal_rig.h"
#include "tests/core/calibration/rig_samples.h"
#include "tests/core/calibration/working_volume.h"
#include "tests/support/detected_views.h"

namespace kambara {
namespace {

using testing_support::detected_views;
using testing_support::options_for;
using testing_support::range_errors;
using testing_support::RangeErrors;
using testing_support::shown_targets;

// Thirty views of the target by three cameras, no tape. What a rig that was found makes of ranges
// over the working volume, from exact picture points and from ones with noise.
void calibrate_from_pictures(unsigned first_seed, unsigned seeds) {
    const Rig truth = nominal_rig();
    double worst_baseline = 0.0;
    double worst_head_mm = 0.0;
    RangeErrors exact;
    RangeErrors noisy;
    for (unsigned seed = first_seed; seed < first_seed + seeds; ++seed) {
        const auto views = detected_views(shown_targets(truth, 30, seed), two_plane_24());
        auto options = options_for(truth);
        options.held_out = false;
        const auto report = calibrate_rig(views, two_plane_24(), options);
        ASSERT_EQ(report.verdict, Verdict::good) << "seed " << seed << ": " << report.reasons.at(0);
        worst_baseline =
            std::max(worst_baseline, std::abs(report.pairs[1]->baseline_mm / 450.0 - 1.0));
        std::mt19937 random(seed);
        const RangeErrors e = range_errors(truth, report.rig, 0.0, random);
        const RangeErrors n = range_errors(truth, report.rig, 0.05, random);
        exact = {std::max(exact.mean, e.mean), std::max(exact.worst, e.worst)};
        noisy = {std::max(noisy.mean, n.mean), std::max(noisy.worst, n.worst)};
        const Eigen::Vector3d head = report.rig.pan_tilt->T_camera_from_rig.centre_mm();
        worst_head_mm =
            std::max(worst_head_mm, (head - truth.pan_tilt->T_camera_from_rig.centre_mm()).norm());
    }
    std::printf(
        "baseline %.4f %%; range mean %.4f worst %.4f %%; with noise %.4f, %.4f %%; head %.2f mm\n",
        100 * worst_baseline, 100 * exact.mean, 100 * exact.worst, 100 * noisy.mean,
        100 * noisy.worst, worst_head_mm);
    EXPECT_LT(worst_baseline, 0.0005);
    EXPECT_LT(exact.mean, 0.0005);
    EXPECT_LT(exact.worst, 0.0015);
    EXPECT_LT(noisy.mean, 0.001);
    EXPECT_LT(noisy.worst, 0.004);
    EXPECT_LT(worst_head_mm, 1.0);
}

TEST(DetectedRig, ThreeCamerasMeasureTheWorkingVolume) {
    calibrate_from_pictures(100, 1);
}

TEST(DetectedRigSlow, ThreeCamerasMeasureTheWorkingVolumeWithTwentySeeds) {
    calibrate_from_pictures(100, 20);
}

// Sharp pictures pass; the same ones out of focus are warned about, or refused for that reason.
void blur_pictures(unsigned first_seed, unsigned sets) {
    const Rig truth = nominal_rig();
    auto options = options_for(truth, false);
    options.held_out = false;
    for (unsigned seed = first_seed; seed < first_seed + sets; ++seed) {
        const auto shown = shown_targets(truth, 8, seed, 10.0, 2.0);
        const auto report =
            calibrate_rig(detected_views(shown, two_plane_24()), two_plane_24(), options);
        std::string all;
        for (const std::string& reason : report.reasons) {
            all += reason + "\n";
        }
        for (const RejectedView& view : report.views_rejected) {
            all += view.reason + "\n";
        }
        EXPECT_NE(report.verdict, Verdict::good) << "seed " << seed;
        EXPECT_NE(all.find("blurred"), std::string::npos)
            << "seed " << seed << ": " << to_string(report.verdict) << "\n"
            << all;
    }
}

TEST(DetectedRig, BlurredPicturesAreWarnedOf) {
    blur_pictures(400, 2);
}

TEST(DetectedRigSlow, FiftyBlurredSetsAreWarnedOf) {
    blur_pictures(400, 50);
}

}  // namespace
}  // namespace kambara
