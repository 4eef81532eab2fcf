// SPDX-License-Identifier: GPL-3.0-or-later
#include "hardware/visca/head_queue.h"

#include <algorithm>
#include <utility>

namespace kambara::visca {
namespace {

// A preset is one of several of its kind.
bool same_kind(const Message& a, const Message& b) {
    return a.op == b.op && (a.op != Op::memory_set || a.values == b.values);
}

}  // namespace

void HeadQueue::put(const Motion& motion) {
    std::lock_guard lock(mutex_);
    auto& place = motion.by_hand ? by_hand_ : steering_;
    replaced_ += place ? 1 : 0;
    place = motion;
    if (motion.by_hand && std::exchange(steering_, std::nullopt)) {
        ++replaced_;
    }
    // A newer wish to turn: the halt before it has still to be told, as it may stop what the motion
    // would not take over from.
}

void HeadQueue::halt() {
    std::lock_guard lock(mutex_);
    replaced_ += (by_hand_ ? 1U : 0U) + (steering_ ? 1U : 0U);
    by_hand_.reset();
    steering_.reset();
    halt_ = true;
}

void HeadQueue::put(const Message& setting) {
    std::lock_guard lock(mutex_);
    std::erase_if(settings_, [&](const Message& one) { return same_kind(one, setting); });
    settings_.push_back(setting);
}

bool HeadQueue::take_halt() {
    std::lock_guard lock(mutex_);
    return std::exchange(halt_, false);
}

bool HeadQueue::halt_waits() const {
    std::lock_guard lock(mutex_);
    return halt_;
}

std::optional<Motion> HeadQueue::take_motion(bool by_hand_only) {
    std::lock_guard lock(mutex_);
    if (by_hand_) {
        return std::exchange(by_hand_, std::nullopt);
    }
    return by_hand_only ? std::nullopt : std::exchange(steering_, std::nullopt);
}

std::optional<Message> HeadQueue::take_setting() {
    std::lock_guard lock(mutex_);
    if (settings_.empty()) {
        return std::nullopt;
    }
    Message first = std::move(settings_.front());
    settings_.pop_front();
    return first;
}

void HeadQueue::put_back(const Message& setting) {
    std::lock_guard lock(mutex_);
    const bool newer = std::any_of(settings_.begin(), settings_.end(),
                                   [&](const Message& one) { return same_kind(one, setting); });
    if (!newer) {
        settings_.push_front(setting);
    }
}

std::uint64_t HeadQueue::replaced() const {
    std::lock_guard lock(mutex_);
    return replaced_;
}

}  // namespace kambara::visca
