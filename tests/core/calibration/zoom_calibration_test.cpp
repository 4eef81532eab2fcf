// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/zoom_calibration.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

#include "core/camera/nominal_rig.h"
#include "core/camera/zoom.h"
#include "tests/support/textured_plane.h"

namespace kambara {
namespace {

using testing_support::drawn;
using testing_support::TexturedPlane;

// Not the exponential that is assumed of a lens nobody has measured.
double truth_at(double share) {
    return 1.0 + 7.0 * std::pow(share, 1.6);
}

Image noisy(Image picture, std::uint32_t seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0.0, 2.0);
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            const double grey = std::round(picture.at(x, y) + noise(random));
            picture.at(x, y) = static_cast<std::uint8_t>(std::clamp(grey, 0.0, 255.0));
        }
    }
    return picture;
}

Camera camera() {
    return *nominal_rig().pan_tilt;
}

/// The head does not stay quite where it was while the zoom's motor runs.
ImagePtr view(double magnification, double turn_rad, std::uint32_t seed) {
    Camera zoomed_in = camera();
    zoomed_in.lens = zoomed(zoomed_in.lens, magnification);
    RigidTransform& T = zoomed_in.T_camera_from_rig;
    const Eigen::Matrix3d R =
        Eigen::AngleAxisd(turn_rad, Eigen::Vector3d(0.6, 0.8, 0.0)).toRotationMatrix();
    T = {R * T.R, R * T.t_mm};
    TexturedPlane plane{{0.0, 0.0, 2500.0}};
    plane.size = 0.5;
    return std::make_shared<const Image>(noisy(drawn(plane, zoomed_in), seed));
}

std::vector<ZoomView> views_of(const std::vector<double>& shares) {
    std::vector<ZoomView> views;
    for (const double share : shares) {
        const auto seed = static_cast<std::uint32_t>(1000.0 * share);
        views.push_back({share, view(truth_at(share), seed % 3 == 0 ? 0.0 : 4e-4, seed)});
    }
    return views;
}

TEST(ZoomCalibrationSlow, FindsACurveToAFractionOfAThousandth) {
    const std::vector<double> shares{0.0,  0.1, 0.16, 0.22, 0.28, 0.35, 0.42,
                                     0.50, 0.6, 0.7,  0.8,  0.9,  1.0};
    const auto places = calibrate_zoom(camera(), views_of(shares));
    ASSERT_TRUE(places) << places.error().text();
    ASSERT_EQ(places->size(), shares.size());
    double squares = 0.0;
    for (std::size_t i = 1; i < shares.size(); ++i) {
        const ZoomPlace& place = (*places)[i];
        const double truth = truth_at(shares[i]);
        std::printf("zoom %.2f: %.4f (truth %.4f), sigma %.5f, %d points, %.3f px\n", shares[i],
                    place.magnification, truth, place.magnification_sigma, place.points,
                    place.rms_px);
        EXPECT_NEAR(place.magnification / truth, 1.0, 2e-4);
        EXPECT_GE(place.points, 20);
        const double off = (place.magnification - truth) / place.magnification_sigma;
        squares += off * off / static_cast<double>(shares.size() - 1);
    }
    std::printf("squared error by variance: %.2f\n", squares);
    EXPECT_LT(squares, 6.0);
    EXPECT_GT(squares, 0.02);
}

TEST(ZoomCalibration, RefusesWhatCannotTell) {
    const auto wide = view(1.0, 0.0, 1);
    const auto cause = [](const std::vector<ZoomView>& views) {
        const auto places = calibrate_zoom(camera(), views);
        return places ? std::string() : places.error().cause;
    };
    EXPECT_NE(cause({{0.0, wide}}).find("two views"), std::string::npos);
    EXPECT_NE(cause({{0.2, wide}, {0.4, wide}}).find("widest view is at zoom 0.200"),
              std::string::npos);
    EXPECT_NE(cause({{0.0, wide}, {0.4, wide}, {0.4, wide}}).find("same zoom, 0.400"),
              std::string::npos);
    const auto small = std::make_shared<const Image>(320, 240, 1);
    EXPECT_NE(cause({{0.0, wide}, {0.4, small}}).find("320 x 240"), std::string::npos);
    const auto blank =
        std::make_shared<const Image>(camera().width_px, camera().height_px, 1, std::uint8_t{90});
    EXPECT_NE(cause({{0.0, wide}, {0.4, blank}}).find("From zoom 0.000 to 0.400"),
              std::string::npos);
    EXPECT_NE(cause({{0.0, wide}, {1.0, view(4.0, 0.0, 2)}}).find("points are found again"),
              std::string::npos);
}

}  // namespace
}  // namespace kambara
