// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <stop_token>
#include <thread>

namespace kambara {

/// A thread that does what it is given, one piece after the other. Its members may be called from
/// any thread but its own, `put` from that one, too. What still waits when it ends is dropped.
class WorkThread {
  public:
    WorkThread();

    /// `work` throws nothing.
    void put(std::function<void()> work);
    /// Returns when what is under way has returned; nothing is begun from then on.
    void end();

  private:
    void run(const std::stop_token& stop);

    std::mutex mutex_;
    std::condition_variable_any arrived_;
    std::deque<std::function<void()>> work_;
    std::jthread thread_;  // last, so that it ends before what it uses
};

}  // namespace kambara
