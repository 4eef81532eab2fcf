// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <stop_token>
#include <utility>

namespace kambara {

/// A mailbox for one value where the newest wins: a writer never waits, a slow reader loses old
/// values and is told how many. Any number of writers, one reader of `take`; all members may be
/// called from any thread.
template <class T>
class LatestValue {
  public:
    void put(T value) {
        {
            std::lock_guard lock(mutex_);
            if (value_) {
                ++overwritten_;
            }
            value_ = std::move(value);
        }
        arrived_.notify_one();
    }

    /// Waits for a value; empty once a stop is requested.
    std::optional<T> take(std::stop_token stop) {
        std::unique_lock lock(mutex_);
        if (!arrived_.wait(lock, stop, [&] { return value_.has_value(); })) {
            return std::nullopt;
        }
        return std::exchange(value_, std::nullopt);
    }

    /// The value if one is waiting.
    std::optional<T> try_take() {
        std::lock_guard lock(mutex_);
        return std::exchange(value_, std::nullopt);
    }

    /// How many values were replaced before anyone took them.
    std::uint64_t overwritten() const {
        std::lock_guard lock(mutex_);
        return overwritten_;
    }

  private:
    mutable std::mutex mutex_;
    std::condition_variable_any arrived_;
    std::optional<T> value_;
    std::uint64_t overwritten_ = 0;
};

}  // namespace kambara
