// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/vsystem/picture_fit.h"

#include <gtest/gtest.h>

#include <memory>

#include "core/camera/nominal_rig.h"
#include "tests/support/list_grabber.h"

namespace kambara {
namespace {

std::unique_ptr<GrabberBase> grabber(int width, int height) {
    return std::make_unique<testing_support::ListGrabber>(std::vector<Frame>{}, width, height);
}

TEST(PictureFit, TakesTheRigAsItIsForItsOwnSize) {
    const auto rig = fitted_to_pictures(nominal_rig(), {grabber(640, 480), grabber(640, 480), {}});
    ASSERT_TRUE(rig);
    EXPECT_EQ(rig->left.lens, nominal_rig().left.lens);
}

TEST(PictureFit, ScalesToAnotherSizeOfTheSameShape) {
    const auto rig = fitted_to_pictures(nominal_rig(), {grabber(320, 240), grabber(320, 240), {}});
    ASSERT_TRUE(rig);
    const Eigen::Vector3d point(100.0, 50.0, 1500.0);
    const Eigen::Vector2d full = *nominal_rig().left.project(point);
    const Eigen::Vector2d half = *rig->left.project(point);
    EXPECT_NEAR(half.x(), 0.5 * (full.x() + 0.5) - 0.5, 1e-9);
    EXPECT_NEAR(half.y(), 0.5 * (full.y() + 0.5) - 0.5, 1e-9);
}

TEST(PictureFit, RefusesWhatDoesNotBelongTogether) {
    EXPECT_NE(fitted_to_pictures(nominal_rig(), {grabber(640, 400), grabber(640, 400), {}})
                  .error()
                  .cause.find("another shape"),
              std::string::npos);
    EXPECT_NE(fitted_to_pictures(nominal_rig(), {grabber(640, 480), grabber(320, 240), {}})
                  .error()
                  .cause.find("320 x 240"),
              std::string::npos);
    Rig mono = nominal_rig();
    mono.right.reset();
    EXPECT_NE(fitted_to_pictures(mono, {grabber(640, 480), grabber(640, 480), {}})
                  .error()
                  .cause.find("no right camera"),
              std::string::npos);
}

}  // namespace
}  // namespace kambara
