// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <atomic>
#include <mutex>
#include <string>

#include "core/devices/pan_tilt_camera.h"

namespace kambara::testing_support {

/// A head that is at once where it is told to look, and remembers what it was told. Its axes lag
/// behind by what the play between them and the encoders leaves.
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
        axes_ = {carried(axes_.pan_rad, angles.pan_rad, backlash.pan_rad),
                 carried(axes_.tilt_rad, angles.tilt_rad, backlash.tilt_rad)};
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

    HeadAngles axes() const {
        std::lock_guard lock(mutex_);
        return axes_;
    }

    HeadAngles backlash;  // set before it is used
    std::atomic<int> halts = 0;
    std::atomic<int> refusals = 0;  // of the next moves

  private:
    static double carried(double axis, double encoder, double play) {
        return std::clamp(axis, encoder - 0.5 * play, encoder + 0.5 * play);
    }

    mutable std::mutex mutex_;
    HeadAngles angles_;
    HeadAngles axes_;
    int moves_ = 0;
};

}  // namespace kambara::testing_support
