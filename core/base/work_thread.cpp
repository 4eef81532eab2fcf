// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/work_thread.h"

#include <utility>

namespace kambara {

WorkThread::WorkThread() : thread_([this](const std::stop_token& stop) { run(stop); }) {}

void WorkThread::put(std::function<void()> work) {
    {
        std::lock_guard lock(mutex_);
        work_.push_back(std::move(work));
    }
    arrived_.notify_one();
}

void WorkThread::end() {
    thread_.request_stop();
    if (thread_.joinable()) {
        thread_.join();
    }
}

void WorkThread::run(const std::stop_token& stop) {
    while (true) {
        std::function<void()> work;
        {
            std::unique_lock lock(mutex_);
            if (!arrived_.wait(lock, stop, [&] { return !work_.empty(); }) ||
                stop.stop_requested()) {
                return;
            }
            work = std::move(work_.front());
            work_.pop_front();
        }
        work();
    }
}

}  // namespace kambara
