// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
#include <stop_token>
#include <thread>
#include <vector>

namespace kambara {

/// Shares work out among threads that stay from one call to the next. Pieces that touch nothing of
/// each other's give the same results with any number of threads. Used by one thread at a time.
class WorkerPool {
  public:
    /// `threads`, the caller's own included; 0 for as many as the machine has cores.
    explicit WorkerPool(int threads = 0);

    /// Calls work(0), ..., work(count - 1), once each and in any order, and returns when all have
    /// returned. A single piece is done by the caller; helpers are started when first needed.
    /// `work` throws nothing.
    void for_each(std::size_t count, const std::function<void(std::size_t)>& work);

  private:
    void start_helpers(std::size_t wanted);
    void help(const std::stop_token& stop);
    void take_pieces(std::unique_lock<std::mutex>& lock);

    const std::size_t most_helpers_;
    std::mutex mutex_;
    std::condition_variable_any arrived_;
    std::condition_variable finished_;
    const std::function<void(std::size_t)>* work_ = nullptr;
    std::size_t count_ = 0;
    std::size_t next_ = 0;
    std::size_t unfinished_ = 0;
    std::vector<std::jthread> helpers_;  // last, so that they end before what they use
};

}  // namespace kambara
