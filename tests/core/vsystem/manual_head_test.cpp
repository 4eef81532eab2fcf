// SPDX-License-Identifier: GPL-3.0-or-later
// The head by hand through the vision system's door: what turns it takes it from steering.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "core/camera/nominal_rig.h"
#include "core/pointing/aim.h"
#include "core/vsystem/vision_system.h"
#include "tests/support/list_grabber.h"
#include "tests/support/textured_plane.h"
#include "tests/support/told_head.h"
#include "tests/support/wait_for_snapshot.h"

namespace kambara {
namespace {

using testing_support::drawn_pair;
using testing_support::ListGrabber;
using testing_support::TexturedPlane;
using testing_support::ToldHead;

class ManualHeadTest : public testing::Test {
  protected:
    void SetUp() override {
        const TexturedPlane plane{{60.0, 36.0, 1400.0}};
        StereoFrame pair = drawn_pair(plane, nominal_rig(), 0);
        std::vector<Frame> lefts(4, pair.left);
        std::vector<Frame> rights(4, pair.right);
        for (std::size_t i = 0; i < lefts.size(); ++i) {
            lefts[i].index = rights[i].index = static_cast<std::int64_t>(i);
            lefts[i].time_ns = rights[i].time_ns = static_cast<std::int64_t>(i) * 33'000'000;
        }
        VisionSystemParts parts{nominal_rig(), {}, head_};
        parts.grabbers.left = std::make_unique<ListGrabber>(lefts, 640, 480, std::nullopt);
        parts.grabbers.right = std::make_unique<ListGrabber>(rights, 640, 480, std::nullopt);
        VisionSystemOptions options;
        options.every_frame = true;
        options.start_paused = true;
        auto opened = open_vision_system(std::move(parts), options, clock_);
        ASSERT_TRUE(opened) << opened.error().text();
        system_ = std::move(*opened);
    }

