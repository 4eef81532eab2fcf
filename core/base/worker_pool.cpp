// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/worker_pool.h"

#include <algorithm>

namespace kambara {
namespace {

std::size_t helpers_of(int threads) {
    const auto wanted =
        threads > 0 ? static_cast<unsigned>(threads) : std::thread::hardware_concurrency();
    return std::max(wanted, 1U) - 1U;
}

}  // namespace

WorkerPool::WorkerPool(int threads) : most_helpers_(helpers_of(threads)) {}

void WorkerPool::for_each(std::size_t count, const std::function<void(std::size_t)>& work) {
    if (count < 2 || most_helpers_ == 0) {
        for (std::size_t piece = 0; piece < count; ++piece) {
            work(piece);
        }
        return;
    }
    start_helpers(std::min(most_helpers_, count - 1));
    std::unique_lock lock(mutex_);
    work_ = &work;
    count_ = count;
    next_ = 0;
    unfinished_ = count;
    arrived_.notify_all();
    take_pieces(lock);
    finished_.wait(lock, [this] { return unfinished_ == 0; });
}

void WorkerPool::start_helpers(std::size_t wanted) {
    while (helpers_.size() < wanted) {
        helpers_.emplace_back([this](const std::stop_token& stop) { help(stop); });
    }
}

void WorkerPool::help(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    while (arrived_.wait(lock, stop, [this] { return next_ < count_; })) {
        take_pieces(lock);
    }
}

void WorkerPool::take_pieces(std::unique_lock<std::mutex>& lock) {
    while (next_ < count_) {
        const std::size_t piece = next_++;
        const auto& work = *work_;
        lock.unlock();
        work(piece);
        lock.lock();
        if (--unfinished_ == 0) {
            finished_.notify_one();
        }
    }
}

}  // namespace kambara
