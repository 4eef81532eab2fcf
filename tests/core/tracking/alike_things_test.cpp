// SPDX-License-Identifier: GPL-3.0-or-later
// Two things that look exactly the same, on a dull background: the tracker must not go over from
// one to the other.
#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "core/camera/nominal_rig.h"
#include "core/tracking/stereo_tracker.h"
#include "tests/support/textured_plane.h"

namespace kambara {
namespace {

using testing_support::drawn;
using testing_support::TexturedPlane;

constexpr int side_px = 41;
const Rectangle cut_from{300, 220, side_px, side_px};

// Where to the right nothing can tell them apart.
Rig one_camera() {
    Rig rig = nominal_rig();
    rig.right.reset();
    return rig;
}

class AlikeThings : public testing::Test {
  protected:
    AlikeThings()
        : rig_(one_camera()), tracker_(rig_), pattern_(drawn(TexturedPlane{}, rig_.left)) {
        TexturedPlane dull;
        dull.contrast_grey = 8.0;
        dull.origin_in_rig_mm = {1234.0, 777.0, 1500.0};
        background_ = drawn(dull, rig_.left);
    }

    Frame with(const std::vector<Eigen::Vector2i>& corners_px, int index) const {
        Image picture = background_;
        for (const Eigen::Vector2i& corner : corners_px) {
            for (int y = 0; y < side_px; ++y) {
                for (int x = 0; x < side_px; ++x) {
                    picture.row(corner.y() + y)[corner.x() + x] =
                        pattern_.at(cut_from.x + x, cut_from.y + y);
                }
            }
        }
        Frame frame;
        frame.picture = std::make_shared<const Image>(std::move(picture));
        frame.index = index;
        frame.time_ns = index * 33'333'333LL;
        return frame;
    }

    StereoFrame pair(const std::vector<Eigen::Vector2i>& corners_px) {
        return {with(corners_px, next_++), Frame{}};
    }

    void choose(const Eigen::Vector2i& at, const std::vector<Eigen::Vector2i>& all) {
        const auto chosen =
            tracker_.set_template(pair(all), {at.x() + 5, at.y() + 5, side_px - 10, side_px - 10});
        ASSERT_TRUE(chosen) << chosen.error().cause;
        ASSERT_TRUE(tracker_.start());
    }

    bool is_at(const TrackEstimate& estimate, const Eigen::Vector2i& corner) const {
        const Eigen::Vector2d middle =
            corner.cast<double>() + Eigen::Vector2d::Constant(0.5 * (side_px - 1));
        return estimate.left_px && (*estimate.left_px - middle).norm() < 2.0;
    }

    Rig rig_;
    StereoTracker tracker_;
    Image pattern_;
    Image background_;
    int next_ = 0;
};

TEST_F(AlikeThings, TheOneThatMovesIsFollowedPastTheOther) {
    const Eigen::Vector2i other(320, 200);
    choose({180, 230}, {{180, 230}, other});
    for (int i = 1; i <= 70; ++i) {
        const Eigen::Vector2i here(180 + 4 * i, 250);  // it passes 9 px below the other's edge
        const TrackEstimate estimate = tracker_.process(pair({here, other}));
        ASSERT_EQ(estimate.state, TrackState::tracking) << i << ": " << estimate.reason;
        ASSERT_TRUE(is_at(estimate, here)) << i;
    }
}

TEST_F(AlikeThings, WhereOneVanishesTheOtherIsNotTakenForIt) {
    const Eigen::Vector2i here(200, 230);
    const Eigen::Vector2i other(340, 230);
    choose(here, {here, other});
    for (int i = 0; i < 10; ++i) {
        ASSERT_TRUE(is_at(tracker_.process(pair({here, other})), here));
    }
    for (int i = 0; i < 4; ++i) {
        const TrackEstimate estimate = tracker_.process(pair({other}));
        EXPECT_NE(estimate.state, TrackState::tracking) << i;
    }
    // Back where it was, it is told from its like by its place.
    TrackEstimate estimate;
    for (int i = 0; i < 3; ++i) {
        estimate = tracker_.process(pair({here, other}));
    }
    EXPECT_EQ(estimate.state, TrackState::tracking) << estimate.reason;
    EXPECT_TRUE(is_at(estimate, here));
}

TEST_F(AlikeThings, AfterALongLossNeitherIsTaken) {
    const Eigen::Vector2i here(200, 230);
    choose(here, {here});
    for (int i = 0; i < 10; ++i) {
        ASSERT_EQ(tracker_.process(pair({here})).state, TrackState::tracking);
    }
    for (int i = 0; i < 60; ++i) {
        ASSERT_EQ(tracker_.process(pair({})).state, TrackState::lost);
    }
    for (int i = 0; i < 20; ++i) {
        const TrackEstimate estimate = tracker_.process(pair({{100, 100}, {440, 330}}));
        EXPECT_NE(estimate.state, TrackState::tracking) << i;
    }
    TrackEstimate estimate;
    for (int i = 0; i < 20 && estimate.state != TrackState::tracking; ++i) {
        estimate = tracker_.process(pair({{440, 330}}));
    }
    EXPECT_EQ(estimate.state, TrackState::tracking) << estimate.reason;
    EXPECT_TRUE(is_at(estimate, {440, 330}));
}

}  // namespace
}  // namespace kambara