    static bool until(const std::function<bool()>& is_so) {
        for (int i = 0; i < 400; ++i) {
            if (is_so()) {
                return true;
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
        return false;
    }
    const HeadSnapshot& head() {
        last_ = system_->latest();
        return last_->head.value();
    }

    SteadyClock clock_;
    std::shared_ptr<ToldHead> head_ = std::make_shared<ToldHead>();
    std::unique_ptr<VsystemInterface> system_;
    SnapshotPtr last_;
};

TEST_F(ManualHeadTest, WhatTurnsTheHeadTakesItFromSteeringUntilItIsHandedBack) {
    for (const Command& command :
         {Command(DriveHead{0.1, 0.0}), Command(HomeHead{}), Command(ResetHead{}),
          Command(RecallPreset{3}), Command(CentreHead{100.0, 100.0})}) {
        ASSERT_TRUE(system_->execute(SteerHead{true}));
        ASSERT_TRUE(head().automatic);
        ASSERT_TRUE(system_->execute(command));
        EXPECT_FALSE(head().automatic) << command.index();
    }
    // A target that is followed does not get the head, until it is given.
    const auto template_at = system_->execute(SelectTemplate{{300, 230, 31, 31}, std::nullopt});
    ASSERT_TRUE(template_at) << template_at.error().text();
    ASSERT_TRUE(system_->execute(StartTracking{}));
    EXPECT_EQ(steered_estimate(*system_->latest()).state, TrackState::tracking);
    EXPECT_EQ(head_->count("steer"), 0);
    ASSERT_TRUE(system_->execute(SteerHead{true}));
    ASSERT_TRUE(system_->execute(StartTracking{}));
    EXPECT_EQ(head_->count("steer"), 1);
}

TEST_F(ManualHeadTest, TheLensLeavesTheSteeringAsItIs) {
    for (const Command& command : {Command(ZoomHead{0.5}), Command(FocusHead{0.5}),
                                   Command(AutofocusHead{}), Command(KeepPreset{0})}) {
        ASSERT_TRUE(system_->execute(command));
        EXPECT_TRUE(head().automatic);
    }
    EXPECT_EQ(head_->lines().size(), 4U);
    ASSERT_TRUE(head().lens);
    EXPECT_EQ(*head().lens, *head_->lens());
    EXPECT_EQ(head().abilities, head_->abilities());
    EXPECT_EQ(head().limits, HeadLimits{});
}

TEST_F(ManualHeadTest, HandingItBackEndsADrive) {
    ASSERT_TRUE(system_->execute(DriveHead{0.1, 0.0}));
    ASSERT_TRUE(system_->execute(SteerHead{true}));
    EXPECT_EQ(head_->count("halt"), 1);
}

TEST_F(ManualHeadTest, FasterThanItCanIsAsFastAsItCan) {
    ASSERT_TRUE(system_->execute(DriveHead{99.0, -99.0}));
    EXPECT_EQ(head_->lines().back().with.pan_rad, HeadLimits{}.pan_speed_rad_s);
    EXPECT_EQ(head_->lines().back().with.tilt_rad, -HeadLimits{}.tilt_speed_rad_s);
}

TEST_F(ManualHeadTest, WhatTheHeadLacksIsRefusedWithTheReason) {
    head_->can({});
    for (const Command& command :
         {Command(DriveHead{0.1, 0.0}), Command(ResetHead{}), Command(ZoomHead{0.5}),
          Command(FocusHead{0.5}), Command(AutofocusHead{}), Command(KeepPreset{0}),
          Command(RecallPreset{0})}) {
        const auto refused = system_->execute(command);
        ASSERT_FALSE(refused) << command.index();
        EXPECT_NE(refused.error().cause.find("The head "), std::string::npos);
        EXPECT_FALSE(refused.error().remedy.empty());
    }
    EXPECT_TRUE(head().automatic) << "a refusal changes nothing";
    EXPECT_TRUE(head_->lines().empty());
    head_->can({true, true, true, true, true, 6});
    for (const Command& command :
         {Command(ZoomHead{1.5}), Command(FocusHead{-0.1}), Command(KeepPreset{6}),
          Command(RecallPreset{-1}), Command(DriveHead{std::nan(""), 0.0})}) {
        EXPECT_FALSE(system_->execute(command)) << command.index();
    }
}

TEST_F(ManualHeadTest, IsShownAlsoWhileNoPicturesCome) {
    const auto shown = [this](const std::function<bool(const HeadSnapshot&)>& so) {
        return until([&] { return so(head()); });
    };
    const auto at = [](double pan_rad) {
        return [=](const HeadSnapshot& head) { return head.angles.pan_rad == pan_rad; };
    };
    head_->say(HeadStatus{{0.3, 0.0}, true, 0});
    EXPECT_TRUE(shown(at(0.3))) << "paused";
    EXPECT_TRUE(head().moving);
    (void)testing_support::run_out(*system_);
    head_->say(HeadStatus{{0.4, 0.0}, false, 0});
    EXPECT_TRUE(shown(at(0.4))) << "at the end";
    head_->say(Error{"The line was lost.", "Plug it in."});
    EXPECT_TRUE(shown([](const HeadSnapshot& head) { return !head.fault.empty(); }));
    // What stays as it is is not shown again and again.
    std::atomic<int> count = 0;
    const auto observation = system_->observe([&](const SnapshotPtr&) { ++count; });
    std::this_thread::sleep_for(std::chrono::milliseconds(350));
    EXPECT_EQ(count, 0);
}

TEST_F(ManualHeadTest, ADriveThatEndedByItselfIsToldWhilePaused) {
    std::atomic<bool> told = false;
    const auto observation = system_->observe_events([&](const Event& event) {
        told = told || event.text.find("was halted") != std::string::npos;
    });
    ASSERT_TRUE(system_->execute(DriveHead{0.1, 0.0}));
    EXPECT_TRUE(until([&] { return told.load(); }));
    EXPECT_EQ(head_->count("halt"), 1);
}

class HeadOfShortReach : public ManualHeadTest {
  protected:
    HeadOfShortReach() { head_->reach.pan_rad = 0.001; }
};

TEST_F(HeadOfShortReach, ByHandNothingIsBeyondIt) {
    ASSERT_TRUE(system_->execute(SelectTemplate{{300, 230, 31, 31}, std::nullopt}));
    for (const Command& by_hand : {Command(HaltHead{}), Command(SteerHead{false}),
                                   Command(MoveHead{}), Command(DriveHead{0.1, 0.0})}) {
        ASSERT_TRUE(system_->execute(SteerHead{true}));
        ASSERT_TRUE(system_->execute(StartTracking{}));
        ASSERT_TRUE(head().at_limit);
        ASSERT_TRUE(system_->execute(by_hand));
        EXPECT_FALSE(head().at_limit) << by_hand.index();
    }
    ASSERT_TRUE(system_->execute(SteerHead{true}));
    ASSERT_TRUE(system_->execute(StartTracking{}));
    ASSERT_TRUE(system_->execute(HaltHead{}));
    ASSERT_TRUE(system_->execute(Flow{Flow::Kind::step}));
    ASSERT_TRUE(until([&] { return system_->latest()->frame == 1; }));
    EXPECT_EQ(steered_estimate(*system_->latest()).state, TrackState::tracking);
    EXPECT_FALSE(head().at_limit);
}

TEST_F(ManualHeadTest, WhatIsSeenAtAPixelComesToTheMiddle) {
    const Rig rig = nominal_rig();
    const HeadAngles from{0.3, -0.1};
    const Eigen::Vector3d point_in_rig_mm(900.0, 500.0, 1600.0);
    // How the zoomed camera sees the point once it is turned about its centre.
    const Eigen::Vector3d at_home = rig.pan_tilt->T_camera_from_rig * point_in_rig_mm;
    const Eigen::Vector3d seen =
        (rotation_about_y(from.pan_rad) * rotation_about_x(from.tilt_rad)).transpose() * at_home;
    const double magnified = std::tan(0.5 * 0.5) / std::tan(0.5 * 0.25);
    const auto lens = pinhole_parameters(rig.pan_tilt->lens);
    const double x_px = lens.cx_px + magnified * lens.fx_px * seen.x() / seen.z();
    const double y_px = lens.cy_px + magnified * lens.fy_px * seen.y() / seen.z();
    ASSERT_TRUE(rig.pan_tilt->sees({x_px, y_px})) << x_px << " " << y_px;
    ASSERT_TRUE(system_->execute(CentreHead{x_px, y_px, from}));
    ASSERT_EQ(head_->lines().back().what, "look");
    EXPECT_LT(aiming_error_rad(rig, head_->lines().back().with,
                               rig.left.T_camera_from_rig * point_in_rig_mm),
              1e-9);
    // What is beyond its reach: as far as it can.
    ASSERT_TRUE(system_->execute(CentreHead{320.0, 0.0, HeadAngles{0.0, rad_from_deg(25.0)}}));
    EXPECT_EQ(head_->lines().back().with.tilt_rad, rad_from_deg(25.0));
}

}  // namespace
}  // namespace kambara
