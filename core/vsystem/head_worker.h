// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "core/base/clock.h"
#include "core/devices/pan_tilt_camera.h"

namespace kambara {

/// Talks to a head so that the pipeline need not wait for it (PTZ-2): the newest angles win, and
/// what the head last said is there at once. Members may be called from any thread.
class HeadWorker {
  public:
    enum class Threading {
        own_thread,    ///< a live head: every call to it is made on a thread of the worker's own
        inline_calls,  ///< with a recording or a simulation in step: calls are made in `command`
                       ///< and `reading`, so that a run gives the same result every time
    };

    struct Reading {
        HeadStatus status;
        std::string fault;
    };

    /// `clock` outlives it and dates where the head was.
    HeadWorker(std::shared_ptr<PanTiltCamera> head, Threading threading, const Clock& clock);
    ~HeadWorker();

    HeadLimits limits() const { return limits_; }
    /// `by_hand`: an operator's wish, not steering's.
    void command(const HeadAngles& angles, bool by_hand = false);
    /// Steering's.
    void follow(const HeadAim& aim);
    /// As the head says (PanTiltCamera).
    double lag_s() const { return head_->lag_s(); }
    /// Stops the head; angles that still wait are dropped.
    void halt();
    Reading reading();
    /// Where it looked at a time of the last second, by the clock; with inline calls, now. Empty
    /// while it does not say.
    std::optional<HeadAngles> angles_at(std::int64_t time_ns);
    /// What its camera sees from the left to the right edge, as its lens says; 0 where it does not.
    double horizontal_view_rad() const;
    /// What happened to the head since the last call.
    std::vector<HeadNote> take_notes() { return head_->take_notes(); }
    /// The last command was refused by the device.
    bool move_failed() const;

  private:
    void run(std::stop_token stop);
    struct Wish {
        HeadAngles angles;
        bool by_hand = false;
        std::optional<HeadAim> aim = std::nullopt;
    };
    void put(const Wish& wish);
    void move(const Wish& wish);
    void stop_moving();
    void poll();

    std::shared_ptr<PanTiltCamera> head_;
    const Threading threading_;
    const Clock& clock_;
    const HeadLimits limits_;
    mutable std::mutex mutex_;
    std::condition_variable_any commanded_;
    std::optional<Wish> waiting_;
    bool halt_waits_ = false;
    HeadStatus status_;
    std::string move_fault_;
    std::string status_fault_;
    double horizontal_view_rad_ = 0.0;
    struct Past {
        std::int64_t time_ns = 0;
        HeadAngles angles;
    };
    std::deque<Past> past_;
    std::jthread thread_;  // last, so that it ends before what it uses
};

}  // namespace kambara
