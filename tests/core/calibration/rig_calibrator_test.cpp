// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/rig_calibrator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/geometry/triangulate.h"
#include "tests/core/calibration/rig_samples.h"
#include "tests/core/calibration/working_volume.h"

namespace kambara {
namespace {

using testing_support::options_for;
using testing_support::range_errors;
using testing_support::RangeErrors;
using testing_support::Showing;
using testing_support::views_of;

const ChessboardTarget board{9, 6, 30.0};

// Two cameras with lenses of Brown's kind, 120 mm apart.
Rig chessboard_rig() {
    const Camera left{
        BrownLens(520.0, 522.0, 318.0, 243.0, {-0.25, 0.08, 0.001, -0.0005, 0.0}), 640, 480, {}};
    const Camera right{
        BrownLens(530.0, 529.0, 325.0, 238.0, {-0.27, 0.10, -0.0008, 0.0004, 0.0}), 640, 480, {}};
    return rig_from_pair(
        left, right,
        {rotation_about_y(rad_from_deg(4.0)) * rotation_about_x(rad_from_deg(-1.0)),
         {-120.0, 2.0, 3.0}});
}

Showing boards(int views, double noise_px) {
    Showing how;
    how.views = views;
    how.noise_px = noise_px;
    how.nearest_mm = 350.0;
    how.farthest_mm = 750.0;
    how.turn_deg = 35.0;
    return how;
}

std::vector<RigView> board_views(int views, double noise_px, unsigned seed) {
    std::mt19937 random(seed);
    Rig rig = chessboard_rig();
    std::vector<RigView> all;
    const Target target = board;
    while (static_cast<int>(all.size()) < views) {
        // The board stands before the middle of this narrower rig.
        RigidTransform T = testing_support::random_pose(target, boards(1, noise_px), random);
        T.t_mm -= Eigen::Vector3d(165.0, 0.12 * T.t_mm.z(), 0.0);
        RigView view;
        view.sights[0].corners = testing_support::seen_by(rig.left, target, T, noise_px, random);
        view.sights[1].corners = testing_support::seen_by(*rig.right, target, T, noise_px, random);
        if (!view.sights[0].corners.empty() && !view.sights[1].corners.empty()) {
            all.push_back(std::move(view));
        }
    }
    return all;
}

CalibrationReport calibrated(const std::vector<RigView>& views) {
    return calibrate_rig(views, board, options_for(chessboard_rig()));
}

bool said(const CalibrationReport& report, const std::string& words) {
    return std::any_of(report.reasons.begin(), report.reasons.end(),
                       [&](const auto& reason) { return reason.find(words) != std::string::npos; });
}

TEST(RigCalibrator, FindsTheTruthExactlyWithoutNoise) {
    const auto report = calibrated(board_views(9, 0.0, 1));
    ASSERT_NE(report.verdict, Verdict::refused);
    EXPECT_LT(*report.stereo_rms_px, 1e-4);
    const auto& left = std::get<BrownLens>(report.cameras[0]->camera.lens);
    EXPECT_NEAR(left.fx_px(), 520.0, 1e-2);
    EXPECT_NEAR(left.distortion()[0], -0.25, 1e-4);
    EXPECT_NEAR(report.pairs[1]->baseline_mm, baseline_mm(chessboard_rig()), 1e-3);
}

// Errors are as large as the deviations say: mean square 1 in units of the predicted variance.
TEST(RigCalibrator, TellsItsOwnUncertainty) {
    const Rig truth = chessboard_rig();
    double squares = 0.0;
    int terms = 0;
    for (unsigned seed = 20; seed < 28; ++seed) {
        const auto report = calibrated(board_views(8, 0.15, seed));
        ASSERT_NE(report.verdict, Verdict::refused);
        EXPECT_NEAR(*report.stereo_rms_px, 0.15 * std::sqrt(2.0), 0.02);
        const auto& found = std::get<BrownLens>(report.cameras[0]->camera.lens).parameters();
        const auto& true_lens = std::get<BrownLens>(truth.left.lens).parameters();
        for (const std::size_t i : {0U, 1U, 2U, 3U}) {
            const double sigma = report.cameras[0]->parameters[i].sigma;
            squares += std::pow((found[i] - true_lens[i]) / sigma, 2);
            ++terms;
        }
        squares += std::pow((report.pairs[1]->baseline_mm - baseline_mm(truth)) /
                                report.pairs[1]->baseline_sigma_mm,
                            2);
        ++terms;
    }
    EXPECT_NEAR(squares / terms, 1.0, 0.6);
}

TEST(RigCalibrator, GivesTheSameDigitsAgain) {
    const auto views = board_views(7, 0.1, 5);
    const auto a = calibrated(views);
    const auto b = calibrated(views);
    EXPECT_EQ(a.rms_px, b.rms_px);
    EXPECT_EQ(a.rig.left.lens, b.rig.left.lens);
    EXPECT_EQ(a.pairs[1]->baseline_mm, b.pairs[1]->baseline_mm);
    EXPECT_EQ(a.reasons, b.reasons);
}

TEST(RigCalibrator, PutsTheBoardsOrderRightWhereOneCameraSawItTurned) {
    auto views = board_views(7, 0.05, 3);
    auto& turned = views[2].sights[1].corners;
    std::reverse(turned.begin(), turned.end());
    for (std::size_t i = 0; i < turned.size(); ++i) {
        turned[i].id = static_cast<int>(i);
    }
    const auto report = calibrated(views);
    EXPECT_EQ(report.views_used, 7);
    EXPECT_LT(*report.stereo_rms_px, 0.1);
}

TEST(RigCalibrator, LeavesOutAViewThatDoesNotFitAndSaysSo) {
    auto views = board_views(9, 0.05, 4);
    std::mt19937 random(40);
    std::normal_distribution<double> blur(0.0, 4.0);
    for (DetectedCorner& corner : views[5].sights[1].corners) {
        corner.px += Eigen::Vector2d(blur(random), blur(random));
    }
    const auto report = calibrated(views);
    ASSERT_EQ(report.views_rejected.size(), 1U);
    EXPECT_EQ(report.views_rejected[0].view, 5);
    EXPECT_EQ(report.views_rejected[0].camera, "right");
    EXPECT_EQ(report.corners_total, 9 * 54 * 2);
    EXPECT_LT(report.rms_px, 0.1);
    EXPECT_EQ(report.verdict, Verdict::usable);
}

TEST(RigCalibrator, LeavesOutSingleCornersThatDoNotFit) {
    auto views = board_views(9, 0.05, 14);
    views[3].sights[0].corners[20].px.x() += 15.0;
    views[6].sights[1].corners[2].px.y() -= 4.0;
    const auto report = calibrated(views);
    EXPECT_EQ(report.corners_used, 9 * 54 * 2 - 2);
    EXPECT_TRUE(report.views_rejected.empty());
    EXPECT_LT(report.rms_px, 0.1);
}

TEST(RigCalibrator, RefusesTooFewViews) {
    auto views = board_views(2, 0.05, 6);
    views.emplace_back();
    views.back().sights[0].fault = "No chessboard is found.";
    const auto report = calibrated(views);
    EXPECT_EQ(report.verdict, Verdict::refused);
    EXPECT_TRUE(said(report, "Only 2 views"));
    EXPECT_EQ(report.views_rejected.at(0).reason, "No chessboard is found.");
}

TEST(RigCalibrator, RefusesResidualsThatAreTooLarge) {
    EXPECT_EQ(calibrated(board_views(7, 1.5, 7)).verdict, Verdict::refused);
}

TEST(RigCalibrator, WeighsAKnownBaselineAndRefusesOneThatContradictsThePictures) {
    const auto views = board_views(7, 0.1, 8);
    auto options = options_for(chessboard_rig());
    options.baseline = KnownBaseline{140.0, 0.5};
    const auto refused = calibrate_rig(views, board, options);
    EXPECT_EQ(refused.verdict, Verdict::refused);
    EXPECT_TRUE(said(refused, "deviations from the measured 140.00 mm"));
    const double truth_mm = baseline_mm(chessboard_rig());
    options.baseline = KnownBaseline{truth_mm, 0.001};
    const auto report = calibrate_rig(views, board, options);
    EXPECT_NE(report.verdict, Verdict::refused);
    EXPECT_NEAR(report.pairs[1]->baseline_mm, truth_mm, 0.003);  // it fixes the scale
    EXPECT_LT(report.pairs[1]->baseline_sigma_mm, 0.0011);
}

TEST(RigCalibrator, OneCameraAloneIsCalibratedToo) {
    auto options = options_for(chessboard_rig());
    options.cameras[1].reset();
    const auto report = calibrate_rig(board_views(8, 0.05, 9), board, options);
    ASSERT_NE(report.verdict, Verdict::refused);
    EXPECT_FALSE(report.rig.right);
    EXPECT_FALSE(report.stereo_rms_px);
    EXPECT_NEAR(pinhole_parameters(report.rig.left.lens).fx_px, 520.0, 2.0);
}

TEST(RigCalibrator, StopsWhenAsked) {
    std::stop_source stop;
    stop.request_stop();
    const auto report = calibrate_rig(board_views(5, 0.05, 10), board,
                                      options_for(chessboard_rig()), stop.get_token());
    EXPECT_EQ(report.verdict, Verdict::refused);
    EXPECT_TRUE(said(report, "stopped"));
}

// The target's own errors: corners moved by 0.2 mm, and its maker says so.
TEST(RigCalibrator, EstimatesTheTargetsCornersWhereAsked) {
    std::mt19937 random(11);
    std::normal_distribution<double> slip(0.0, 0.2);
    Target real = two_plane_24();
    for (int i = 0; i < 96; ++i) {
        const Eigen::Vector3d drawn = drawn_corners_mm(real)[static_cast<std::size_t>(i)];
        accuracy_of(real).measured.push_back(
            {i, drawn + Eigen::Vector3d(slip(random), slip(random), slip(random)), 0.0});
    }
    Target known = two_plane_24();
    accuracy_of(known).sigma_mm = 0.2;
    Showing how;
    how.views = 12;
    const auto views = views_of(nominal_rig(), real, how, random);
    auto options = options_for(nominal_rig());
    options.held_out = false;
    const auto rigid = calibrate_rig(views, known, options);
    options.estimate_target = true;
    const auto estimated = calibrate_rig(views, known, options);
    EXPECT_GT(rigid.rms_px, 0.085);
    EXPECT_NEAR(estimated.rms_px, 0.05 * std::sqrt(2.0), 0.006);
    EXPECT_NEAR(estimated.pairs[1]->baseline_mm, 450.0, 0.25);
}

// Three cameras, thirty views of the 24-box target; corners as noisy as the detector leaves them,
// no tape.
void measure_the_working_volume(unsigned seeds) {
    const Rig truth = nominal_rig();
    double worst_baseline = 0.0;
    RangeErrors exact;
    RangeErrors noisy;
    for (unsigned seed = 100; seed < 100U + seeds; ++seed) {
        std::mt19937 random(seed);
        auto options = options_for(truth);
        options.held_out = false;
        const auto report =
            calibrate_rig(views_of(truth, two_plane_24(), {}, random), two_plane_24(), options);
        ASSERT_EQ(report.verdict, Verdict::good) << report.reasons.at(0);
        worst_baseline =
            std::max(worst_baseline, std::abs(report.pairs[1]->baseline_mm / 450.0 - 1.0));
        const RangeErrors e = range_errors(truth, report.rig, 0.0, random);
        const RangeErrors n = range_errors(truth, report.rig, 0.05, random);
        exact = {std::max(exact.mean, e.mean), std::max(exact.worst, e.worst)};
        noisy = {std::max(noisy.mean, n.mean), std::max(noisy.worst, n.worst)};
        const Eigen::Vector3d head = report.rig.pan_tilt->T_camera_from_rig.centre_mm();
        EXPECT_LT((head - truth.pan_tilt->T_camera_from_rig.centre_mm()).norm(), 1.0);
    }
    std::printf("baseline %.4f %%; range mean %.4f worst %.4f %%; with noise %.4f, %.4f %%\n",
                100 * worst_baseline, 100 * exact.mean, 100 * exact.worst, 100 * noisy.mean,
                100 * noisy.worst);
    EXPECT_LT(worst_baseline, 0.0005);
    EXPECT_LT(exact.mean, 0.0005);
    EXPECT_LT(exact.worst, 0.0015);
    EXPECT_LT(noisy.mean, 0.001);
    EXPECT_LT(noisy.worst, 0.004);
}

TEST(RigCalibrator, ThreeCamerasMeasureTheWorkingVolume) {
    measure_the_working_volume(3);
}

TEST(RigCalibratorSlow, ThreeCamerasMeasureTheWorkingVolumeWithTwentySeeds) {
    measure_the_working_volume(20);
}

// What the map says of ranges is what happens: errors over many calibrations against its sigmas.
TEST(RigCalibrator, TheRangeErrorMapSaysWhatHappens) {
    const Rig truth = nominal_rig();
    double squares = 0.0;
    int n = 0;
    for (unsigned seed = 200; seed < 210; ++seed) {
        std::mt19937 random(seed);
        Showing how;
        how.views = 10;
        how.noise_px = 0.2;
        auto options = options_for(truth);
        options.held_out = false;
        const auto report =
            calibrate_rig(views_of(truth, two_plane_24(), how, random), two_plane_24(), options);
        ASSERT_FALSE(report.range_errors.empty());
        for (const RangeErrorPoint& place : report.range_errors) {
            // The place in the true left camera's frame.
            const auto l = project(truth.left.lens, place.point_in_left_mm);
            const auto r =
                project(truth.right->lens, T_right_from_left(truth) * place.point_in_left_mm);
            const auto a = report.rig.left.unproject(*l);
            const auto b = report.rig.right->unproject(*r);
            const double error =
                meeting_of(*a, *b)->midpoint_mm.norm() - place.point_in_left_mm.norm();
            squares += std::pow(error / place.sigma_calibration_mm, 2);
            ++n;
        }
    }
    std::printf("mean square of error over sigma %.2f\n", squares / n);
    EXPECT_GT(squares / n, 0.3);
    EXPECT_LT(squares / n, 2.5);
}

}  // namespace
}  // namespace kambara
