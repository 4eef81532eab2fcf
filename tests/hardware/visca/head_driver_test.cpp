// SPDX-License-Identifier: GPL-3.0-or-later
// The driver and the simulated EVI-D30, on time that passes only when told to.
#include "hardware/visca/head_driver.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/hardware/visca/simulated_link.h"

namespace kambara::visca {
namespace {

HeadAngles degrees(double pan, double tilt) {
    return {rad_from_deg(pan), rad_from_deg(tilt)};
}

class HeadDriverTest : public testing::Test {
  protected:
    void make(const LineFaults& faults = {}, HeadDriver::Options options = {},
              const EviSimulator::Options& camera = {}) {
        options.heads = built_in_heads();
        options.session.byte_ns = byte_time_ns(9600);
        line_ = std::make_unique<SimulatedLine>(clock_.now_ns(), faults, 9600, camera);
        link_ = std::make_unique<SimulatedLink>(clock_, *line_);
        driver_ = std::make_unique<HeadDriver>(*link_, queue_, clock_, options);
    }
    void run_s(double seconds) {
        const std::int64_t until_ns =
            clock_.now_ns() + static_cast<std::int64_t>(std::llround(seconds * 1e9));
        while (clock_.now_ns() < until_ns) {
            driver_->step();
            for (const HeadNote& note : driver_->take_notes()) {
                notes_ += note.text + "\n";
            }
        }
    }
    void steer(double pan, double tilt) {
        queue_.put(Motion{Motion::Kind::look, degrees(pan, tilt)});
    }
    void by_hand(double pan, double tilt) {
        queue_.put(Motion{Motion::Kind::look, degrees(pan, tilt), {}, true});
    }
    void drive(double pan_deg_s) {
        queue_.put(Motion{Motion::Kind::drive, degrees(pan_deg_s, 0.0), {}, true});
    }
    double pan_deg() const { return line_->camera.state().pan_steps / 8.8; }
    double tilt_deg() const { return line_->camera.state().tilt_steps / 12.0; }
    int sent(Op op) const {
        int count = 0;
        for (const Bytes& packet : link_->sent) {
            const auto message = decode_message(packet);
            count += message && message->message.op == op ? 1 : 0;
        }
        return count;
    }

