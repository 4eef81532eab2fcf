// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/devices/grabber_base.h"

namespace kambara::testing_support {

/// A source that gives the frames it was made with, then ends or fails.
class ListGrabber final : public GrabberBase {
  public:
    ListGrabber(std::vector<Frame> frames, int width, int height,
                std::optional<Error> failure = std::nullopt)
        : frames_(std::move(frames)),
          info_{"list", width, height, 30.0, false, static_cast<std::int64_t>(frames_.size())},
          failure_(std::move(failure)) {}

    Result<std::optional<Frame>> grab(std::stop_token) override {
        if (next_ < frames_.size()) {
            return std::optional<Frame>(frames_[next_++]);
        }
        if (failure_) {
            return *failure_;
        }
        return std::optional<Frame>();
    }
    GrabberInfo info() const override { return info_; }
    /// From now on it can't be wound to frames from `index` on.
    void refuse_seeks_from(std::int64_t index) { refuses_from_ = index; }

    Result<Done> seek(std::int64_t index) override {
        if (index >= refuses_from_) {
            return Error{"The tape is torn.", "Mend it."};
        }
        next_ = static_cast<std::size_t>(index);
        return Done{};
    }

  private:
    std::vector<Frame> frames_;
    GrabberInfo info_;
    std::optional<Error> failure_;
    std::size_t next_ = 0;
    std::int64_t refuses_from_ = std::numeric_limits<std::int64_t>::max();
};

}  // namespace kambara::testing_support
