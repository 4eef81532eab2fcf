// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QElapsedTimer>

#include "tests/ui/window_page.h"

namespace kambara {
namespace {

using testing_support::WindowPage;

// The target is measured where the truth has it, the head turns to it, and every part shows it.
void expect_target_on_show(WindowPage& page) {
    ASSERT_TRUE(page.until_state(TrackState::tracking));
    ASSERT_TRUE(page.until([&] { return page.text("positionZ").contains("mm"); }));
    const Snapshot shown = page.shown();
    const auto& estimate = shown.tracks.front().estimate;
    ASSERT_TRUE(estimate.position);
    const auto target = page.world().target_point_under(*estimate.left_px, shown.frame);
    ASSERT_TRUE(target) << "what is tracked is not the target";
    const Eigen::Vector3d truth = page.world().point_in_left_mm(*target, shown.frame);
    EXPECT_LT((estimate.position->point_in_left_mm - truth).norm(), 0.015 * truth.norm());
    EXPECT_TRUE(page.until([&] {
        return page.shown().head && page.shown().head->angles.pan_rad != 0.0 &&
               page.text("headAngles").contains("steered");
    }));
    EXPECT_EQ(page.text("trackState"), "Tracking");
    EXPECT_TRUE(page.text("quality").contains("%"));
    EXPECT_TRUE(page.map().has_map());
    if (page.scene().works()) {
        EXPECT_TRUE(page.until([&] { return page.scene().trail_points() > 5; }));
    }
    EXPECT_TRUE(page.until([&] { return page.plots().samples_shown() > 5; }));
    EXPECT_EQ(page.shown_right().frame, page.shown().frame);
}

TEST(TrackingInTheWindow, OneDragFromLaunchToATrackedTargetWithinTwentySeconds) {
    QElapsedTimer since_launch;
    since_launch.start();
    WindowPage page(WindowPage::simulated());
    ASSERT_TRUE(page.until_picture());
    page.drag(page.target());
    expect_target_on_show(page);
    EXPECT_LT(since_launch.elapsed(), 20000);
}

TEST(TrackingInTheWindow, WithTheKeyboardAlone) {
    WindowPage page(WindowPage::simulated());
    ASSERT_TRUE(page.until_picture());
    page.key(Qt::Key_T);
    ASSERT_TRUE(page.left().selecting());
    const Rectangle target = page.target();
    const Snapshot shown = page.shown();
    const int dx = target.x + target.width / 2 - shown.pictures.stereo.left.picture->width() / 2;
    const int dy = target.y + target.height / 2 - shown.pictures.stereo.left.picture->height() / 2;
    page.key(dx > 0 ? Qt::Key_Right : Qt::Key_Left, Qt::NoModifier, std::abs(dx) / 10);
    page.key(dx > 0 ? Qt::Key_Right : Qt::Key_Left, Qt::ControlModifier, std::abs(dx) % 10);
    page.key(dy > 0 ? Qt::Key_Down : Qt::Key_Up, Qt::NoModifier, std::abs(dy) / 10);
    page.key(dy > 0 ? Qt::Key_Down : Qt::Key_Up, Qt::ControlModifier, std::abs(dy) % 10);
    page.key(Qt::Key_Down, Qt::ShiftModifier | Qt::ControlModifier, 4);  // not so tall
    page.key(Qt::Key_Left, Qt::ShiftModifier | Qt::ControlModifier, 4);  // nor so wide
    page.key(Qt::Key_Return);
    EXPECT_FALSE(page.left().selecting());
    expect_target_on_show(page);
}

// The moving target and a piece of the seabed.
TEST(TrackingInTheWindow, CtrlAddsASecondTargetAndSteersToIt) {
    WindowPage page(WindowPage::simulated(false));
    ASSERT_TRUE(page.until_picture());
    page.drag(page.target());
    ASSERT_TRUE(page.until_state(TrackState::tracking));
    ASSERT_TRUE(page.until([&] { return page.text("steeredTarget") == "number 1"; }));
    page.drag({100, 350, 31, 31}, Qt::ControlModifier);
    ASSERT_TRUE(page.until([&] { return page.shown().tracks.size() == 2; }));
    EXPECT_EQ(page.shown().tracks[1].id, 2);
    EXPECT_EQ(page.shown().steered_target, 1);
    ASSERT_TRUE(page.until([&] { return page.shown().tracks[1].estimate.left_px.has_value(); }));

    page.click({12.0, 12.0}, Qt::ControlModifier);  // on no target: nothing is asked for
    page.click(*page.shown().tracks[1].estimate.left_px, Qt::ControlModifier);
    ASSERT_TRUE(page.until([&] { return page.shown().steered_target == 2; }));
    EXPECT_TRUE(page.until([&] { return page.text("steeredTarget") == "number 2, one of 2"; }));
    EXPECT_TRUE(page.events().tells("The head is steered to target 2 now."));
    ASSERT_TRUE(page.until_state(TrackState::tracking));
    // The seabed's piece is to the left of where the head is mounted.
    EXPECT_TRUE(page.until([&] { return page.shown().head->angles.pan_rad < -0.2; }));

    page.key(Qt::Key_Delete);
    EXPECT_TRUE(page.until([&] { return page.shown().tracks.empty(); }));
    EXPECT_TRUE(page.until([&] { return page.text("trackState") == "Idle"; }));
}

TEST(TrackingInTheWindow, CtrlEnterTakesTheRectangleForOneMoreTarget) {
    WindowPage page(WindowPage::simulated(false));
    ASSERT_TRUE(page.until_picture());
    page.drag(page.target());
    ASSERT_TRUE(page.until_state(TrackState::tracking));
    page.key(Qt::Key_T);
    ASSERT_TRUE(page.left().selecting());
    page.key(Qt::Key_Down, Qt::NoModifier, 15);
    page.key(Qt::Key_Return, Qt::ControlModifier);
    EXPECT_TRUE(page.until([&] { return page.shown().tracks.size() == 2; }));
    EXPECT_EQ(page.shown().steered_target, 1);
}

TEST(TrackingInTheWindow, EscapeStopsAndStartGoesOn) {
    WindowPage page(WindowPage::simulated(false));
    ASSERT_TRUE(page.until_picture());
    page.drag(page.target());
    ASSERT_TRUE(page.until_state(TrackState::tracking));
    page.key(Qt::Key_Escape);
    ASSERT_TRUE(page.until_state(TrackState::template_set));
    EXPECT_TRUE(page.until([&] { return !page.shown().head->automatic; }));
    ASSERT_TRUE(page.until([&] { return page.action("startTracking").isEnabled(); }));
    page.key(Qt::Key_Delete);
    EXPECT_TRUE(page.until([&] { return page.shown().tracks.empty(); }));
    EXPECT_TRUE(page.until([&] { return page.text("trackState") == "Idle"; }));
}

TEST(TrackingInTheWindow, SelectsInAFrozenPictureHoweverOld) {
    WindowPage page(WindowPage::simulated(false));
    ASSERT_TRUE(page.until_picture());
    page.action("freeze").trigger();
    ASSERT_TRUE(page.left().frozen());
    const std::int64_t frozen = page.shown().frame;
    const Rectangle target = page.target();
    // More pairs go by than the pipeline remembers by itself.
    ASSERT_TRUE(page.until([&] { return page.shown_right().frame > frozen + 40; }));
    EXPECT_EQ(page.shown().frame, frozen);
    page.drag(target);
    EXPECT_FALSE(page.left().frozen());
    EXPECT_TRUE(page.until([&] { return !page.shown().tracks.empty(); }));
    EXPECT_NE(page.shown().tracks.front().estimate.state, TrackState::idle);
}

TEST(TrackingInTheWindow, ARefusedRectangleSaysWhyAndLosesNothing) {
    WindowPage page(WindowPage::simulated(false));
    ASSERT_TRUE(page.until_picture());
    page.drag({4, 4, 25, 25});  // open water
    ASSERT_TRUE(page.until([&] { return page.part<QLabel>("notice").isVisible(); }));
    EXPECT_TRUE(page.text("notice").contains("texture")) << page.text("notice").toStdString();
    EXPECT_TRUE(page.events().tells("texture"));
    EXPECT_TRUE(page.shown().tracks.empty());
}

}  // namespace
}  // namespace kambara
