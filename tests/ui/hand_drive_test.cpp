// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/devices/hand_drive.h"

#include <gtest/gtest.h>

#include <QElapsedTimer>
#include <QSignalSpy>
#include <QtTest>

#include "tests/support/fake_gamepad.h"

namespace kambara {
namespace {

using testing_support::FakeGamepad;
using ui::HandDrive;
using Source = HandDrive::Source;

class HandDriveTest : public testing::Test {
  protected:
    HandDriveTest() {
        head_.abilities = {true, true, true, true, true, 6};
        head_.lens = LensStatus{0.0, 0.8, 0.8, 0.5, true};
        drive_.show_head(head_);
        drive_.set_speed_share(0.5);
    }
    double last_pan() { return drives_.last().at(0).toDouble(); }

    HandDrive drive_;
    HeadSnapshot head_;
    QSignalSpy drives_{&drive_, &HandDrive::drive};
    QSignalSpy halts_{&drive_, &HandDrive::halt};
    QSignalSpy zooms_{&drive_, &HandDrive::zoom};
};

TEST_F(HandDriveTest, SaysItAgainAsLongAsItIsHeldAndHaltsOnce) {
    drive_.hold(Source::keys, {1.0, 0.0});
    ASSERT_EQ(drives_.count(), 1) << "at once";
    EXPECT_NEAR(last_pan(), 0.5 * HeadLimits{}.pan_speed_rad_s, 1e-12);
    EXPECT_TRUE(QTest::qWaitFor([&] { return drives_.count() >= 5; }, 2000));
    EXPECT_EQ(halts_.count(), 0);
    drive_.release(Source::keys);
    drive_.release(Source::keys);
    EXPECT_EQ(halts_.count(), 1);
    const auto told = drives_.count();
    QTest::qWait(200);
    EXPECT_EQ(drives_.count(), told);
}

TEST_F(HandDriveTest, TheLastTakenUpCountsAndTheOtherComesBack) {
    drive_.hold(Source::keys, {1.0, 0.0});
    drive_.hold(Source::stick, {-0.5, 0.0});
    EXPECT_LT(last_pan(), 0.0);
    drive_.release(Source::stick);
    EXPECT_GT(last_pan(), 0.0);
    EXPECT_EQ(halts_.count(), 0);
    drive_.release(Source::keys);
    EXPECT_EQ(halts_.count(), 1);
}

TEST_F(HandDriveTest, ZoomedInItTurnsMoreSlowly) {
    head_.lens = LensStatus{1.0, 2.0 * std::atan(std::tan(0.4) / 10.0), 0.8, 0.5, true};
    drive_.show_head(head_);
    drive_.hold(Source::stick, {1.0, 0.0});
    EXPECT_NEAR(last_pan(), 0.05 * HeadLimits{}.pan_speed_rad_s, 1e-9);
}

TEST_F(HandDriveTest, AHeadThatCannotBeDrivenIsNot) {
    head_.abilities.drive = false;
    drive_.show_head(head_);
    drive_.hold(Source::stick, {1.0, 0.0});
    drive_.show_head(std::nullopt);
    drive_.hold(Source::keys, {1.0, 0.0});
    EXPECT_EQ(drives_.count(), 0);
    EXPECT_FALSE(drive_.held());
}

TEST_F(HandDriveTest, DroppedItMustBeTakenUpAnew) {
    auto pad = std::make_shared<FakeGamepad>();
    pad->plug_in();
    drive_.set_gamepad(pad);
    ASSERT_TRUE(QTest::qWaitFor([&] { return drive_.pad_state() == PadState::armed; }, 2000));
    pad->stick(1.0, 0.0);
    ASSERT_TRUE(QTest::qWaitFor([&] { return drive_.held(); }, 2000));
    drive_.drop_all();
    EXPECT_EQ(halts_.count(), 1);
    const auto told = drives_.count();
    QTest::qWait(200);
    EXPECT_EQ(drives_.count(), told) << "its stick is still pressed";
    EXPECT_EQ(drive_.pad_state(), PadState::centre_first);
    pad->stick(0.0, 0.0);
    EXPECT_TRUE(QTest::qWaitFor([&] { return drive_.pad_state() == PadState::armed; }, 2000));
}

class PadThatStops : public HandDriveTest, public testing::WithParamInterface<bool> {};

TEST_P(PadThatStops, HaltsWithin200Milliseconds) {
    auto pad = std::make_shared<FakeGamepad>();
    pad->plug_in();
    drive_.set_gamepad(pad);
    ASSERT_TRUE(QTest::qWaitFor([&] { return drive_.pad_state() == PadState::armed; }, 2000));
    pad->stick(0.8, 0.0);
    ASSERT_TRUE(QTest::qWaitFor([&] { return drives_.count() > 3; }, 2000));
    QElapsedTimer since;
    since.start();
    GetParam() ? pad->hang() : pad->plug_in(false);
    ASSERT_TRUE(QTest::qWaitFor([&] { return halts_.count() == 1; }, 2000));
    EXPECT_LT(since.elapsed(), 200);
    EXPECT_FALSE(drive_.held());
    EXPECT_EQ(drive_.pad_state(), GetParam() ? PadState::frozen : PadState::absent);
}

INSTANTIATE_TEST_SUITE_P(, PadThatStops, testing::Bool(),
                         [](const auto& one) { return one.param ? "Hangs" : "Vanishes"; });

TEST_F(HandDriveTest, TriggersZoomAndItsButtonHalts) {
    auto pad = std::make_shared<FakeGamepad>();
    pad->plug_in();
    drive_.set_gamepad(pad);
    ASSERT_TRUE(QTest::qWaitFor([&] { return drive_.pad_state() == PadState::armed; }, 2000));
    pad->triggers(1.0, 0.0);
    ASSERT_TRUE(QTest::qWaitFor([&] { return zooms_.count() >= 3; }, 2000));
    EXPECT_GT(zooms_.last().at(0).toDouble(), zooms_.first().at(0).toDouble());
    pad->press_halt(true);
    EXPECT_TRUE(QTest::qWaitFor([&] { return halts_.count() == 1; }, 2000));
    QTest::qWait(100);
    EXPECT_EQ(halts_.count(), 1) << "once a press";
}

TEST_F(HandDriveTest, ItsButtonHaltsWhateverElseIsHeld) {
    auto pad = std::make_shared<FakeGamepad>();
    pad->plug_in();
    drive_.set_gamepad(pad);
    ASSERT_TRUE(QTest::qWaitFor([&] { return drive_.pad_state() == PadState::armed; }, 2000));
    drive_.hold(Source::keys, {1.0, 0.0});
    pad->stick(1.0, 0.0);
    ASSERT_TRUE(QTest::qWaitFor([&] { return drives_.count() > 3; }, 2000));
    QSignalSpy dropped(&drive_, &HandDrive::dropped);
    pad->press_halt(true);
    ASSERT_TRUE(QTest::qWaitFor([&] { return halts_.count() > 0; }, 2000));
    const auto told = drives_.count();
    QTest::qWait(200);
    EXPECT_EQ(drives_.count(), told) << "the key is still down";
    EXPECT_FALSE(drive_.held());
    EXPECT_EQ(dropped.count(), 1) << "keys and stick in the window are let go as well";
}

}  // namespace
}  // namespace kambara
