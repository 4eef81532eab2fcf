// SPDX-License-Identifier: GPL-3.0-or-later
// What the rig's own covariance makes of a position, against rigs drawn from it.
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <random>

#include "core/camera/rig_parameters.h"
#include "core/stereo/position.h"
#include "tests/core/stereo/stereo_samples.h"

namespace kambara {
namespace {

Lens changed(const Lens& lens, const Eigen::VectorXd& by) {
    if (const auto* brown = std::get_if<BrownLens>(&lens)) {
        std::vector<double> terms = brown->distortion();
        for (std::size_t i = 0; i < terms.size(); ++i) {
            terms[i] += by[4 + static_cast<Eigen::Index>(i)];
        }
        return BrownLens(brown->fx_px() + by[0], brown->fy_px() + by[1], brown->cx_px() + by[2],
                         brown->cy_px() + by[3], terms);
    }
    TsaiLens tsai = std::get<TsaiLens>(lens);
    tsai.f_mm += by[0];
    tsai.kappa1_per_mm2 += by[1];
    tsai.cx_px += by[2];
    tsai.cy_px += by[3];
    tsai.sx += by[4];
    return tsai;
}

// The rig whose parameters are off by so much.
Rig changed(const Rig& rig, const Eigen::VectorXd& by) {
    const auto left = static_cast<Eigen::Index>(lens_parameter_names(rig.left.lens).size());
    const auto right = static_cast<Eigen::Index>(lens_parameter_names(rig.right->lens).size());
    const RigidTransform T = T_right_from_left(rig);
    const Eigen::Vector3d turn = by.segment<3>(left + right);
    const RigidTransform moved{
        Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix() * T.R,
        T.t_mm + by.tail<3>()};
    Camera a = rig.left;
    Camera b = *rig.right;
    a.lens = changed(rig.left.lens, by.head(left));
    b.lens = changed(rig.right->lens, by.segment(left, right));
    return rig_from_pair(a, b, moved);
}

// A correlated covariance with deviations such as calibrations leave.
Eigen::MatrixXd some_covariance(const Rig& rig) {
    const auto names = rig_parameter_names(rig);
    const auto n = static_cast<Eigen::Index>(names.size());
    Eigen::VectorXd sigma(n);
    for (Eigen::Index i = 0; i < n; ++i) {
        const std::string& name = names[static_cast<std::size_t>(i)];
        sigma[i] = name.ends_with("_px")    ? 0.2
                   : name.ends_with("_rad") ? 2e-4
                   : name.ends_with("shift_x_mm") || name.ends_with("shift_y_mm") ||
                           name.ends_with("shift_z_mm")
                       ? 0.2
                       : 3e-4;
    }
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    const Eigen::MatrixXd mix =
        Eigen::MatrixXd::NullaryExpr(n, 2 * n, [&] { return normal(random); });
    Eigen::MatrixXd correlation = mix * mix.transpose();
    const Eigen::VectorXd scale = correlation.diagonal().cwiseSqrt().cwiseInverse();
    correlation = scale.asDiagonal() * correlation * scale.asDiagonal();
    return sigma.asDiagonal() * correlation * sigma.asDiagonal();
}

TEST(CalibrationCovariance, IsKeptApartAndMatchesTheScatterOfRigsDrawnFromIt) {
    for (Rig rig : rig_samples()) {
        rig.parameter_covariance = some_covariance(rig);
        ASSERT_EQ(covariance_fault(rig, *rig.parameter_covariance), "");
        const Eigen::MatrixXd L = rig.parameter_covariance->llt().matrixL();
        for (const Eigen::Vector3d& place :
             {Eigen::Vector3d(200, 50, 1000), {500, -200, 2000}, {-300, 300, 5000}}) {
            const SeenPoint point = seen(rig, place);
            const auto told = position_from_pair(rig, PixelMeasurement{point.left_px},
                                                 PixelMeasurement{point.right_px});
            ASSERT_TRUE(told && told->calibration_covariance_mm2);
            std::mt19937 random(8);
            std::normal_distribution<double> normal;
            double chi2 = 0.0;
            double epipolar = 0.0;
            constexpr int trials = 1500;
            for (int i = 0; i < trials; ++i) {
                const Rig other = changed(rig, L * Eigen::VectorXd::NullaryExpr(
                                                       L.rows(), [&] { return normal(random); }));
                const auto found =
                    position_from_pair(other, PixelMeasurement{point.left_px},
                                       PixelMeasurement{point.right_px}, {.max_residual_px = 20.0});
                ASSERT_TRUE(found) << found.error().text();
                EXPECT_FALSE(found->calibration_covariance_mm2);  // that rig doesn't tell
                const Eigen::Vector3d error = found->point_in_left_mm - point.in_left_mm;
                chi2 += error.dot(told->calibration_covariance_mm2->ldlt().solve(error)) / trials;
                epipolar += std::pow(found->epipolar.offset_px, 2) / trials;
            }
            EXPECT_NEAR(chi2, 3.0, 0.35) << place.transpose();
            EXPECT_NEAR(std::sqrt(epipolar) / told->epipolar.calibration_sigma_px.value(), 1.0,
                        0.08);
            EXPECT_NEAR(told->epipolar.offset_px, 0.0, 1e-6);
        }
    }
}

TEST(CalibrationCovariance, FollowsThePicturesSize) {
    Rig rig = nominal_rig();
    rig.parameter_covariance = some_covariance(rig);
    const Rig half = scaled_to(rig, 320, 240);
    const SeenPoint point = seen(rig, {200, 50, 1500});
    const SeenPoint point_in_half = seen(half, {200, 50, 1500});
    const auto a =
        position_from_pair(rig, PixelMeasurement{point.left_px}, PixelMeasurement{point.right_px});
    const auto b = position_from_pair(half, PixelMeasurement{point_in_half.left_px},
                                      PixelMeasurement{point_in_half.right_px});
    EXPECT_LT((*a->calibration_covariance_mm2 - *b->calibration_covariance_mm2).norm(),
              1e-3 * a->calibration_covariance_mm2->norm());
}

}  // namespace
}  // namespace kambara
