// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pointing/stick_law.h"

#include <gtest/gtest.h>

#include <cmath>

namespace kambara {
namespace {

// A pad that is polled every 20 ms, as a device would be.
class StickLawTest : public testing::Test {
  protected:
    StickWish at(double right, double up, double zoom_in = 0.0, double zoom_out = 0.0) {
        pad_.right = right;
        pad_.up = up;
        pad_.zoom_in = zoom_in;
        pad_.zoom_out = zoom_out;
        return poll();
    }
    StickWish poll() {
        now_ns_ += 20'000'000;
        if (answers_) {
            pad_.time_ns = now_ns_;
        }
        return law_.update(pad_, now_ns_);
    }
    // Moves by a hair each time, as a hand does.
    StickWish for_s(double seconds, double right) {
        StickWish wish;
        for (int i = 0; i < static_cast<int>(seconds / 0.02); ++i) {
            wish = at(right + (i % 2 == 0 ? 0.0 : 1e-4), 0.0);
        }
        return wish;
    }

    StickLaw law_;
    PadReading pad_{true, 0, "fake pad"};
    std::int64_t now_ns_ = 1'000'000'000;
    bool answers_ = true;
};

TEST_F(StickLawTest, CountsOnlyOnceItWasLetGo) {
    EXPECT_EQ(at(0.8, 0.0).state, PadState::centre_first);
    EXPECT_FALSE(at(0.8, 0.1).turns());
    EXPECT_EQ(at(0.0, 0.0, 0.9).state, PadState::centre_first) << "a trigger counts, too";
    EXPECT_EQ(at(0.05, -0.05).state, PadState::armed);
    EXPECT_FALSE(at(0.05, -0.05).turns());
    EXPECT_GT(at(0.8, 0.0).pan, 0.4);
}

TEST_F(StickLawTest, IsSilentInTheDeadZoneAndGrowsSquarelyBeyondIt) {
    at(0, 0);
    for (int i = 0; i < 16; ++i) {
        const double turned = i * 3.14159265 / 8.0;
        EXPECT_FALSE(at(0.149 * std::cos(turned), 0.149 * std::sin(turned)).turns());
        const StickWish half = at(0.575 * std::cos(turned), 0.575 * std::sin(turned));
        EXPECT_NEAR(std::hypot(half.pan, half.tilt), 0.25, 1e-12);
        EXPECT_NEAR(std::atan2(half.tilt, half.pan), std::remainder(turned, 2 * M_PI), 1e-6);
        // Square pads reach 1.41 in their corners.
        const StickWish full = at(1.4 * std::cos(turned), 1.4 * std::sin(turned));
        EXPECT_NEAR(std::hypot(full.pan, full.tilt), 1.0, 1e-12);
    }
    EXPECT_NEAR(at(0, 0, 1.0, 0.0).zoom, 1.0, 1e-12);
    EXPECT_NEAR(at(0, 0, 0.0, 0.575).zoom, -0.25, 1e-12);
    EXPECT_EQ(at(0, 0, 0.1, 0.0).zoom, 0.0);
}

TEST_F(StickLawTest, APadThatVanishesStopsAtOnceAndBeginsAnew) {
    at(0, 0);
    EXPECT_TRUE(at(1.0, 0.0).turns());
    pad_.present = false;
    EXPECT_EQ(poll().state, PadState::absent);
    EXPECT_FALSE(poll().turns());
    pad_.present = true;
    EXPECT_EQ(poll().state, PadState::centre_first) << "its stick is still pressed";
    EXPECT_FALSE(poll().turns());
}

TEST_F(StickLawTest, AnotherPadBeginsAnewWhateverItsName) {
    at(0, 0);
    EXPECT_TRUE(at(1.0, 0.0).turns());
    // Within one look at the devices the one has gone and the next is there.
    ++pad_.device;
    EXPECT_EQ(at(1.0, 0.0).state, PadState::centre_first);
    EXPECT_EQ(at(0, 0).state, PadState::armed);
}

TEST_F(StickLawTest, APadThatHangsStopsWithin200Milliseconds) {
    at(0, 0);
    EXPECT_TRUE(at(1.0, 0.0).turns());
    answers_ = false;
    const std::int64_t hangs_ns = now_ns_;
    StickWish wish;
    do {
        wish = poll();
    } while (wish.turns() && now_ns_ - hangs_ns < 1'000'000'000);
    EXPECT_EQ(wish.state, PadState::frozen);
    EXPECT_GT(now_ns_ - hangs_ns, 100'000'000) << "a short pause is no fault";
    EXPECT_LT(now_ns_ - hangs_ns, 150'000'000);
    answers_ = true;
    EXPECT_EQ(poll().state, PadState::centre_first);
    EXPECT_EQ(at(0, 0).state, PadState::armed);
}

TEST_F(StickLawTest, WhatNoHandHoldsSoStillIsFrozen) {
    at(0, 0);
    EXPECT_TRUE(for_s(30.0, 0.6).turns()) << "a hand moves by a hair";
    StickWish wish;
    for (int i = 0; i < 145; ++i) {
        wish = at(0.6, 0.0);
    }
    EXPECT_TRUE(wish.turns());
    for (int i = 0; i < 20; ++i) {
        wish = at(0.6, 0.0);
    }
    EXPECT_EQ(wish.state, PadState::frozen);
    EXPECT_FALSE(at(0.7, 0.0).turns());
    EXPECT_EQ(at(0, 0).state, PadState::armed);
    for (int i = 0; i < 2000; ++i) {
        wish = at(0, 0);
    }
    EXPECT_EQ(wish.state, PadState::armed) << "at rest nothing need move";
}

TEST_F(StickLawTest, TheHaltButtonHaltsUntilAllIsLetGo) {
    at(0, 0);
    pad_.halt = true;
    const StickWish halted = at(1.0, 0.0);
    EXPECT_TRUE(halted.halt);
    EXPECT_FALSE(halted.turns());
    pad_.halt = false;
    EXPECT_EQ(at(1.0, 0.0).state, PadState::centre_first);
    EXPECT_EQ(at(0.0, 0.0).state, PadState::armed);
}

}  // namespace
}  // namespace kambara
