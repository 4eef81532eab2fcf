// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
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
    Result<Done> seek(std::int64_t index) override {
        next_ = static_cast<std::size_t>(index);
        return Done{};
    }

  private:
    std::vector<Frame> frames_;
    GrabberInfo info_;
    std::optional<Error> failure_;
    std::size_t next_ = 0;
};

}  // namespace kambara::testing_support
