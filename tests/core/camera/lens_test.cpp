// SPDX-License-Identifier: GPL-3.0-or-later
// What holds for every lens model.
#include "core/camera/lens.h"

#include <ceres/jet.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/camera/lens_functions.h"
#include "core/camera/nominal_rig.h"
#include "tests/core/camera/lens_samples.h"

namespace kambara {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Jet = ceres::Jet<double, 3>;

std::vector<Lens> nominal_lenses() {
    std::vector<Lens> lenses;
    for (const Medium medium : {Medium::air, Medium::water}) {
        const Rig rig = nominal_rig(medium);
        lenses.insert(lenses.end(), {rig.left.lens, rig.right->lens, rig.pan_tilt->lens});
    }
    return lenses;
}

// Largest distance after pixel -> ray -> pixel, and how many pixels no ray reaches.
struct RoundTrip {
    double worst_px = 0.0;
    int without_ray = 0;
};

RoundTrip round_trip(const Lens& lens) {
    RoundTrip result;
    for (const Vector2d& pixel : picture_grid(640, 480, 40)) {
        const auto ray = unproject(lens, pixel);
        if (!ray) {
            ++result.without_ray;
            continue;
        }
        for (const double distance_mm : {1.0, 3456.7}) {
            const auto back = project(lens, ray->at(distance_mm));
            const double away = back ? (*back - pixel).norm() : 1e9;
            result.worst_px = std::max(result.worst_px, away);
        }
    }
    return result;
}

TEST(Lens, EveryPixelOfTheNominalRigComesBack) {
    for (const Lens& lens : nominal_lenses()) {
        const RoundTrip result = round_trip(lens);
        EXPECT_EQ(result.without_ray, 0);
        EXPECT_LE(result.worst_px, 1e-9);
    }
}

TEST(Lens, EveryPixelThatARayReachesComesBack) {
    int pixels_without_ray = 0;
    const auto lenses = lens_samples(40);
    for (const Lens& lens : lenses) {
        const RoundTrip result = round_trip(lens);
        EXPECT_LE(result.worst_px, 1e-9);
        pixels_without_ray += result.without_ray;
        EXPECT_EQ(implausibility(lens, 640, 480), "");
    }
    // Only the corners of some strong pincushion lenses are dark.
    EXPECT_LT(pixels_without_ray, 0.02 * 41 * 41 * static_cast<double>(lenses.size()));
}

TEST(Lens, ADirectionComesBackFromItsPixel) {
    for (const Lens& lens : lens_samples(20)) {
        for (const double angle : {0.0, 1.0, 2.0, 4.0, 5.5}) {
            const Vector3d direction =
                Vector3d(0.3 * std::cos(angle), 0.3 * std::sin(angle), 1.0).normalized();
            const auto pixel = project(lens, 700.0 * direction);
            ASSERT_TRUE(pixel);
            const auto ray = unproject(lens, *pixel);
            ASSERT_TRUE(ray);
            EXPECT_LT((ray->direction - direction).norm(), 1e-12);
            EXPECT_EQ(ray->origin_mm, Vector3d::Zero());
        }
    }
}

TEST(Lens, NothingBehindTheCameraOrWithoutANumberIsSeen) {
    const double nothing = std::numeric_limits<double>::quiet_NaN();
    for (const Lens& lens : lens_samples(1)) {
        EXPECT_FALSE(project(lens, {0, 0, 0}));
        EXPECT_FALSE(project(lens, {10, 20, -500}));
        EXPECT_FALSE(project(lens, {10, 20, 0}));
        EXPECT_FALSE(project(lens, {nothing, 0, 100}));
        EXPECT_FALSE(project(lens, {0, 0, std::numeric_limits<double>::infinity()}));
        EXPECT_FALSE(unproject(lens, {nothing, 0}));
        EXPECT_FALSE(unproject(lens, {0, std::numeric_limits<double>::infinity()}));
    }
}

std::array<Jet, 2> pixel_of_jets(const Lens& lens, const Vector3d& point) {
    const Jet z(point.z(), 2);
    const Jet x = Jet(point.x(), 0) / z;
    const Jet y = Jet(point.y(), 1) / z;
    std::array<Jet, 2> pixel;
    if (const auto* tsai = std::get_if<TsaiLens>(&lens)) {
        const Jet parameters[] = {Jet(tsai->f_mm), Jet(tsai->kappa1_per_mm2), Jet(tsai->cx_px),
                                  Jet(tsai->cy_px), Jet(tsai->sx)};
        tsai_pixel(parameters, tsai->sensor.dx_prime_mm(), tsai->sensor.dy_mm, x, y, pixel.data());
    } else {
        const auto& values = std::get<BrownLens>(lens).parameters();
        std::array<Jet, 12> parameters;
        std::transform(values.begin(), values.end(), parameters.begin(),
                       [](double value) { return Jet(value); });
        brown_pixel(parameters.data(), x, y, pixel.data());
    }
    return pixel;
}

TEST(Lens, DerivativesByHandEqualAutomaticAndNumericalOnes) {
    auto lenses = lens_samples(10);
    const auto nominal = nominal_lenses();
    lenses.insert(lenses.end(), nominal.begin(), nominal.end());
    for (const Lens& lens : lenses) {
        for (const Vector3d& point : {Vector3d(0, 0, 800), Vector3d(300, -200, 900),
                                      Vector3d(-90, 250, 700), Vector3d(-1e-9, 0, 500)}) {
            Eigen::Matrix<double, 2, 3> J;
            const auto pixel = project(lens, point, J);
            ASSERT_TRUE(pixel);
            EXPECT_EQ(*pixel, *project(lens, point));
            const auto jets = pixel_of_jets(lens, point);
            for (int i = 0; i < 2; ++i) {
                const auto row = static_cast<std::size_t>(i);
                EXPECT_NEAR(jets[row].a, (*pixel)[i], 1e-10);
                EXPECT_LT((jets[row].v.transpose() - J.row(i)).norm(), 1e-12 * J.norm());
            }
            constexpr double h_mm = 1e-3;
            for (int k = 0; k < 3; ++k) {
                const Vector3d aside = h_mm * Vector3d::Unit(k);
                const Vector2d slope =
                    (*project(lens, point + aside) - *project(lens, point - aside)) / (2.0 * h_mm);
                EXPECT_LT((slope - J.col(k)).norm(), 1e-7 * J.norm());
            }
        }
    }
}

TEST(Lens, PicturesResizedFollowThePixelConvention) {
    const double a = 0.5;
    const double b = 1.25;
    for (const Lens& lens : lens_samples(5)) {
        const Lens resized = scaled(lens, a, b);
        const Lens stepwise = scaled(scaled(lens, 2.0, 0.5), a / 2.0, b / 0.5);
        for (const Vector3d& point : {Vector3d(300, -200, 900), Vector3d(-90, 250, 700)}) {
            const Vector2d before = *project(lens, point);
            const Vector2d expected(a * (before.x() + 0.5) - 0.5, b * (before.y() + 0.5) - 0.5);
            EXPECT_LT((*project(resized, point) - expected).norm(), 1e-10);
            EXPECT_LT((*project(stepwise, point) - expected).norm(), 1e-10);
        }
    }
}

TEST(Lens, PinholeParametersAreTheScaleOnTheAxis) {
    for (const Lens& lens : lens_samples(5)) {
        const auto p = pinhole_parameters(lens);
        const Vector2d centre = *project(lens, {0, 0, 1000});
        const Vector2d aside = *project(lens, {0.001, 0.001, 1000});
        EXPECT_LT((centre - Vector2d(p.cx_px, p.cy_px)).norm(), 1e-12);
        EXPECT_NEAR((aside.x() - centre.x()) * 1e6, p.fx_px, 1e-3);
        EXPECT_NEAR((aside.y() - centre.y()) * 1e6, p.fy_px, 1e-3);
    }
}

TEST(Lens, SaysWhyALensCannotBe) {
    const auto says = [](const Lens& lens, const char* part) {
        const std::string why = implausibility(lens, 640, 480);
        EXPECT_NE(why.find(part), std::string::npos) << part << ": " << why;
    };
    says(BrownLens(0.0, 500, 320, 240), "focal length");
    says(BrownLens(1e7, 1e7, 320, 240), "focal length");
    says(BrownLens(500, 500, std::numeric_limits<double>::quiet_NaN(), 240), "finite");
    says(BrownLens(2000, 500, 320, 240), "threefold");
    says(BrownLens(500, 500, 9000, 240), "principal point");
    says(BrownLens(500, 500, 320, 240, {-30.0, 0, 0, 0, 0}), "distortion");
    TsaiLens tsai = std::get<TsaiLens>(nominal_rig().left.lens);
    tsai.kappa1_per_mm2 = 1e6;
    says(tsai, "distortion");
}

}  // namespace
}  // namespace kambara
