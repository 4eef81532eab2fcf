// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QCheckBox>
#include <QLineEdit>
#include <QMouseEvent>
#include <QSlider>
#include <QSpinBox>
#include <QThread>
#include <QToolButton>
#include <QWheelEvent>
#include <QtTest>
#include <cmath>

#include "core/base/angles.h"
#include "core/pointing/pan_tilt_view.h"
#include "tests/support/fake_gamepad.h"
#include "tests/ui/window_page.h"
#include "ui/devices/head_stick.h"
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

TEST_F(HeadInTheWindow, ArrowKeysTurnItAsLongAsTheyArePressed) {
    ASSERT_TRUE(page_.until([&] { return page_.action("home").isEnabled(); }));
    struct Way {
        Qt::Key key;
        int pan;
        int tilt;
    };
    for (const Way& way : {Way{Qt::Key_Right, 1, 0}, Way{Qt::Key_Up, 0, 1},
                           Way{Qt::Key_Left, -1, 0}, Way{Qt::Key_Down, 0, -1}}) {
        const HeadAngles from = page_.shown().head->angles;
        QTest::keyPress(&page_.left(), way.key);
        ASSERT_TRUE(page_.until([&] {
            const HeadAngles at = page_.shown().head->angles;
            return way.pan * (at.pan_rad - from.pan_rad) +
                       way.tilt * (at.tilt_rad - from.tilt_rad) >
                   rad_from_deg(3.0);
        })) << way.key;
        EXPECT_FALSE(page_.shown().head->automatic);
        // A key that repeats says nothing new.
        QKeyEvent repeated(QEvent::KeyRelease, way.key, Qt::NoModifier, QString(), true);
        QApplication::sendEvent(&page_.left(), &repeated);
        EXPECT_TRUE(page_.shown().head->moving);
        QTest::keyRelease(&page_.left(), way.key);
        ASSERT_TRUE(page_.until([&] { return !page_.shown().head->moving; }));
    }
    page_.key(Qt::Key_H);
    EXPECT_TRUE(until_head_looks(0.0, 0.0));
}

TEST_F(HeadInTheWindow, ArrowKeysHaltWhenTheKeyboardGoesElsewhere) {
    ASSERT_TRUE(page_.until([&] { return page_.action("home").isEnabled(); }));
    page_.left().setFocus();
    QTest::keyPress(&page_.left(), Qt::Key_Right);
    ASSERT_TRUE(page_.until([&] { return page_.shown().head->moving; }));
    auto& slider = page_.part<QSlider>("zoomSlider");
    slider.setFocus();
    ASSERT_TRUE(page_.until([&] { return !page_.shown().head->moving; }));
    // Here they are the slider's.
    const HeadAngles at = page_.shown().head->angles;
    QTest::keyClick(&slider, Qt::Key_Right, Qt::NoModifier);
    ASSERT_TRUE(page_.until([&] { return page_.shown().head->lens->zoom_share > 0.01; }));
    EXPECT_EQ(page_.shown().head->angles, at);
    // And those of a rectangle that is being placed.
    page_.left().begin_selection();
    QTest::keyPress(&page_.left(), Qt::Key_Right);
    const std::int64_t frame = page_.shown_right().frame;
    ASSERT_TRUE(page_.until([&] { return page_.shown_right().frame > frame + 10; }));
    EXPECT_EQ(page_.shown_right().head->angles, at);
    QTest::keyRelease(&page_.left(), Qt::Key_Right);
}

