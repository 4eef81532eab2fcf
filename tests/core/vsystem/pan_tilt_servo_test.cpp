// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/vsystem/pan_tilt_servo.h"

#include <gtest/gtest.h>

#include <memory>

#include "core/camera/nominal_rig.h"
#include "core/pointing/aim.h"
#include "core/pointing/pan_tilt_view.h"
#include "tests/support/textured_plane.h"

namespace kambara {
namespace {

using testing_support::drawn;
using testing_support::drawn_pair;
using testing_support::TexturedPlane;

// A target that stands still and is followed by the stereo pair; the pan-tilt camera is mounted
// otherwise than the rig file says.
class PanTiltServoTest : public testing::Test {
  protected:
    void SetUp() override {
        ASSERT_TRUE(stereo_.set_template(drawn_pair(plane_, rig_, 0), {300, 230, 31, 31}));
        ASSERT_TRUE(stereo_.start());
        stereo_.process(drawn_pair(plane_, rig_, 1));
        ASSERT_EQ(stereo_.estimate().state, TrackState::tracking);
        ASSERT_TRUE(stereo_.estimate().position);
        angles_ = angles_towards(rig_, stereo_.estimate().position->point_in_left_mm);
        ASSERT_TRUE(servo_.set_on(true));
    }
    /// The next picture of a camera that is turned so much farther than is known; empty: all grey.
    TrackState see(std::optional<double> off_deg) {
        const Camera camera = pan_tilt_camera_at(
            rig_, {angles_.pan_rad + rad_from_deg(off_deg.value_or(0.0)), angles_.tilt_rad});
        TexturedPlane plane = plane_;
        plane.contrast_grey = off_deg ? plane.contrast_grey : 0.0;
        Frame frame;
        frame.picture = std::make_shared<const Image>(drawn(plane, camera));
        frame.index = ++index_;
        frame.time_ns = index_ * 33'000'000;
        servo_.see({frame, angles_, &stereo_, 1});
        return servo_.state(false).state;
    }

    const Rig rig_ = nominal_rig();
    const TexturedPlane plane_{{60.0, 36.0, 1400.0}};
    StereoTracker stereo_{rig_, TrackerOptions{}};
    PanTiltServo servo_{rig_, TrackerOptions{}};
    HeadAngles angles_;
    std::int64_t index_ = 0;
};

TEST_F(PanTiltServoTest, WhatIsLostIsSoonLookedForByThePairsLook) {
    ASSERT_EQ(see(3.0), TrackState::tracking);
    EXPECT_EQ(see(3.0), TrackState::tracking);
    // By itself it is sure again only in the third picture after it is back.
    EXPECT_NE(see(std::nullopt), TrackState::tracking);
    EXPECT_NE(see(std::nullopt), TrackState::tracking);
    EXPECT_EQ(see(-3.0), TrackState::tracking) << "the third picture since it was lost";
}

}  // namespace
}  // namespace kambara
