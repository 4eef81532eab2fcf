// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <mutex>
#include <string>

#include "core/devices/pan_tilt_camera.h"

namespace kambara::testing_support {

/// A head that is at once where it is told to look, and remembers what it was told.
class InstantHead final : public PanTiltCamera {
  public:
    std::string name() const override { return "instant"; }
    HeadLimits limits() const override { return {}; }
    Result<Done> move_to(const HeadAngles& angles) override {
        if (refusals-- > 0) {
            return Error{"The head does not answer.", "Look at its cable."};
        }
        std::lock_guard lock(mutex_);
        angles_ = angles;
        ++moves_;
        return Done{};
    }
    Result<Done> halt() override {
        ++halts;
        return Done{};
    }
    Result<HeadStatus> status() override {
        std::lock_guard lock(mutex_);
        return HeadStatus{angles_, false, 0};
    }
    int moves() const {
        std::lock_guard lock(mutex_);
        return moves_;
    }

    std::atomic<int> halts = 0;
    std::atomic<int> refusals = 0;  // of the next moves

  private:
    mutable std::mutex mutex_;
    HeadAngles angles_;
    int moves_ = 0;
};

}  // namespace kambara::testing_support
