// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/stereo_tracker.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/camera/nominal_rig.h"
#include "tests/support/textured_plane.h"

namespace kambara {
namespace {

using testing_support::drawn_pair;
using testing_support::TexturedPlane;

const Rectangle rectangle{240, 190, 31, 31};

Frame blank(const Frame& like) {
    Frame frame = like;
    frame.picture =
        std::make_shared<const Image>(like.picture->width(), like.picture->height(), 1, 90);
    return frame;
}

class StereoTrackerTest : public testing::Test {
  protected:
    StereoTrackerTest() : rig_(nominal_rig()), tracker_(rig_) {}

    StereoFrame pair_at(int index) const {
        TexturedPlane plane{{6.0 * index, -3.0 * index, 1500.0 + 8.0 * index}};
        return drawn_pair(plane, rig_, index);
    }

    // The point that is under the template's centre in frame 0, in the left camera's frame.
    Eigen::Vector3d truth_at(int index) const {
        const Ray ray = *rig_.left.unproject({rectangle.centre_x_px(), rectangle.centre_y_px()});
        const Eigen::Vector3d in_rig =
            ray.at(1500.0 / ray.direction.z()) + Eigen::Vector3d(6.0, -3.0, 8.0) * index;
        return rig_.left.T_camera_from_rig * in_rig;
    }

