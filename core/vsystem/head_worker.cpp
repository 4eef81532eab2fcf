// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/vsystem/head_worker.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace kambara {
namespace {

constexpr std::chrono::milliseconds poll_interval{20};
constexpr std::int64_t kept_ns = 1'000'000'000;

}  // namespace

HeadWorker::HeadWorker(std::shared_ptr<PanTiltCamera> head, Threading threading, const Clock& clock)
    : head_(std::move(head)), threading_(threading), clock_(clock), limits_(head_->limits()) {
    poll();  // so that the first reading is one
    if (threading_ == Threading::own_thread) {
        thread_ = std::jthread([this](std::stop_token stop) { run(stop); });
    }
}

HeadWorker::~HeadWorker() = default;

void HeadWorker::command(const HeadAngles& angles, bool by_hand) {
    put({angles, by_hand});
}

void HeadWorker::follow(const HeadAim& aim) {
    put({aim.angles, false, aim});
}

void HeadWorker::put(const Wish& wish) {
    if (threading_ == Threading::inline_calls) {
        move(wish);
        return;
    }
    {
        std::lock_guard lock(mutex_);
        waiting_ = wish;
    }
    commanded_.notify_one();
}

void HeadWorker::halt() {
    if (threading_ == Threading::inline_calls) {
        stop_moving();
        return;
    }
    {
        std::lock_guard lock(mutex_);
        waiting_.reset();
        halt_waits_ = true;
    }
    commanded_.notify_one();
}

HeadWorker::Reading HeadWorker::reading() {
    if (threading_ == Threading::inline_calls) {
        poll();
    }
    std::lock_guard lock(mutex_);
    return {status_, status_fault_.empty() ? move_fault_ : status_fault_};
}

bool HeadWorker::move_failed() const {
    std::lock_guard lock(mutex_);
    return !move_fault_.empty();
}

double HeadWorker::horizontal_view_rad() const {
    std::lock_guard lock(mutex_);
    return horizontal_view_rad_;
}

void HeadWorker::run(std::stop_token stop) {
    while (!stop.stop_requested()) {
        std::optional<Wish> wish;
        bool halt = false;
        {
            std::unique_lock lock(mutex_);
            commanded_.wait_for(lock, stop, poll_interval,
                                [&] { return waiting_.has_value() || halt_waits_; });
            halt = std::exchange(halt_waits_, false);
            wish = std::exchange(waiting_, std::nullopt);
        }
        if (halt) {
            stop_moving();
        }
        if (wish) {
            move(*wish);
        }
        poll();
    }
}

void HeadWorker::move(const Wish& wish) {
    const auto moved = wish.aim       ? head_->follow(*wish.aim)
                       : wish.by_hand ? head_->move_by_hand(wish.angles)
                                      : head_->move_to(wish.angles);
    std::lock_guard lock(mutex_);
    move_fault_ = moved ? std::string() : moved.error().text();
}

void HeadWorker::stop_moving() {
    const auto halted = head_->halt();
    std::lock_guard lock(mutex_);
    move_fault_ = halted ? std::string() : halted.error().text();
}

void HeadWorker::poll() {
    const auto status = head_->status();
    const auto lens = head_->lens();
    const std::int64_t now_ns = clock_.now_ns();
    std::lock_guard lock(mutex_);
    horizontal_view_rad_ = lens ? lens->horizontal_view_rad : 0.0;
    status_fault_ = status ? std::string() : status.error().text();
    if (status) {
        status_ = *status;
        past_.push_back({now_ns, status->angles});
        while (past_.front().time_ns < now_ns - kept_ns) {
            past_.pop_front();
        }
    }
}

std::optional<HeadAngles> HeadWorker::angles_at(std::int64_t time_ns) {
    if (threading_ == Threading::inline_calls) {
        poll();
    }
    std::lock_guard lock(mutex_);
    if (!status_fault_.empty() || past_.empty()) {
        return std::nullopt;
    }
    if (threading_ == Threading::inline_calls || time_ns >= past_.back().time_ns) {
        return past_.back().angles;
    }
    for (std::size_t i = past_.size() - 1; i > 0; --i) {
        const Past& a = past_[i - 1];
        const Past& b = past_[i];
        if (time_ns >= a.time_ns) {
            const double share =
                static_cast<double>(time_ns - a.time_ns) /
                static_cast<double>(std::max<std::int64_t>(1, b.time_ns - a.time_ns));
            return HeadAngles{a.angles.pan_rad + share * (b.angles.pan_rad - a.angles.pan_rad),
                              a.angles.tilt_rad + share * (b.angles.tilt_rad - a.angles.tilt_rad)};
        }
    }
    return past_.front().angles;
}

}  // namespace kambara
