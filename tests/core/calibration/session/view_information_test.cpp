// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/session/view_information.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "core/calibration/bundle.h"
#include "core/calibration/session/next_view.h"
#include "tests/core/calibration/session/session_samples.h"

namespace kambara {
namespace {

using namespace testing_support;

// A bundle at the truth, from views without noise.
struct Exact {
    Rig rig = built_rig(true);
    Target target = two_plane_24();
    RigGuess guess;
    std::vector<RigView> views;
    Bundle bundle;

    explicit Exact(LensModel model) {
        std::mt19937 random(7);
        const SessionSetup setup = setup_for(rig, target, model);
        guess = guess_from(rig, options_of(setup));
        Showing how;
        how.views = 6;
        how.noise_px = 0.0;
        how.turn_deg = 12.0;
        views = views_of(rig, target, how, random);
        bundle.target_mm = corners_in_target_mm(target);
        bundle.target_sigma_mm = corner_sigmas_mm(target);
        bundle.cameras = guess.cameras;
    }

    // Takes every corner for seen with that noise, a little off so that residuals have a variance.
    void fill(double noise_px) {
        for (std::size_t v = 0; v < views.size(); ++v) {
            bundle.first_from_target.push_back(
                *first_from_target(guess, bundle.target_mm, views[v]));
            for (std::size_t k = 0; k < guess.places.size(); ++k) {
                for (const auto& corner : views[v].sights[guess.places[k]].corners) {
                    const Eigen::Vector2d off(corner.id % 2 == 0 ? noise_px : -noise_px,
                                              corner.id % 3 == 0 ? noise_px : -noise_px);
                    bundle.corners.push_back({static_cast<int>(v), static_cast<int>(k), corner.id,
                                              corner.px + off, noise_px, true});
                }
            }
        }
    }