    Rig rig_;
    StereoTracker tracker_;
};

TEST_F(StereoTrackerTest, BeginsIdleAndRefusesToStart) {
    EXPECT_EQ(tracker_.estimate().state, TrackState::idle);
    EXPECT_FALSE(tracker_.start());
    EXPECT_FALSE(tracker_.update_template());
    EXPECT_EQ(tracker_.process(pair_at(0)).state, TrackState::idle);
}

TEST_F(StereoTrackerTest, ARefusedTemplateLeavesTheEarlierOne) {
    const StereoFrame pair = pair_at(0);
    ASSERT_TRUE(tracker_.set_template(pair, rectangle));
    EXPECT_FALSE(tracker_.set_template(pair, {620, 0, 31, 31}));
    EXPECT_EQ(tracker_.estimate().state, TrackState::template_set);
    EXPECT_EQ(tracker_.estimate().template_size_px, Eigen::Vector2i(31, 31));
    EXPECT_TRUE(tracker_.start());
}

TEST_F(StereoTrackerTest, FollowsAMovingPlaneToAPartInAThousand) {
    ASSERT_TRUE(tracker_.set_template(pair_at(0), rectangle));
    ASSERT_TRUE(tracker_.estimate().position);  // known as soon as it is chosen
    ASSERT_TRUE(tracker_.start());
    for (int i = 0; i < 12; ++i) {
        const TrackEstimate estimate = tracker_.process(pair_at(i));
        ASSERT_EQ(estimate.state, TrackState::tracking) << estimate.reason;
        ASSERT_TRUE(estimate.position && estimate.left_px && estimate.right_px);
        const Eigen::Vector3d truth = truth_at(i);
        EXPECT_LT((estimate.position->point_in_left_mm - truth).norm(), 1e-3 * truth.norm());
        EXPECT_GT(estimate.quality, 0.95);
        EXPECT_LT(estimate.position->residual_px, 0.1);
    }
}

TEST_F(StereoTrackerTest, GoesThroughItsLifeWithReasons) {
    ASSERT_TRUE(tracker_.set_template(pair_at(0), rectangle));
    ASSERT_TRUE(tracker_.start());
    ASSERT_EQ(tracker_.process(pair_at(0)).state, TrackState::tracking);

    StereoFrame half = pair_at(1);
    half.right = blank(half.right);
    const TrackEstimate doubtful = tracker_.process(half);
    EXPECT_EQ(doubtful.state, TrackState::doubtful);
    EXPECT_NE(doubtful.reason.find("right picture"), std::string::npos);
    EXPECT_FALSE(doubtful.position);

    StereoFrame none = pair_at(2);
    none.left = blank(none.left);
    const TrackEstimate lost = tracker_.process(none);
    EXPECT_EQ(lost.state, TrackState::lost);
    EXPECT_FALSE(lost.reason.empty());
    EXPECT_FALSE(lost.left_px);
    EXPECT_FALSE(tracker_.update_template());

    EXPECT_EQ(tracker_.process(pair_at(3)).state, TrackState::tracking);
    tracker_.stop();
    EXPECT_EQ(tracker_.estimate().state, TrackState::template_set);
    tracker_.clear();
    EXPECT_EQ(tracker_.estimate().state, TrackState::idle);
}

TEST_F(StereoTrackerTest, FindsTheTargetAgainAnywhereInThePicture) {
    ASSERT_TRUE(tracker_.set_template(pair_at(0), rectangle));
    ASSERT_TRUE(tracker_.start());
    ASSERT_EQ(tracker_.process(pair_at(0)).state, TrackState::tracking);
    StereoFrame none = pair_at(1);
    none.left = blank(none.left);
    ASSERT_EQ(tracker_.process(none).state, TrackState::lost);
    // 300 mm away: far outside the windows.
    TexturedPlane far{{300.0, 90.0, 1500.0}};
    TrackEstimate estimate;
    for (int i = 2; i < 8 && estimate.state != TrackState::tracking; ++i) {
        estimate = tracker_.process(drawn_pair(far, rig_, i));
    }
    ASSERT_EQ(estimate.state, TrackState::tracking) << estimate.reason;
    const Eigen::Vector3d truth =
        truth_at(0) + rig_.left.T_camera_from_rig.R * Eigen::Vector3d(300.0, 90.0, 0.0);
    EXPECT_LT((estimate.position->point_in_left_mm - truth).norm(), 1e-3 * truth.norm());
}

// It leaves at the left edge; its predicted place runs on and on, far from where it comes back. On
// the way out the right picture loses it first: what is taken for it there leads back elsewhere.
TEST_F(StereoTrackerTest, FindsATargetThatLeftThePictureAndCameBack) {
    const auto beside = [this](double x_mm, int index) {
        TexturedPlane plane{{x_mm, 0.0, 1500.0}};
        return drawn_pair(plane, rig_, index);
    };
    const auto is_true = [this](const TrackEstimate& estimate, double x_mm) {
        const Eigen::Vector3d truth =
            truth_at(0) + rig_.left.T_camera_from_rig.R * Eigen::Vector3d(x_mm, 0.0, 0.0);
        return (estimate.position->point_in_left_mm - truth).norm() < 1e-3 * truth.norm();
    };
    ASSERT_TRUE(tracker_.set_template(beside(0.0, 0), rectangle));
    ASSERT_TRUE(tracker_.start());
    double x_mm = 0.0;
    int index = 0;
    TrackEstimate estimate = tracker_.process(beside(0.0, index));
    while (estimate.state != TrackState::lost && index < 90) {
        x_mm = std::max(x_mm - 60.0, -1500.0);
        estimate = tracker_.process(beside(x_mm, ++index));
        EXPECT_TRUE(!estimate.position || is_true(estimate, x_mm)) << x_mm;
    }
    ASSERT_EQ(estimate.state, TrackState::lost);
    ASSERT_LT(x_mm, -300.0);  // it was followed to the edge
    for (int i = 0; i < 6; ++i) {
        estimate = tracker_.process(beside(-1500.0, ++index));
        EXPECT_EQ(estimate.state, TrackState::lost) << i;
    }
    for (int i = 0; i < 8 && estimate.state != TrackState::tracking; ++i) {
        estimate = tracker_.process(beside(-100.0, ++index));
    }
    ASSERT_EQ(estimate.state, TrackState::tracking) << estimate.reason;
    EXPECT_TRUE(is_true(estimate, -100.0));
}

TEST_F(StereoTrackerTest, LooksEverywhereOnceItsMotionIsForgotten) {
    ASSERT_TRUE(tracker_.set_template(pair_at(0), rectangle));
    TexturedPlane far{{300.0, 90.0, 1500.0}};
    tracker_.forget_motion();
    ASSERT_TRUE(tracker_.start());
    const TrackEstimate estimate = tracker_.process(drawn_pair(far, rig_, 9));
    EXPECT_EQ(estimate.state, TrackState::tracking) << estimate.reason;
}

TEST_F(StereoTrackerTest, NeverShowsAPlaceThatWasMeasuredInAnotherPair) {
    ASSERT_TRUE(tracker_.set_template(pair_at(0), rectangle));
    EXPECT_FALSE(tracker_.update_template());  // it is not being followed
    EXPECT_TRUE(tracker_.process(pair_at(0)).position);
    const TrackEstimate waiting = tracker_.process(pair_at(1));
    EXPECT_EQ(waiting.state, TrackState::template_set);
    EXPECT_FALSE(waiting.position || waiting.left_px || waiting.right_px || waiting.search);
    ASSERT_TRUE(tracker_.start());
    ASSERT_TRUE(tracker_.process(pair_at(2)).position);
    tracker_.stop();
    EXPECT_FALSE(tracker_.estimate().position);
    EXPECT_FALSE(tracker_.estimate().left_px);
    EXPECT_EQ(tracker_.estimate().template_size_px, Eigen::Vector2i(31, 31));
}

// Chosen where the right camera saw nothing, the template's distance is but assumed: half the
// true one's here. The first real position must not look like a leap to be predicted on.
TEST_F(StereoTrackerTest, TheFirstPositionAfterAnAssumedRangeIsNoMotion) {
    TrackerOptions options;
    options.assumed_range_mm = 700.0;
    StereoTracker tracker(rig_, options);
    StereoFrame half = pair_at(0);
    half.right = blank(half.right);
    ASSERT_TRUE(tracker.set_template(half, rectangle));
    EXPECT_FALSE(tracker.estimate().position);
    ASSERT_TRUE(tracker.start());
    int tracked = 0;
    for (int i = 1; i < 6; ++i) {
        const TrackEstimate estimate = tracker.process(pair_at(i));
        ASSERT_NE(estimate.state, TrackState::lost) << i << ": " << estimate.reason;
        if (estimate.position) {
            ++tracked;
            const Eigen::Vector3d truth = truth_at(i);
            EXPECT_LT((estimate.position->point_in_left_mm - truth).norm(), 2e-3 * truth.norm());
        }
    }
    EXPECT_GE(tracked, 4);
}

TEST_F(StereoTrackerTest, GivesUpWhatStaysLost) {
    TrackerOptions options;
    options.give_up_frames = 3;
    StereoTracker tracker(rig_, options);
    ASSERT_TRUE(tracker.set_template(pair_at(0), rectangle));
    ASSERT_TRUE(tracker.start());
    StereoFrame none = pair_at(1);
    none.left = blank(none.left);
    TrackEstimate estimate;
    for (int i = 0; i < 5; ++i) {
        estimate = tracker.process(none);
    }
    EXPECT_EQ(estimate.state, TrackState::template_set);
    EXPECT_NE(estimate.reason.find("given up"), std::string::npos);
    EXPECT_FALSE(tracker.started());
}

TEST_F(StereoTrackerTest, TheUpdatedTemplateIsFollowedFromWhereItWas) {
    ASSERT_TRUE(tracker_.set_template(pair_at(0), rectangle));
    ASSERT_TRUE(tracker_.start());
    for (int i = 0; i < 4; ++i) {
        tracker_.process(pair_at(i));
    }
    ASSERT_TRUE(tracker_.update_template());
    const TrackEstimate estimate = tracker_.process(pair_at(4));
    EXPECT_EQ(estimate.template_updates, 1);
    ASSERT_TRUE(estimate.position);
    EXPECT_LT((estimate.position->point_in_left_mm - truth_at(4)).norm(), 2.0);
}

TEST_F(StereoTrackerTest, WithOneCameraFollowsWithoutAPosition) {
    Rig mono = rig_;
    mono.right.reset();
    StereoTracker tracker(mono);
    StereoFrame pair = pair_at(0);
    pair.right = Frame{};
    ASSERT_TRUE(tracker.set_template(pair, rectangle));
    ASSERT_TRUE(tracker.start());
    pair = pair_at(1);
    pair.right = Frame{};
    const TrackEstimate estimate = tracker.process(pair);
    EXPECT_EQ(estimate.state, TrackState::tracking);
    ASSERT_TRUE(estimate.left_px);
    EXPECT_FALSE(estimate.position);
    const auto truth = rig_.left.project(rig_.left.T_camera_from_rig.inverse() * truth_at(1));
    EXPECT_LT((*estimate.left_px - *truth).norm(), 0.3);  // its change of size is not followed
}

}  // namespace
}  // namespace kambara