TEST_F(HeadInTheWindow, TheStickTurnsItTheFasterTheFartherItIsHeld) {
    auto& stick = page_.part<ui::HeadStick>("headStick");
    ASSERT_TRUE(page_.until([&] { return stick.isEnabled(); }));
    const QPoint middle = stick.rect().center();
    EXPECT_EQ(stick.deflection_at(QRectF(stick.rect()).center()), QPointF(0.0, 0.0));
    const double half = stick.deflection_at(middle + QPoint(20, 0)).x();
    EXPECT_GT(half, 0.1);
    EXPECT_GT(stick.deflection_at(middle + QPoint(35, 0)).x(), 2.0 * half);
    EXPECT_GT(stick.deflection_at(middle + QPoint(0, -30)).y(), 0.3) << "up";
    EXPECT_NEAR(stick.deflection_at(middle + QPoint(500, 0)).x(), 1.0, 0.02);
    QTest::mousePress(&stick, Qt::LeftButton, Qt::NoModifier, middle + QPoint(-40, 0));
    ASSERT_TRUE(
        page_.until([&] { return page_.shown().head->angles.pan_rad < rad_from_deg(-4.0); }));
    QTest::mouseRelease(&stick, Qt::LeftButton, Qt::NoModifier, middle + QPoint(-40, 0));
    ASSERT_TRUE(page_.until([&] { return !page_.shown().head->moving; }));
    // Halted from the keyboard it stands, though it is still pressed.
    QTest::mousePress(&stick, Qt::LeftButton, Qt::NoModifier, middle + QPoint(40, 0));
    ASSERT_TRUE(page_.until([&] { return page_.shown().head->moving; }));
    page_.key(Qt::Key_F12);
    ASSERT_TRUE(page_.until([&] { return !page_.shown().head->moving; }));
    QMouseEvent tremble(QEvent::MouseMove, middle + QPoint(41, 0),
                        stick.mapToGlobal(middle + QPoint(41, 0)), Qt::NoButton, Qt::LeftButton,
                        Qt::NoModifier);
    QApplication::sendEvent(&stick, &tremble);
    const HeadAngles halted = page_.shown().head->angles;
    const std::int64_t frame = page_.shown().frame;
    ASSERT_TRUE(page_.until([&] { return page_.shown().frame > frame + 10; }));
    EXPECT_EQ(page_.shown().head->angles, halted);
    QTest::mouseRelease(&stick, Qt::LeftButton, Qt::NoModifier, middle);
}

TEST_F(HeadInTheWindow, AWindowThatHangsLetsTheHeadGo) {
    auto& stick = page_.part<ui::HeadStick>("headStick");
    ASSERT_TRUE(page_.until([&] { return stick.isEnabled(); }));
    const QPoint right = stick.rect().center() + QPoint(40, 0);
    QTest::mousePress(&stick, Qt::LeftButton, Qt::NoModifier, right);
    ASSERT_TRUE(page_.until([&] { return page_.shown().head->moving; }));
    const double before_rad = page_.shown().head->angles.pan_rad;
    QThread::msleep(1500);  // the window's thread: nothing is said for so long
    QTest::mouseRelease(&stick, Qt::LeftButton, Qt::NoModifier, right);
    ASSERT_TRUE(page_.until([&] { return page_.events().tells("halted"); }));
    ASSERT_TRUE(page_.until([&] { return !page_.shown().head->moving; }));
    // At 24 degrees a second: 36 in that time, a fifth of a second's worth and what was on its way
    // when it was let go.
    EXPECT_LT(deg_from_rad(page_.shown().head->angles.pan_rad - before_rad), 15.0);
}

TEST_F(HeadInTheWindow, AClickInThePanTiltPictureBringsItToTheMiddle) {
    auto& view = page_.part<ui::VideoView>("panTiltView");
    ASSERT_TRUE(
        page_.until([&] { return view.shown() && view.shown()->pictures.pan_tilt.picture; }));
    page_.key(Qt::Key_A);  // by hand
    ASSERT_TRUE(page_.until([&] { return !page_.shown().head->automatic; }));
    const Rig rig = page_.world().rig();
    const Eigen::Vector2d pixel(480.0, 200.0);
    const QPoint place = view.view().widget_from_pixel({pixel.x(), pixel.y()}).toPoint();
    const QPointF clicked = view.view().pixel_from_widget(place);
    const auto expected =
        angles_to_centre(rig, view.shown()->head->angles, {clicked.x(), clicked.y()}, 2000.0);
    ASSERT_TRUE(expected);
    QTest::mouseClick(&view, Qt::LeftButton, Qt::NoModifier, place);
    EXPECT_TRUE(
        until_head_looks(deg_from_rad(expected->pan_rad), deg_from_rad(expected->tilt_rad)));
    EXPECT_GT(deg_from_rad(expected->pan_rad), 5.0);
    EXPECT_GT(deg_from_rad(expected->tilt_rad), 1.0);
}

