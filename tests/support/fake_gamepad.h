// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <mutex>

#include "core/base/clock.h"
#include "core/devices/gamepad.h"

namespace kambara::testing_support {

/// A gamepad that a test holds. It is read as long as it does not hang.
class FakeGamepad final : public GamepadBase {
  public:
    PadReading reading() const override {
        std::lock_guard lock(mutex_);
        if (!hangs_) {
            reading_.time_ns = clock_.now_ns();
        }
        return reading_;
    }
    void plug_in(bool present = true) {
        std::lock_guard lock(mutex_);
        reading_.present = present;
        reading_.name = "fake pad";
        reading_.device += present ? 1 : 0;
    }
    void stick(double right, double up) {
        std::lock_guard lock(mutex_);
        reading_.right = right;
        reading_.up = up;
    }
    void triggers(double zoom_in, double zoom_out) {
        std::lock_guard lock(mutex_);
        reading_.zoom_in = zoom_in;
        reading_.zoom_out = zoom_out;
    }
    void press_halt(bool pressed) {
        std::lock_guard lock(mutex_);
        reading_.halt = pressed;
    }
    void hang() {
        std::lock_guard lock(mutex_);
        hangs_ = true;
    }

  private:
    SteadyClock clock_;
    mutable std::mutex mutex_;
    mutable PadReading reading_;
    bool hangs_ = false;
};

}  // namespace kambara::testing_support
