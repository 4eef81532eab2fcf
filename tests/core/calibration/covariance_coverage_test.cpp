// SPDX-License-Identifier: GPL-3.0-or-later
// The covariance that a calibration tells of its own parameters, carried to positions, against many
// simulated calibrations of known truth.
#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include "core/camera/rig_file.h"
#include "core/camera/rig_parameters.h"
#include "tests/core/calibration/rig_samples.h"

namespace kambara {
namespace {

using testing_support::options_for;
using testing_support::Showing;
using testing_support::views_of;

constexpr double of_95_percent = 7.815;  // chi squared of three degrees of freedom

struct Place {
    const char* name;
    Eigen::Vector3d in_rig_mm;
    int inside = 0;
    double chi2 = 0.0;
};

// Error of the place that a found rig gives for the true pixels, in units of the covariance that
// the calibration tells: chi squared. The pixels are without noise: the calibration's part alone.
double chi_squared(const Rig& truth, const Rig& found, const Eigen::Vector3d& in_rig_mm) {
    const Eigen::Vector3d in_left = truth.left.T_camera_from_rig * in_rig_mm;
    const Eigen::Vector2d left_px = truth.left.project(in_rig_mm).value();
    const Eigen::Vector2d right_px = truth.right->project(in_rig_mm).value();
    // As position_from_pair does for pixels known alike: least squares of the four coordinates,
    // linearised at the true place.
    Eigen::Vector4d rest;
    Eigen::Matrix<double, 4, 3> A;
    Eigen::Vector3d point = in_left;
    for (int step = 0; step < 5; ++step) {
        Eigen::Matrix<double, 2, 3> a;
        Eigen::Matrix<double, 2, 3> b;
        const RigidTransform T = T_right_from_left(found);
        rest << left_px - project(found.left.lens, point, a).value(),
            right_px - project(found.right->lens, T * point, b).value();
        A << a, b * T.R;
        point += (A.transpose() * A).ldlt().solve(A.transpose() * rest);
    }
    const Eigen::Matrix<double, 3, 4> by_pixels =
        (A.transpose() * A).ldlt().solve(Eigen::Matrix<double, 3, 4>(A.transpose()));
    const auto B = pixels_by_parameters(found, point).value();
    const Eigen::Matrix3d C =
        by_pixels * B * found.parameter_covariance.value() * B.transpose() * by_pixels.transpose();
    const Eigen::Vector3d error = point - in_left;
    return error.dot(C.ldlt().solve(error));
}

TEST(CalibrationCoverageSlow, EllipsoidsOf95PercentHoldTheTruthThatOften) {
    const Rig truth = nominal_rig();
    const Target target = two_plane_24();
    Showing how;
    how.views = 12;
    how.pan_tilt = false;
    RigCalibratorOptions options = options_for(truth, false);
    options.held_out = false;
    Place places[] = {{"centre 1 m", {225, 0, 1000}}, {"edge 1 m", {725, -330, 1000}},
                      {"centre 2 m", {225, 0, 2000}}, {"edge 2 m", {1250, -700, 2000}},
                      {"centre 5 m", {225, 0, 5000}}, {"edge 5 m", {2900, -1900, 5000}}};
    constexpr int calibrations = 300;
    int done = 0;
    for (int i = 0; i < calibrations; ++i) {
        std::mt19937 random(static_cast<unsigned>(1000 + i));
        const auto report = calibrate_rig(views_of(truth, target, how, random), target, options);
        if (!report.rig.parameter_covariance) {
            continue;
        }
        ++done;
        for (Place& place : places) {
            const double chi2 = chi_squared(truth, report.rig, place.in_rig_mm);
            place.inside += chi2 <= of_95_percent ? 1 : 0;
            place.chi2 += chi2;
        }
        if (i == 0) {  // what is written is what is read
            const auto again = rig_from_text(rig_to_text(report.rig));
            ASSERT_TRUE(again) << again.error().text();
            EXPECT_LT((*again->parameter_covariance - *report.rig.parameter_covariance).norm(),
                      1e-12 * report.rig.parameter_covariance->norm());
        }
    }
    EXPECT_EQ(done, calibrations);
    int inside = 0;
    for (const Place& place : places) {
        std::printf("%-11s inside %.1f %% of %d calibrations; mean chi2 %.2f of 3\n", place.name,
                    100.0 * place.inside / done, done, place.chi2 / done);
        inside += place.inside;
        // 300 calibrations tell a place's share to 1.3 %.
        EXPECT_NEAR(static_cast<double>(place.inside) / done, 0.95, 0.035) << place.name;
    }
    EXPECT_NEAR(static_cast<double>(inside) / (6.0 * done), 0.95, 0.02);
}

}  // namespace
}  // namespace kambara