TEST_F(HeadInTheWindow, ZoomFocusAndPresetsByThePanel) {
    auto& zoom = page_.part<QSlider>("zoomSlider");
    auto& focus = page_.part<QSlider>("focusSlider");
    auto& autofocus = page_.part<QCheckBox>("autofocus");
    ASSERT_TRUE(page_.until([&] { return zoom.isEnabled(); }));
    const auto lens = [&] { return page_.shown().head->lens.value(); };
    zoom.setValue(500);
    ASSERT_TRUE(page_.until([&] { return std::abs(lens().zoom_share - 0.5) < 1e-6; }));
    EXPECT_TRUE(page_.until([&] { return page_.text("zoomView").startsWith("3.5"); }));
    EXPECT_TRUE(page_.shown().head->automatic) << "the lens is not the steering";
    ASSERT_TRUE(page_.until([&] { return autofocus.isChecked(); }));
    focus.setValue(700);
    ASSERT_TRUE(page_.until([&] { return std::abs(lens().focus_share - 0.7) < 1e-6; }));
    EXPECT_TRUE(page_.until([&] { return !autofocus.isChecked(); }));
    page_.part<QSpinBox>("preset").setValue(3);
    page_.part<QToolButton>("keepPreset").click();
    autofocus.click();
    ASSERT_TRUE(page_.until([&] { return lens().autofocus; }));
    zoom.setValue(0);
    auto& pad = page_.part<ui::PanTiltPad>("panTiltPad");
    QTest::mouseClick(&pad, Qt::LeftButton, Qt::NoModifier,
                      pad.point_of({rad_from_deg(30.0), 0.0}).toPoint());
    ASSERT_TRUE(page_.until([&] { return page_.shown().head->angles.pan_rad > 0.4; }));
    ASSERT_TRUE(page_.until([&] { return lens().zoom_share == 0.0; }));
    page_.part<QToolButton>("recallPreset").click();
    ASSERT_TRUE(until_head_looks(0.0, 0.0));
    EXPECT_TRUE(page_.until([&] { return std::abs(lens().zoom_share - 0.5) < 1e-6; }));
    EXPECT_TRUE(page_.until([&] { return !lens().autofocus; }));
    // The slider shows where the recall has brought it.
    EXPECT_TRUE(page_.until([&] { return zoom.value() == 500; }));
    page_.part<QToolButton>("zoomIn").click();
    EXPECT_TRUE(page_.until([&] { return std::abs(lens().zoom_share - 0.55) < 0.005; }));
}

