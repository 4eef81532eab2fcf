// SPDX-License-Identifier: GPL-3.0-or-later
// With a pad that SDL itself pretends to be plugged in.
#include "hardware/gamepad/sdl_gamepad.h"

#include <SDL.h>
#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <thread>

#include "core/pointing/stick_law.h"

namespace kambara {
namespace {

bool until(const std::function<bool()>& is_so) {
    for (int i = 0; i < 1000; ++i) {
        if (is_so()) {
            return true;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return false;
}

class SdlGamepadTest : public testing::Test {
  protected:
    void SetUp() override {
        auto opened = open_sdl_gamepad(clock_);
        ASSERT_TRUE(opened) << opened.error().text();
        pad_ = std::move(*opened);
        ASSERT_EQ(SDL_InitSubSystem(SDL_INIT_GAMECONTROLLER), 0);
        if (SDL_NumJoysticks() > 0) {
            GTEST_SKIP() << "a real pad is plugged in: the pretended one would not be the first";
        }
    }
    void TearDown() override {
        pull_out();
        SDL_QuitSubSystem(SDL_INIT_GAMECONTROLLER);
    }
    void plug_in() {
        index_ = SDL_JoystickAttachVirtual(SDL_JOYSTICK_TYPE_GAMECONTROLLER,
                                           SDL_CONTROLLER_AXIS_MAX, SDL_CONTROLLER_BUTTON_MAX, 0);
        ASSERT_GE(index_, 0) << SDL_GetError();
        device_ = SDL_JoystickOpen(index_);
        ASSERT_TRUE(device_);
        // Its triggers rest at their lower ends.
        set(SDL_CONTROLLER_AXIS_TRIGGERLEFT, -32768);
        set(SDL_CONTROLLER_AXIS_TRIGGERRIGHT, -32768);
    }
    void pull_out() {
        if (device_ != nullptr) {
            SDL_JoystickDetachVirtual(index_);
            SDL_JoystickClose(device_);
            device_ = nullptr;
        }
    }
    void set(SDL_GameControllerAxis axis, int value) {
        SDL_JoystickSetVirtualAxis(device_, axis, static_cast<Sint16>(value));
    }

    SteadyClock clock_;
    std::unique_ptr<GamepadBase> pad_;
    SDL_Joystick* device_ = nullptr;
    int index_ = -1;
};

TEST_F(SdlGamepadTest, EachThatIsPluggedInHasANumberOfItsOwn) {
    plug_in();
    ASSERT_TRUE(until([&] { return pad_->reading().present; }));
    const PadReading first = pad_->reading();
    pull_out();
    ASSERT_TRUE(until([&] { return !pad_->reading().present; }));
    plug_in();
    ASSERT_TRUE(until([&] { return pad_->reading().present; }));
    EXPECT_EQ(pad_->reading().name, first.name);
    EXPECT_NE(pad_->reading().device, first.device);
}

TEST_F(SdlGamepadTest, ReadsSticksTriggersAndTheHaltButton) {
    EXPECT_FALSE(pad_->reading().present);
    plug_in();
    ASSERT_TRUE(until([&] { return pad_->reading().present; }));
    EXPECT_FALSE(pad_->reading().name.empty());
    set(SDL_CONTROLLER_AXIS_LEFTX, 16384);
    set(SDL_CONTROLLER_AXIS_LEFTY, -32768);
    set(SDL_CONTROLLER_AXIS_TRIGGERRIGHT, 32767);
    ASSERT_TRUE(until([&] { return pad_->reading().right > 0.49 && pad_->reading().zoom_in > 0; }));
    EXPECT_NEAR(pad_->reading().right, 0.5, 0.01);
    EXPECT_NEAR(pad_->reading().up, 1.0, 0.01);
    EXPECT_NEAR(pad_->reading().zoom_in, 1.0, 0.01);
    EXPECT_NEAR(pad_->reading().zoom_out, 0.0, 0.01);
    EXPECT_FALSE(pad_->reading().halt);
    SDL_JoystickSetVirtualButton(device_, SDL_CONTROLLER_BUTTON_B, 1);
    EXPECT_TRUE(until([&] { return pad_->reading().halt; }));
}

TEST_F(SdlGamepadTest, ItsTimeGoesOnAsLongAsItIsRead) {
    plug_in();
    ASSERT_TRUE(until([&] { return pad_->reading().present; }));
    for (int i = 0; i < 10; ++i) {
        const std::int64_t before_ns = pad_->reading().time_ns;
        EXPECT_TRUE(until([&] { return pad_->reading().time_ns > before_ns; }));
    }
}

TEST_F(SdlGamepadTest, PulledOutItStopsWhatItDrove) {
    plug_in();
    StickLaw law;
    const auto wish = [&] { return law.update(pad_->reading(), clock_.now_ns()); };
    ASSERT_TRUE(until([&] { return wish().state == PadState::armed; }));
    set(SDL_CONTROLLER_AXIS_LEFTX, -32768);
    ASSERT_TRUE(until([&] { return wish().pan < -0.9; }));
    pull_out();
    ASSERT_TRUE(until([&] { return !wish().turns(); }));
    EXPECT_TRUE(until([&] { return wish().state == PadState::absent; }));
    plug_in();
    set(SDL_CONTROLLER_AXIS_LEFTX, 32767);
    ASSERT_TRUE(until([&] { return wish().state == PadState::centre_first; }));
    set(SDL_CONTROLLER_AXIS_LEFTX, 0);
    EXPECT_TRUE(until([&] { return wish().state == PadState::armed; }));
}

}  // namespace
}  // namespace kambara