    ManualClock clock_{77'000'000};
    HeadQueue queue_;
    std::unique_ptr<SimulatedLine> line_;
    std::unique_ptr<SimulatedLink> link_;
    std::unique_ptr<HeadDriver> driver_;
    std::string notes_;
};

TEST_F(HeadDriverTest, LooksWhereItIsToldAndSaysSo) {
    make();
    EXPECT_FALSE(driver_->status().ok());
    EXPECT_NE(driver_->status().error().cause.find("simulated line"), std::string::npos);
    run_s(0.3);
    ASSERT_TRUE(driver_->connected());
    EXPECT_EQ(driver_->model()->name, "evi-d30");
    steer(40.0, -10.0);
    run_s(0.3);
    EXPECT_TRUE(driver_->status().value().moving);
    run_s(1.0);
    EXPECT_NEAR(pan_deg(), 40.0, 1e-9);
    EXPECT_NEAR(tilt_deg(), -10.0, 1e-9);
    const HeadStatus status = driver_->status().value();
    EXPECT_NEAR(deg_from_rad(status.angles.pan_rad), 40.0, 1e-9);
    EXPECT_NEAR(deg_from_rad(status.angles.tilt_rad), -10.0, 1e-9);
    EXPECT_FALSE(status.moving);
    EXPECT_EQ(status.time_ns, clock_.now_ns());
    EXPECT_EQ(sent(Op::absolute), 1);
    EXPECT_EQ(notes_, "The head answers.\n");
}

TEST_F(HeadDriverTest, BetweenReadingsTheHeadMovesOn) {
    make();
    run_s(0.3);
    steer(90.0, 20.0);
    double worst_deg = 0.0;
    double last_deg = 0.0;
    int changes = 0;
    const auto readings = driver_->position_readings();
    run_s(0.1);
    for (int i = 0; i < 1400; ++i) {
        run_s(0.001);
        const double seen_deg = deg_from_rad(driver_->status().value().angles.pan_rad);
        worst_deg = std::max(worst_deg, std::abs(seen_deg - pan_deg()));
        changes += seen_deg != last_deg ? 1 : 0;
        last_deg = seen_deg;
    }
    EXPECT_LT(worst_deg, 5.0) << "it is not known how fast it gets up to speed";
    EXPECT_GT(changes, 800) << "not only when it is read";
    const double rate_hz = static_cast<double>(driver_->position_readings() - readings) / 1.5;
    EXPECT_GT(rate_hz, 10.0);
    EXPECT_LT(rate_hz, 30.0) << "the line is kept free";
}

TEST_F(HeadDriverTest, TheNewestAimWins) {
    make();
    run_s(0.3);
    // A hundred aims a second, more than the line carries.
    for (int i = 0; i <= 200; ++i) {
        steer(0.2 * i, 0.05 * i);
        run_s(0.01);
    }
    EXPECT_GT(queue_.replaced(), 20U);
    EXPECT_GT(sent(Op::absolute), 20);
    EXPECT_LT(sent(Op::absolute), 80);
    EXPECT_NEAR(pan_deg(), 40.0, 3.0) << "close behind";
    run_s(0.5);
    EXPECT_NEAR(pan_deg(), 40.0, 1e-9);
    EXPECT_NEAR(tilt_deg(), 10.0, 0.05);
    EXPECT_EQ(notes_, "The head answers.\n");
}

TEST_F(HeadDriverTest, AnOperatorsWishComesFirst) {
    make();
    run_s(0.3);
    steer(50.0, 0.0);
    by_hand(-20.0, 5.0);
    run_s(1.0);
    EXPECT_NEAR(pan_deg(), -20.0, 0.06);
    EXPECT_EQ(sent(Op::absolute), 1) << "what steering wanted before was dropped";
    by_hand(10.0, 0.0);
    steer(30.0, 0.0);
    run_s(0.1);
    EXPECT_EQ(sent(Op::absolute), 3) << "and what it wants later comes later";
    run_s(1.0);
    EXPECT_NEAR(pan_deg(), 30.0, 1e-9);
}

TEST_F(HeadDriverTest, HaltsAtOnce) {
    make();
    run_s(0.3);
    steer(90.0, 20.0);
    run_s(0.5);
    const double when_halted_deg = pan_deg();
    queue_.halt();
    run_s(1.0);
    const double halted_deg = pan_deg();
    EXPECT_FALSE(line_->camera.state().moving);
    // 80 degrees/s: a tenth of a second for the line, 8 degrees to brake.
    EXPECT_LT(halted_deg - when_halted_deg, 17.0);
    run_s(2.0);
    EXPECT_EQ(pan_deg(), halted_deg) << "it is not told to go on";
    EXPECT_FALSE(driver_->status().value().moving);
    EXPECT_NEAR(deg_from_rad(driver_->status().value().angles.pan_rad), halted_deg, 0.06);
}

TEST_F(HeadDriverTest, DrivesAtASpeedAlsoOutOfAMove) {
    make();
    run_s(0.3);
    steer(90.0, 20.0);
    run_s(0.3);
    queue_.put(Motion{Motion::Kind::drive, degrees(-20.0, 0.0), {}, true});
    run_s(1.0);
    const double from_deg = pan_deg();
    run_s(1.0);
    EXPECT_NEAR(pan_deg() - from_deg, -20.0, 0.1);
    EXPECT_TRUE(driver_->status().value().moving);
    queue_.halt();
    run_s(0.5);
    EXPECT_FALSE(line_->camera.state().moving);
}

TEST_F(HeadDriverTest, HaltsAHeadWhoseRepliesDoNotCome) {
    for (const Wiring wiring : {Wiring::serial, Wiring::tcp, Wiring::udp}) {
        SCOPED_TRACE(static_cast<int>(wiring));
        HeadDriver::Options options;
        options.session.wiring = wiring;
        make({}, options);
        run_s(0.3);
        drive(10.0);
        run_s(0.3);
        ASSERT_TRUE(line_->camera.state().moving);
        line_->carries_replies = false;
        // Said again and again, as who holds a key does; the session gives up meanwhile.
        for (int i = 0; i < 20; ++i) {
            drive(10.0);
            run_s(0.05);
        }
        EXPECT_FALSE(driver_->connected());
        queue_.halt();
        run_s(0.5);
        EXPECT_FALSE(line_->camera.state().moving);
        line_->carries_replies = true;
        run_s(1.5);
        EXPECT_TRUE(driver_->connected());
        EXPECT_FALSE(line_->camera.state().moving);
    }
}

TEST_F(HeadDriverTest, WhatIsNotHeardOfIsNotDrivenOn) {
    make();
    run_s(0.3);
    drive(10.0);
    run_s(0.3);
    line_->carries_replies = false;
    run_s(1.5);
    EXPECT_FALSE(driver_->connected());
    EXPECT_FALSE(line_->camera.state().moving) << "also while the key is held";
}

TEST_F(HeadDriverTest, ALostDriveIsNotToldAgainOnceItIsHalted) {
    make();
    run_s(1.0);
    line_->carries_to_camera = false;
    drive(20.0);
    run_s(0.01);
    ASSERT_EQ(sent(Op::drive), 1);
    queue_.halt();
    line_->carries_to_camera = true;
    run_s(1.0);
    EXPECT_EQ(sent(Op::drive), 2) << "the stop";
    EXPECT_EQ(pan_deg(), 0.0);
}

TEST_F(HeadDriverTest, ALostDriveThatIsStillWantedIsToldAgain) {
    make();
    run_s(1.0);
    line_->carries_to_camera = false;
    drive(20.0);
    run_s(0.01);
    line_->carries_to_camera = true;
    run_s(0.3);
    EXPECT_TRUE(line_->camera.state().moving);
    EXPECT_EQ(sent(Op::drive), 2);
}

TEST_F(HeadDriverTest, AStopThatIsCompletedLateLeavesTheNextMotionAlone) {
    EviSimulator::Options camera;
    camera.completes_stop_at_rest = true;
    make({}, {}, camera);
    run_s(0.3);
    drive(60.0);
    run_s(0.5);
    queue_.halt();
    run_s(0.07);
    ASSERT_TRUE(line_->camera.state().moving) << "it brakes";
    ASSERT_FALSE(driver_->status().value().moving) << "the stop was acknowledged";
    steer(90.0, 0.0);
    run_s(0.2);
    ASSERT_TRUE(line_->camera.state().moving);
    EXPECT_TRUE(driver_->status().value().moving);
}

TEST_F(HeadDriverTest, ZoomsFocusesAndKeepsPresets) {
    make();
    run_s(0.3);
    queue_.put(Message{Op::zoom_direct, {0x3FF}});
    queue_.put(Message{Op::focus_mode, {3}});
    queue_.put(Message{Op::focus_direct, {0x5000}});
    run_s(6.0);
    EXPECT_EQ(line_->camera.state().zoom, 0x3FF);
    EXPECT_EQ(line_->camera.state().focus, 0x5000);
    const LensStatus lens = driver_->lens().value();
    EXPECT_EQ(lens.zoom_share, 1.0);
    EXPECT_NEAR(deg_from_rad(lens.horizontal_view_rad), 4.4, 0.1);
    EXPECT_FALSE(lens.autofocus);
    EXPECT_NEAR(lens.focus_share, double{0x4000} / 0x8FFF, 1e-6);
    steer(30.0, -5.0);
    run_s(1.0);
    queue_.put(Message{Op::memory_set, {2}});
    run_s(0.2);
    queue_.put(Motion{Motion::Kind::other, {}, {Op::home}, true});
    run_s(2.0);
    EXPECT_EQ(pan_deg(), 0.0);
    queue_.put(Motion{Motion::Kind::other, {}, {Op::memory_recall, {2}}, true});
    run_s(2.0);
    EXPECT_NEAR(pan_deg(), 30.0, 1e-9);
    EXPECT_EQ(notes_, "The head answers.\n");
}

TEST_F(HeadDriverTest, SwitchesOnWhatIsInStandby) {
    make();
    const Bytes standby = encode({Op::power, {3}}, 1);
    line_->camera.receive(standby, 0, clock_.now_ns());
    run_s(0.2);
    steer(20.0, 0.0);
    run_s(12.0);
    EXPECT_TRUE(line_->camera.state().on);
    EXPECT_NE(notes_.find("standby"), std::string::npos);
    EXPECT_NEAR(pan_deg(), 20.0, 1e-9) << "told again once it can";
}

TEST_F(HeadDriverTest, IsBackOnTargetAfterThePowerWasGone) {
    make();
    run_s(0.3);
    steer(60.0, 10.0);
    run_s(2.0);
    line_->camera.power_cycle(0, clock_.now_ns());
    run_s(12.0);
    EXPECT_NE(notes_.find("switched on"), std::string::npos);
    EXPECT_NEAR(pan_deg(), 60.0, 1e-9);
}

TEST_F(HeadDriverTest, TellsAgainWhatCameWhileThePlugWasOut) {
    LineFaults faults;
    faults.unplug_every_s = 4.0;
    faults.unplug_for_s = 2.0;
    for (const bool vanishes : {true, false}) {
        make(faults);
        link_->device_vanishes = vanishes;
        notes_.clear();
        run_s(1.0);
        steer(10.0, 0.0);
        run_s(1.9);
        EXPECT_NEAR(pan_deg(), 10.0, 1e-9);
        EXPECT_FALSE(driver_->status().ok()) << "the plug is out";
        steer(30.0, 0.0);
        queue_.put(Message{Op::zoom_direct, {100}});
        run_s(0.5);
        steer(-15.0, 5.0);
        run_s(0.6);
        EXPECT_NEAR(pan_deg(), 10.0, 1e-9);
        run_s(1.0);
        EXPECT_NEAR(pan_deg(), -15.0, 1e-9) << "within a second of its return";
        EXPECT_EQ(line_->camera.state().zoom, 100.0);
        EXPECT_TRUE(driver_->status().ok());
        EXPECT_NE(notes_.find(vanishes ? "The line was lost." : "does not answer"),
                  std::string::npos)
            << notes_;
        EXPECT_NE(notes_.find(vanishes ? "is there again" : "answers again"), std::string::npos)
            << notes_;
    }
}

TEST_F(HeadDriverTest, RefusesAKindItDoesNotKnow) {
    HeadDriver::Options options;
    make({}, options);
    options.heads = {built_in_heads()[1]};
    options.session.byte_ns = byte_time_ns(9600);
    driver_ = std::make_unique<HeadDriver>(*link_, queue_, clock_, options);
    steer(10.0, 0.0);
    run_s(1.0);
    EXPECT_FALSE(driver_->connected());
    EXPECT_NE(driver_->fault().find("0402"), std::string::npos);
    EXPECT_EQ(pan_deg(), 0.0);
}

TEST_F(HeadDriverTest, CancelsFirstWhereNothingTakesOver) {
    HeadDriver::Options options;
    options.model = built_in_heads()[0];
    options.model->replaces_moves = false;
    options.model->cancel_wait_s = 0.2;
    make({}, options);
    run_s(0.3);
    steer(80.0, 0.0);
    run_s(0.1);
    steer(-30.0, 0.0);
    run_s(0.05);
    EXPECT_EQ(sent(Op::cancel), 0) << "not before 0.2 s";
    run_s(3.0);
    EXPECT_EQ(sent(Op::cancel), 1);
    EXPECT_NEAR(pan_deg(), -30.0, 1e-9);
}

TEST(HeadQueue, KeepsWhatMattersInItsOrder) {
    HeadQueue queue;
    queue.put(Message{Op::zoom_direct, {1}});
    queue.put(Message{Op::focus_mode, {2}});
    queue.put(Message{Op::zoom_direct, {3}});
    EXPECT_EQ(queue.take_setting()->op, Op::focus_mode);
    const Message zoom = queue.take_setting().value();
    EXPECT_EQ(zoom.values, std::vector{3}) << "the newer of its kind";
    queue.put_back(zoom);
    queue.put(Message{Op::zoom_direct, {4}});
    queue.put_back(zoom);
    EXPECT_EQ(queue.take_setting()->values, std::vector{4});
    EXPECT_FALSE(queue.take_setting().has_value());
    queue.put(Motion{Motion::Kind::look, {1, 0}});
    queue.halt();
    EXPECT_FALSE(queue.take_motion(false).has_value());
    queue.put(Motion{Motion::Kind::look, {2, 0}});
    EXPECT_TRUE(queue.take_halt());
    EXPECT_FALSE(queue.take_halt());
    EXPECT_FALSE(queue.take_motion(true).has_value());
    EXPECT_EQ(queue.take_motion(false)->angles.pan_rad, 2.0);
}

}  // namespace
}  // namespace kambara::visca