TEST(GamepadInTheWindow, TurnsTheHeadOnceItsSticksWereLetGo) {
    const auto gamepad = std::make_shared<testing_support::FakeGamepad>();
    ui::WindowOptions options = WindowPage::simulated(false);
    options.gamepad = gamepad;
    WindowPage page(options);
    ASSERT_TRUE(page.until_picture());
    EXPECT_EQ(page.text("statusGamepad"), "no gamepad");
    gamepad->stick(1.0, 0.0);
    gamepad->plug_in();
    ASSERT_TRUE(
        page.until([&] { return page.text("statusGamepad").contains("let the sticks go"); }));
    EXPECT_TRUE(page.text("statusGamepad").startsWith("fake pad"));
    EXPECT_TRUE(page.shown().head->automatic);
    gamepad->stick(0.0, 0.0);
    ASSERT_TRUE(page.until([&] { return page.text("statusGamepad") == "fake pad: ready"; }));
    gamepad->stick(0.0, 1.0);
    ASSERT_TRUE(page.until([&] { return page.shown().head->angles.tilt_rad > rad_from_deg(3.0); }));
    EXPECT_FALSE(page.shown().head->automatic);
    gamepad->plug_in(false);
    ASSERT_TRUE(page.until([&] { return !page.shown().head->moving; }));
    EXPECT_EQ(page.text("statusGamepad"), "no gamepad");
    EXPECT_LT(page.shown().head->angles.tilt_rad, rad_from_deg(25.0)) << "not by its stop";
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

TEST_F(HeadInTheWindow, TheTargetIsFollowedInItsPictureByChoice) {
    page_.drag(page_.target());
    ASSERT_TRUE(page_.until_state(TrackState::tracking));
    ASSERT_TRUE(page_.until([&] { return page_.action("servo").isEnabled(); }));
    EXPECT_FALSE(page_.shown().servo);
    page_.key(Qt::Key_A, Qt::ShiftModifier);
    ASSERT_TRUE(page_.until([&] { return page_.shown().servo && page_.shown().servo->on; }));
    EXPECT_TRUE(page_.until([&] { return page_.action("servo").isChecked(); }));
    EXPECT_TRUE(page_.until([&] {
        return page_.shown().servo->pan_tilt_px &&
               page_.text("headNote") == "Followed in the pan-tilt picture, too.";
    }));
    page_.key(Qt::Key_A, Qt::ShiftModifier);
    ASSERT_TRUE(page_.until([&] { return !page_.shown().servo; }));
    EXPECT_TRUE(page_.until([&] { return !page_.action("servo").isChecked(); }));
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

TEST_F(HeadInTheWindow, StaysTakenByHandWhenAnotherSourceIsOpened) {
    ASSERT_TRUE(page_.until([&] { return page_.action("home").isEnabled(); }));
    EXPECT_TRUE(page_.until([&] {
        return page_.text("headAngles").contains("waits for a target");
    })) << page_.text("headAngles").toStdString();
    page_.action("steer").trigger();
    ASSERT_TRUE(page_.until([&] { return !page_.shown().head->automatic; }));
    page_.action("simulatedRig").trigger();
    ASSERT_TRUE(page_.until([&] { return page_.left().shown() == nullptr; }));
    ASSERT_TRUE(page_.until_picture());
    EXPECT_TRUE(page_.until([&] { return !page_.shown().head->automatic; }, 5));
    EXPECT_TRUE(page_.until([&] { return !page_.action("steer").isChecked(); }, 5));
}

TEST_F(HeadInTheWindow, ItsButtonsStayInSightAndInTheirPlaces) {
    page_.window().resize(1600, 950);
    ASSERT_TRUE(page_.until([&] { return page_.action("halt").isEnabled(); }));
    const auto place_of = [&](const char* action) {
        for (QToolButton* button : page_.part<QWidget>("headPanel").findChildren<QToolButton*>()) {
            if (button->defaultAction() == &page_.action(action)) {
                return button->visibleRegion().boundingRect().size() == button->size()
                           ? button->mapTo(&page_.window(), QPoint())
                           : QPoint(-1, -1);
            }
        }
        return QPoint(-2, -2);
    };
    const QPoint halt = place_of("halt");
    EXPECT_GE(halt.x(), 0) << "all of it can be seen";
    EXPECT_GE(place_of("steer").x(), 0);
    page_.part<QLabel>("headNote")
        .setText(
            "A sentence that goes on for much more than one line of "
            "the panel, as those of broken lines do.");
    page_.until([] { return false; }, 1);
    EXPECT_EQ(place_of("halt"), halt);
}

TEST_F(HeadInTheWindow, TheWheelOverTheNextFieldChangesNothing) {
    ASSERT_TRUE(page_.until([&] { return page_.action("home").isEnabled(); }));
    page_.left().setFocus();
    for (const char* name : {"driveSpeed", "zoomSlider", "focusSlider"}) {
        auto& slider = page_.part<QSlider>(name);
        const int before = slider.value();
        const QPointF at(0.5 * slider.width(), 0.5 * slider.height());
        QWheelEvent wheel(at, slider.mapToGlobal(at.toPoint()), {}, {0, 240}, Qt::NoButton,
                          Qt::NoModifier, Qt::NoScrollPhase, false);
        QApplication::sendEvent(&slider, &wheel);
        EXPECT_EQ(slider.value(), before) << name;
        EXPECT_FALSE(slider.hasFocus()) << name;
    }
}

TEST_F(HeadInTheWindow, LettersAreTheWindowsKeysInTheBoxOfPresets) {
    ASSERT_TRUE(page_.until([&] { return page_.action("steer").isChecked(); }));
    auto& preset = page_.part<QSpinBox>("preset");
    ASSERT_TRUE(page_.until([&] { return preset.maximum() >= 3; }));
    preset.setFocus();
    preset.selectAll();
    QTest::keyClick(&preset, Qt::Key_3);
    EXPECT_EQ(preset.value(), 3);
    QTest::keyClick(&preset, Qt::Key_A);
    EXPECT_TRUE(page_.until([&] { return !page_.shown().head->automatic; }));
}

}  // namespace
}  // namespace kambara
