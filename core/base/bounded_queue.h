// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>
#include <stop_token>
#include <utility>

namespace kambara {

/// A first-in first-out queue with a bound. `push` waits for room; `push_dropping_oldest` never
/// waits and counts what it threw away. All members may be called from any thread.
template <class T>
class BoundedQueue {
  public:
    explicit BoundedQueue(std::size_t capacity) : capacity_(capacity) {}

    /// False when a stop was requested before there was room.
    bool push(T value, std::stop_token stop) {
        std::unique_lock lock(mutex_);
        if (!changed_.wait(lock, stop, [&] { return values_.size() < capacity_; })) {
            return false;
        }
        values_.push_back(std::move(value));
        lock.unlock();
        changed_.notify_all();
        return true;
    }

    void push_dropping_oldest(T value) {
        {
            std::lock_guard lock(mutex_);
            if (values_.size() >= capacity_) {
                values_.pop_front();
                ++dropped_;
            }
            values_.push_back(std::move(value));
        }
        changed_.notify_all();
    }

    /// Waits for a value; empty once a stop is requested.
    std::optional<T> pop(std::stop_token stop) {
        std::unique_lock lock(mutex_);
        if (!changed_.wait(lock, stop, [&] { return !values_.empty(); })) {
            return std::nullopt;
        }
        std::optional<T> value(std::move(values_.front()));
        values_.pop_front();
        lock.unlock();
        changed_.notify_all();
        return value;
    }

    std::uint64_t dropped() const {
        std::lock_guard lock(mutex_);
        return dropped_;
    }

  private:
    const std::size_t capacity_;
    mutable std::mutex mutex_;
    std::condition_variable_any changed_;
    std::deque<T> values_;
    std::uint64_t dropped_ = 0;
};

}  // namespace kambara
