// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "core/vsystem/vsystem_interface.h"

namespace kambara {

/// Observers that come and go from any thread and are called from one thread at a time, with no
/// lock held during the call.
template <class Argument>
class ObserverList {
  public:
    using Observer = std::function<void(const Argument&)>;

    std::unique_ptr<Observation> add(Observer observer) {
        auto slot = std::make_shared<Slot>(std::move(observer));
        std::lock_guard lock(mutex_);
        std::erase_if(slots_, [](const auto& old) { return old.expired(); });
        slots_.push_back(slot);
        return std::make_unique<Held>(std::move(slot));
    }

    void notify(const Argument& argument) {
        std::vector<std::shared_ptr<Slot>> present;
        {
            std::lock_guard lock(mutex_);
            for (const auto& slot : slots_) {
                if (auto alive = slot.lock()) {
                    present.push_back(std::move(alive));
                }
            }
        }
        for (const auto& slot : present) {
            slot->call(argument);
        }
    }

  private:
    class Slot {
      public:
        explicit Slot(Observer observer) : observer_(std::move(observer)) {}

        void call(const Argument& argument) {
            {
                std::lock_guard lock(mutex_);
                if (closed_) {
                    return;
                }
                caller_ = std::this_thread::get_id();
                ++depth_;
            }
            observer_(argument);
            {
                // An observer's own command may call it again before it returns.
                std::lock_guard lock(mutex_);
                if (--depth_ == 0) {
                    caller_ = {};
                }
            }
            returned_.notify_all();
        }

        void close() {
            std::unique_lock lock(mutex_);
            closed_ = true;
            const auto self = std::this_thread::get_id();
            returned_.wait(lock, [&] { return caller_ == std::thread::id() || caller_ == self; });
        }

      private:
        const Observer observer_;
        std::mutex mutex_;
        std::condition_variable returned_;
        std::thread::id caller_;
        int depth_ = 0;
        bool closed_ = false;
    };

    class Held final : public Observation {
      public:
        explicit Held(std::shared_ptr<Slot> slot) : slot_(std::move(slot)) {}
        ~Held() override { slot_->close(); }

      private:
        std::shared_ptr<Slot> slot_;
    };

    std::mutex mutex_;
    std::vector<std::weak_ptr<Slot>> slots_;
};

}  // namespace kambara
