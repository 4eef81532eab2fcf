// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/clock.h"

#include <algorithm>
#include <chrono>

namespace kambara {

std::int64_t SteadyClock::now_ns() const {
    return std::chrono::duration_cast<std::chrono::nanoseconds>(
               std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

bool SteadyClock::sleep_until_ns(std::int64_t time_ns, std::stop_token stop) {
    std::mutex mutex;
    std::condition_variable_any never;
    std::unique_lock lock(mutex);
    const std::chrono::steady_clock::time_point wake{std::chrono::nanoseconds(time_ns)};
    never.wait_until(lock, stop, wake, [&] { return now_ns() >= time_ns; });
    return !stop.stop_requested();
}

std::int64_t ManualClock::now_ns() const {
    std::lock_guard lock(mutex_);
    return now_ns_;
}

bool ManualClock::sleep_until_ns(std::int64_t time_ns, std::stop_token stop) {
    std::unique_lock lock(mutex_);
    moved_.wait(lock, stop, [&] { return now_ns_ >= time_ns; });
    return !stop.stop_requested();
}

void ManualClock::set_ns(std::int64_t time_ns) {
    {
        std::lock_guard lock(mutex_);
        now_ns_ = std::max(now_ns_, time_ns);
    }
    moved_.notify_all();
}

}  // namespace kambara
