// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <stop_token>

namespace kambara {

/// The port through which the project reads time and sleeps, so that time-outs and motion can be
/// tested without waiting. Times are nanoseconds from an origin of the clock's own choosing; they
/// never run backwards. All members may be called from any thread.
class Clock {
  public:
    virtual ~Clock() = default;
    virtual std::int64_t now_ns() const = 0;
    /// Returns when the time has come or a stop is requested; false for the latter.
    virtual bool sleep_until_ns(std::int64_t time_ns, std::stop_token stop) = 0;
};

/// The machine's monotonic clock.
class SteadyClock final : public Clock {
  public:
    std::int64_t now_ns() const override;
    bool sleep_until_ns(std::int64_t time_ns, std::stop_token stop) override;
};

/// A clock that moves only when told to: for tests, and for sources that replay faster than life.
class ManualClock final : public Clock {
  public:
    explicit ManualClock(std::int64_t start_ns = 0) : now_ns_(start_ns) {}
    std::int64_t now_ns() const override;
    bool sleep_until_ns(std::int64_t time_ns, std::stop_token stop) override;
    /// Never moves back: an earlier time leaves the clock as it is.
    void set_ns(std::int64_t time_ns);

  private:
    mutable std::mutex mutex_;
    std::condition_variable_any moved_;
    std::int64_t now_ns_;
};

}  // namespace kambara
