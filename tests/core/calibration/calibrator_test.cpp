// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/calibrator.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>

#include "core/base/angles.h"

namespace kambara {
namespace {

const ChessboardTarget board{9, 6, 30.0};

struct Truth {
    BrownLens left{520.0, 522.0, 318.0, 243.0, {-0.25, 0.08, 0.001, -0.0005, 0.0}};
    BrownLens right{530.0, 529.0, 325.0, 238.0, {-0.27, 0.10, -0.0008, 0.0004, 0.0}};
    RigidTransform T_right_from_left{
        rotation_about_y(rad_from_deg(4.0)) * rotation_about_x(rad_from_deg(-1.0)),
        {-120.0, 2.0, 3.0}};
};

// Views of the board in random poses, with Gaussian noise on the corners.
std::vector<BoardView> views_of(const Truth& truth, int count, double noise_px,
                                std::mt19937& random) {
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    std::normal_distribution<double> noise(0.0, noise_px);
    const auto corners = corners_in_target_mm(board);
    std::vector<BoardView> views;
    while (static_cast<int>(views.size()) < count) {
        RigidTransform T_left_from_board;
        T_left_from_board.R =
            Eigen::AngleAxisd(0.3 * unit(random), Eigen::Vector3d::UnitZ()).toRotationMatrix() *
            rotation_about_y(0.6 * unit(random)) * rotation_about_x(0.6 * unit(random));
        const Eigen::Vector3d middle(60.0 + 60.0 * unit(random), 60.0 * unit(random),
                                     500.0 + 150.0 * unit(random));
        T_left_from_board.t_mm = middle - T_left_from_board.R * Eigen::Vector3d(120, 75, 0);
        BoardView view;
        bool inside = true;
        for (const auto& corner : corners) {
            const Eigen::Vector3d in_left = T_left_from_board * corner;
            const auto l = project(Lens(truth.left), in_left);
            const auto r = project(Lens(truth.right), truth.T_right_from_left * in_left);
            inside = inside && l && r && l->minCoeff() > 0 && r->minCoeff() > 0 && l->x() < 640 &&
                     r->x() < 640 && l->y() < 480 && r->y() < 480;
            if (inside) {
                view.left_px.push_back(*l + Eigen::Vector2d(noise(random), noise(random)));
                view.right_px.push_back(*r + Eigen::Vector2d(noise(random), noise(random)));
            }
        }
        if (inside) {
            views.push_back(std::move(view));
        }
    }
    return views;
}

CalibratorOptions options() {
    CalibratorOptions o;
    o.width_px = 640;
    o.height_px = 480;
    return o;
}

TEST(Calibrator, FindsTheTruthExactlyWithoutNoise) {
    std::mt19937 random(1);
    const Truth truth;
    const auto report = calibrate_chessboard(views_of(truth, 8, 0.0, random), board, options());
    ASSERT_EQ(report.verdict, CalibrationReport::Verdict::good);
    EXPECT_LT(*report.stereo_rms_px, 1e-4);
    const auto& left = std::get<BrownLens>(report.left.camera.lens);
    EXPECT_NEAR(left.fx_px(), truth.left.fx_px(), 1e-2);
    EXPECT_NEAR(left.distortion()[0], truth.left.distortion()[0], 1e-4);
    EXPECT_LT((report.T_right_from_left.t_mm - truth.T_right_from_left.t_mm).norm(), 1e-3);
}

// With noise of 0.15 px a coordinate: the residuals' root mean square is that, times the square
// root of two for the length; and the errors are as large as the deviations say.
TEST(Calibrator, TellsItsOwnUncertainty) {
    std::mt19937 random(2);
    const Truth truth;
    constexpr int rounds = 12;
    double squares = 0.0;
    int terms = 0;
    for (int round = 0; round < rounds; ++round) {
        const auto report =
            calibrate_chessboard(views_of(truth, 8, 0.15, random), board, options());
        ASSERT_EQ(report.verdict, CalibrationReport::Verdict::good);
        EXPECT_NEAR(*report.stereo_rms_px, 0.15 * std::sqrt(2.0), 0.02);
        const auto& found = std::get<BrownLens>(report.left.camera.lens).parameters();
        for (const std::size_t i : {0U, 1U, 2U, 3U}) {
            const double error = found[i] - truth.left.parameters()[i];
            squares += std::pow(error / report.left.sigma[i], 2);
            EXPECT_LT(std::abs(error), 5.0 * report.left.sigma[i]);
            ++terms;
        }
        const double baseline_error =
            report.T_right_from_left.t_mm.norm() - truth.T_right_from_left.t_mm.norm();
        squares += std::pow(baseline_error / report.baseline_sigma_mm, 2);
        ++terms;
    }
    // Mean squared error in units of the predicted variance: 1 but for chance.
    EXPECT_NEAR(squares / terms, 1.0, 0.6);
}

TEST(Calibrator, PutsTheBoardsOrderRightWhereOneCameraSawItTurned) {
    std::mt19937 random(3);
    auto views = views_of(Truth{}, 6, 0.05, random);
    std::reverse(views[2].right_px.begin(), views[2].right_px.end());
    const auto report = calibrate_chessboard(views, board, options());
    EXPECT_EQ(report.views_used, 6);
    EXPECT_LT(*report.stereo_rms_px, 0.1);
}

TEST(Calibrator, LeavesOutAViewThatDoesNotFitAndSaysSo) {
    std::mt19937 random(4);
    auto views = views_of(Truth{}, 9, 0.05, random);
    std::normal_distribution<double> blur(0.0, 4.0);
    for (auto& corner : views[5].right_px) {
        corner += Eigen::Vector2d(blur(random), blur(random));
    }
    const auto report = calibrate_chessboard(views, board, options());
    EXPECT_EQ(report.views_used, 8);
    ASSERT_EQ(report.views_rejected.size(), 1U);
    EXPECT_EQ(report.views_rejected[0].view, 5);
    EXPECT_NE(report.views_rejected[0].reason.find("right"), std::string::npos);
    EXPECT_EQ(report.corners_total, 9 * 54 * 2);
    EXPECT_EQ(report.corners_used, 8 * 54 * 2);
}

TEST(Calibrator, RefusesTooFewViews) {
    std::mt19937 random(5);
    auto views = views_of(Truth{}, 2, 0.05, random);
    views.push_back({{}, {}, "No chessboard is found.", ""});
    const auto report = calibrate_chessboard(views, board, options());
    EXPECT_EQ(report.verdict, CalibrationReport::Verdict::refused);
    ASSERT_FALSE(report.reasons.empty());
    EXPECT_NE(report.reasons[0].find("Only 2 views"), std::string::npos);
    EXPECT_EQ(report.views_rejected.at(0).reason, "left: No chessboard is found.");
}

TEST(Calibrator, RefusesResidualsThatAreTooLarge) {
    std::mt19937 random(6);
    const auto report = calibrate_chessboard(views_of(Truth{}, 6, 1.5, random), board, options());
    EXPECT_EQ(report.verdict, CalibrationReport::Verdict::refused);
}

TEST(Calibrator, RefusesAKnownBaselineThatContradictsTheBoard) {
    std::mt19937 random(7);
    const auto views = views_of(Truth{}, 6, 0.1, random);
    auto o = options();
    o.baseline = KnownBaseline{140.0, 0.5};
    EXPECT_EQ(calibrate_chessboard(views, board, o).verdict, CalibrationReport::Verdict::refused);
    const double truth_mm = Truth{}.T_right_from_left.t_mm.norm();
    o.baseline = KnownBaseline{truth_mm, 0.001};
    const auto report = calibrate_chessboard(views, board, o);
    EXPECT_EQ(report.verdict, CalibrationReport::Verdict::good);
    EXPECT_NEAR(report.T_right_from_left.t_mm.norm(), truth_mm, 0.003);  // it fixes the scale
}

TEST(Calibrator, OneCameraAloneIsCalibratedToo) {
    std::mt19937 random(8);
    auto o = options();
    o.stereo = false;
    const auto report = calibrate_chessboard(views_of(Truth{}, 7, 0.05, random), board, o);
    ASSERT_EQ(report.verdict, CalibrationReport::Verdict::good);
    EXPECT_FALSE(report.rig.right);
    EXPECT_FALSE(report.stereo_rms_px);
    EXPECT_NEAR(pinhole_parameters(report.rig.left.lens).fx_px, 520.0, 2.0);
}

TEST(Calibrator, StopsWhenAsked) {
    std::mt19937 random(9);
    std::stop_source stop;
    stop.request_stop();
    const auto report = calibrate_chessboard(views_of(Truth{}, 5, 0.05, random), board, options(),
                                             stop.get_token());
    EXPECT_EQ(report.verdict, CalibrationReport::Verdict::refused);
    EXPECT_NE(report.reasons.at(0).find("stopped"), std::string::npos);
}

}  // namespace
}  // namespace kambara