    Eigen::MatrixXd information(double noise_px) const {
        Eigen::MatrixXd sum;
        for (std::size_t v = 0; v < views.size(); ++v) {
            std::vector<std::vector<int>> ids(guess.places.size());
            for (std::size_t k = 0; k < ids.size(); ++k) {
                for (const auto& corner : views[v].sights[guess.places[k]].corners) {
                    ids[k].push_back(corner.id);
                }
            }
            const Eigen::MatrixXd one = view_information(
                guess, bundle.target_mm, bundle.first_from_target[v], ids, noise_px);
            sum = v == 0 ? one : (sum + one).eval();
        }
        return sum;
    }
};

TEST(ViewInformation, PosesComeFromOneCamerasCorners) {
    Exact exact(LensModel::tsai);
    for (const RigView& view : exact.views) {
        const auto pose = first_from_target(exact.guess, exact.bundle.target_mm, view);
        ASSERT_TRUE(pose);
        for (const auto& corner : view.sights[1].corners) {
            const auto px = pixel_in(exact.guess, 1, transform_of(*pose),
                                     exact.bundle.target_mm[static_cast<std::size_t>(corner.id)]);
            ASSERT_TRUE(px);
            EXPECT_LT((*px - corner.px).norm(), 1e-3);
        }
    }
}

TEST(ViewInformation, SumOverViewsIsTheInverseOfTheBundlesCovariance) {
    for (const auto model : {LensModel::tsai, LensModel::brown}) {
        Exact exact(model);
        if (model == LensModel::brown) {
            // Pinholes: the pixels that the lenses of the guess would have seen are used below only
            // through their derivatives.
            for (auto& camera : exact.bundle.cameras) {
                camera.free_k3 = false;
            }
        }
        exact.fill(0.1);
        const BundleCovariance covariance = covariance_of(exact.bundle);
        ASSERT_TRUE(covariance.determined);
        const auto open = open_parameters(exact.guess);
        const Eigen::MatrixXd theirs = covariance.cameras(open, open) / covariance.variance_factor;
        const Eigen::VectorXd scale = theirs.diagonal().cwiseSqrt();
        const Eigen::MatrixXd product = scale.cwiseInverse().asDiagonal() * theirs *
                                        exact.information(0.1) * scale.asDiagonal();
        EXPECT_LT((product - Eigen::MatrixXd::Identity(product.rows(), product.cols())).norm(),
                  1e-4);
    }
}

TEST(ViewInformation, GoalIsTheMeanSquareOfTheRangeErrorMap) {
    Exact exact(LensModel::tsai);
    // Without the pan-tilt camera, which the map knows nothing of.
    exact.guess.places.pop_back();
    exact.guess.cameras.pop_back();
    exact.guess.sizes.pop_back();
    exact.bundle.cameras.pop_back();
    exact.fill(0.1);
    const BundleCovariance covariance = covariance_of(exact.bundle);
    ASSERT_TRUE(covariance.determined);
    double squares = 0.0;
    const auto map = range_error_map(exact.bundle, covariance.cameras,
                                     exact.rig.left.T_camera_from_rig, {640, 480}, {});
    for (const auto& place : map) {
        squares += std::pow(place.sigma_calibration_mm / place.range_mm, 2);
    }
    const auto open = open_parameters(exact.guess);
    const double ours = (covariance.cameras(open, open) * volume_goal(exact.guess, {})).trace();
    EXPECT_NEAR(ours * static_cast<double>(map.size()) / squares, 1.0, 1e-3);
}

TEST(NextView, EveryViewLessensTheErrorAndTheSuggestedOneMost) {
    Exact exact(LensModel::tsai);
    const double none = predicted_range_error(exact.guess, exact.target, {}, {});
    const double six = predicted_range_error(exact.guess, exact.target, exact.views, {});
    EXPECT_LT(six, none);
    const auto next = next_view(exact.guess, exact.target, exact.views, {});
    ASSERT_TRUE(next);
    EXPECT_DOUBLE_EQ(next->range_error_before, six);
    EXPECT_LT(next->range_error_after, six);
    std::mt19937 random(1);
    const auto view = shown(exact.rig, exact.target, next->T_left_from_target, 0.0, random);
    ASSERT_TRUE(view);  // whole in every picture
    auto with_it = exact.views;
    with_it.push_back(*view);
    EXPECT_NEAR(predicted_range_error(exact.guess, exact.target, with_it, {}),
                next->range_error_after, 1e-3 * six);
    for (const auto& other : exact.views) {
        auto with_other = exact.views;
        with_other.push_back(other);
        EXPECT_GE(predicted_range_error(exact.guess, exact.target, with_other, {}),
                  next->range_error_after);
    }
}

TEST(NextView, OutlinesLieWhereTheCamerasSeeTheTarget) {
    Exact exact(LensModel::tsai);
    const auto next = next_view(exact.guess, exact.target, {}, {});
    ASSERT_TRUE(next);
    for (std::size_t c = 0; c < most_cameras; ++c) {
        ASSERT_EQ(next->corners_px[c].size(), exact.bundle.target_mm.size());
        EXPECT_EQ(next->outlines_px[c].size(), 2U);
        for (const auto& px : next->corners_px[c]) {
            EXPECT_GT(px.minCoeff(), 0.0);
            EXPECT_LT(px.x(), 640.0);
            EXPECT_LT(px.y(), 480.0);
        }
    }
}

TEST(NextView, OneCameraIsGuidedToo) {
    Rig rig = built_rig(false);
    const Target target = ChessboardTarget{9, 6, 30.0};
    SessionSetup setup = setup_for(rig, target, LensModel::brown);
    setup.cameras[1].reset();
    const auto session = CalibrationSession::begin(setup);
    ASSERT_TRUE(session);
    const auto next = session->what_next();
    ASSERT_TRUE(next);
    EXPECT_LT(next->range_error_after, next->range_error_before);
    EXPECT_TRUE(next->corners_px[1].empty());
}

TEST(NextView, NothingWhereNoPictureIsShared) {
    Exact exact(LensModel::tsai);
    exact.guess.cameras[1].camera_from_first =
        block_of(RigidTransform{rotation_about_y(rad_from_deg(180.0)), {0.0, 0.0, 0.0}});
    EXPECT_FALSE(next_view(exact.guess, exact.target, {}, {}));
}

}  // namespace
}  // namespace kambara
