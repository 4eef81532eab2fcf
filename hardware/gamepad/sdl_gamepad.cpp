// SPDX-License-Identifier: GPL-3.0-or-later
#include "hardware/gamepad/sdl_gamepad.h"

#include <SDL.h>

#include <algorithm>
#include <chrono>
#include <future>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>
#include <utility>

namespace kambara {
namespace {

constexpr std::chrono::milliseconds poll_interval{10};
constexpr Uint32 subsystems = SDL_INIT_GAMECONTROLLER;

double way_of(Sint16 axis) {
    return std::max(-1.0, static_cast<double>(axis) / 32767.0);
}

std::string text_of(const char* text) {
    return text != nullptr ? text : "gamepad";
}

// A game's controller where SDL knows its buttons, otherwise a joystick; lives on one thread.
class Device {
  public:
    Device() = default;
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;
    ~Device() { close(); }

    void open_first() {
        for (int i = 0; i < SDL_NumJoysticks() && joystick_ == nullptr; ++i) {
            if (SDL_IsGameController(i) == SDL_TRUE) {
                controller_ = SDL_GameControllerOpen(i);
                joystick_ = SDL_GameControllerGetJoystick(controller_);
            } else {
                joystick_ = SDL_JoystickOpen(i);
                if (SDL_JoystickNumAxes(joystick_) < 2) {
                    close();
                }
            }
        }
    }

    void close() {
        if (controller_ != nullptr) {
            SDL_GameControllerClose(controller_);
        } else if (joystick_ != nullptr) {
            SDL_JoystickClose(joystick_);
        }
        controller_ = nullptr;
        joystick_ = nullptr;
    }

    bool attached() const {
        return joystick_ != nullptr && SDL_JoystickGetAttached(joystick_) == SDL_TRUE;
    }

    // SDL's vertical axes grow downwards.
    PadReading reading() const {
        PadReading reading;
        reading.present = true;
        reading.device = SDL_JoystickInstanceID(joystick_);
        if (controller_ == nullptr) {
            reading.name = text_of(SDL_JoystickName(joystick_));
            reading.right = way_of(SDL_JoystickGetAxis(joystick_, 0));
            reading.up = -way_of(SDL_JoystickGetAxis(joystick_, 1));
            return reading;
        }
        const auto way = [this](SDL_GameControllerAxis axis) {
            return way_of(SDL_GameControllerGetAxis(controller_, axis));
        };
        reading.name = text_of(SDL_GameControllerName(controller_));
        reading.right = way(SDL_CONTROLLER_AXIS_LEFTX);
        reading.up = -way(SDL_CONTROLLER_AXIS_LEFTY);
        reading.zoom_in = std::max(0.0, way(SDL_CONTROLLER_AXIS_TRIGGERRIGHT));
        reading.zoom_out = std::max(0.0, way(SDL_CONTROLLER_AXIS_TRIGGERLEFT));
        reading.halt = SDL_GameControllerGetButton(controller_, SDL_CONTROLLER_BUTTON_B) != 0;
        return reading;
    }

  private:
    SDL_GameController* controller_ = nullptr;
    SDL_Joystick* joystick_ = nullptr;  // the controller's, where there is one
};

// All of SDL is used on the one thread.
class SdlGamepad final : public GamepadBase {
  public:
    explicit SdlGamepad(const Clock& clock)
        : clock_(clock), thread_([this](const std::stop_token& stop) { run(stop); }) {}

    std::string wait_until_begun() { return begun_.get_future().get(); }

    PadReading reading() const override {
        std::lock_guard lock(mutex_);
        return reading_;
    }

  private:
    void run(const std::stop_token& stop) {
        // The window's program handles signals, and its window is not SDL's.
        SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
        SDL_SetHint(SDL_HINT_JOYSTICK_ALLOW_BACKGROUND_EVENTS, "1");
        const bool begun = SDL_InitSubSystem(subsystems) == 0;
        begun_.set_value(begun ? std::string() : std::string(SDL_GetError()));
        if (begun) {
            poll_until(stop);
            SDL_QuitSubSystem(subsystems);
        }
        SDL_TLSCleanup();  // SDL knows only of the end of its own threads
    }

    void poll_until(const std::stop_token& stop) {
        Device device;
        while (!stop.stop_requested()) {
            SDL_GameControllerUpdate();
            SDL_FlushEvents(SDL_FIRSTEVENT, SDL_LASTEVENT);
            if (!device.attached()) {
                device.close();
                device.open_first();
            }
            PadReading reading = device.attached() ? device.reading() : PadReading{};
            reading.time_ns = clock_.now_ns();
            {
                std::lock_guard lock(mutex_);
                reading_ = std::move(reading);
            }
            std::this_thread::sleep_for(poll_interval);
        }
    }

    const Clock& clock_;
    std::promise<std::string> begun_;
    mutable std::mutex mutex_;
    PadReading reading_;
    std::jthread thread_;  // last, so that it ends before what it uses
};

}  // namespace

Result<std::unique_ptr<GamepadBase>> open_sdl_gamepad(const Clock& clock) {
    auto gamepad = std::make_unique<SdlGamepad>(clock);
    if (const std::string fault = gamepad->wait_until_begun(); !fault.empty()) {
        return Error{"Gamepads can't be used: " + fault + ".", "Use the pad in the window."};
    }
    return std::unique_ptr<GamepadBase>(std::move(gamepad));
}

}  // namespace kambara
