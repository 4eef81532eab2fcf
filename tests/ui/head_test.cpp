// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QLineEdit>
#include <QtTest>
#include <cmath>

#include "core/base/angles.h"
#include "tests/ui/window_page.h"
#include "ui/devices/pan_tilt_pad.h"

namespace kambara {
namespace {

using testing_support::WindowPage;

class HeadInTheWindow : public testing::Test {
  protected:
    HeadInTheWindow() : page_(WindowPage::simulated(false)) {}
    void SetUp() override { ASSERT_TRUE(page_.until_picture()); }

    bool until_head_looks(double pan_deg, double tilt_deg) {
        return page_.until([&] {
            const auto& head = page_.shown().head;
            return head && std::abs(deg_from_rad(head->angles.pan_rad) - pan_deg) < 0.5 &&
                   std::abs(deg_from_rad(head->angles.tilt_rad) - tilt_deg) < 0.5;
        });
    }

    WindowPage page_;
};

TEST_F(HeadInTheWindow, ArrowKeysTurnItAndHomeBringsItHome) {
    page_.key(Qt::Key_Right);
    ASSERT_TRUE(until_head_looks(5.0, 0.0));
    EXPECT_FALSE(page_.shown().head->automatic);
    page_.key(Qt::Key_Up);
    ASSERT_TRUE(until_head_looks(5.0, 5.0));
    page_.key(Qt::Key_Left);
    ASSERT_TRUE(until_head_looks(0.0, 5.0));
    page_.key(Qt::Key_Down);
    ASSERT_TRUE(until_head_looks(0.0, 0.0));
    page_.key(Qt::Key_Right);
    ASSERT_TRUE(until_head_looks(5.0, 0.0));
    page_.key(Qt::Key_H);
    EXPECT_TRUE(until_head_looks(0.0, 0.0));
}

TEST_F(HeadInTheWindow, ThePadAsksForAPlace) {
    auto& pad = page_.part<ui::PanTiltPad>("panTiltPad");
    const HeadAngles wanted{rad_from_deg(40.0), rad_from_deg(-12.0)};
    QTest::mouseClick(&pad, Qt::LeftButton, Qt::NoModifier, pad.point_of(wanted).toPoint());
    const HeadAngles asked = pad.angles_at(pad.point_of(wanted).toPoint());
    EXPECT_NEAR(asked.pan_rad, wanted.pan_rad, rad_from_deg(1.5));
    EXPECT_TRUE(until_head_looks(deg_from_rad(asked.pan_rad), deg_from_rad(asked.tilt_rad)));
    EXPECT_TRUE(page_.until([&] { return page_.text("headAngles").contains("by hand"); }));
    // Outside the field it goes to its edge.
    EXPECT_EQ(pad.angles_at({-1000.0, -1000.0}).pan_rad, -HeadLimits{}.pan_rad);
    EXPECT_EQ(pad.angles_at({-1000.0, -1000.0}).tilt_rad, HeadLimits{}.tilt_rad);
}

TEST_F(HeadInTheWindow, SteerHandsItOverAndBack) {
    ASSERT_TRUE(page_.shown().head->automatic);
    ASSERT_TRUE(page_.until([&] { return page_.action("steer").isEnabled(); }));
    page_.key(Qt::Key_A);
    ASSERT_TRUE(page_.until([&] { return !page_.shown().head->automatic; }));
    page_.drag(page_.target());
    ASSERT_TRUE(page_.until_state(TrackState::tracking));
    const HeadAngles before = page_.shown().head->angles;
    const std::int64_t frame = page_.shown().frame;
    ASSERT_TRUE(page_.until([&] { return page_.shown().frame > frame + 15; }));
    EXPECT_EQ(page_.shown().head->angles, before);
    ASSERT_TRUE(page_.until([&] { return !page_.action("steer").isChecked(); }));
    page_.key(Qt::Key_A);
    ASSERT_TRUE(page_.until([&] { return page_.shown().head->automatic; }));
    EXPECT_TRUE(page_.until([&] { return page_.shown().head->angles != before; }));
}

TEST_F(HeadInTheWindow, TheStopKeyHaltsItFromAnywhere) {
    ASSERT_TRUE(page_.until([&] { return page_.action("halt").isEnabled(); }));
    auto& pad = page_.part<ui::PanTiltPad>("panTiltPad");
    QTest::mouseClick(&pad, Qt::LeftButton, Qt::NoModifier,
                      pad.point_of({rad_from_deg(95.0), 0.0}).toPoint());
    ASSERT_TRUE(page_.until([&] { return page_.shown().head->moving; }));
    // Even while a dialog has the keyboard.
    page_.window().open_recording_dialog();
    auto* dialog = page_.open_dialog();
    ASSERT_TRUE(dialog);
    auto* edit = dialog->findChild<QLineEdit*>(QStringLiteral("leftSource"));
    QTest::keyClick(edit, Qt::Key_F12);
    ASSERT_TRUE(page_.until([&] { return !page_.shown().head->moving; }));
    EXPECT_LT(deg_from_rad(page_.shown().head->angles.pan_rad), 90.0);
    EXPECT_FALSE(page_.shown().head->automatic);
    dialog->close();
}

}  // namespace
}  // namespace kambara
