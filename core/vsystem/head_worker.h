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
#include <variant>
#include <vector>

#include "core/base/clock.h"
#include "core/devices/pan_tilt_camera.h"
#include "core/pointing/head_axes.h"
#include "core/vsystem/command.h"

namespace kambara {

/// Talks to a head so that the pipeline need not wait for it (PTZ-2): the newest motion wins,
/// settings of the lens keep their order, and what the head last said is there at once. Members may
/// be called from any thread.
class HeadWorker {
  public:
    enum class Threading {
        own_thread,    ///< a live head: every call to it is made on a thread of the worker's own
        inline_calls,  ///< with a recording or a simulation in step: calls are made in `command`
                       ///< and `reading`, so that a run gives the same result every time; only a
                       ///< drive that is not renewed is ended by the worker's thread
    };

    struct Reading {
        HeadStatus status;  ///< of the encoders, as the head tells it
        HeadAngles axes;    ///< where the axes are: behind by what the backlash leaves
        std::string fault;
        std::optional<LensStatus> lens;
        HeadAbilities abilities;
    };

    /// What turns the head beside looking somewhere, and what only changes its lens or memory.
    using Turn = std::variant<HomeHead, ResetHead, RecallPreset>;
    using Setting = std::variant<ZoomHead, FocusHead, AutofocusHead, KeepPreset>;

    /// `clock` outlives the worker, times what is driven and dates where the head was.
    HeadWorker(std::shared_ptr<PanTiltCamera> head, Threading threading, const Clock& clock);
    /// Halts a head that is being driven; other motions come to their end by themselves.
    ~HeadWorker();

    HeadLimits limits() const { return limits_; }
    /// Of both axes, as the rig's head model has it; none at first.
    void use_backlash(const HeadAngles& backlash);
    /// Where the encoders are to be told to go so that the axes end there, within the limits.
    HeadAngles encoders_for(const HeadAngles& axes);
    /// Where the axes are while the encoders tell this, if these have not turned round since.
    HeadAngles axes_at(const HeadAngles& encoders);
    /// The axes are off by so much that they came from the other side than was thought.
    bool astray(const HeadAngles& axes);
    /// `by_hand`: an operator's wish, not steering's.
    void command(const HeadAngles& angles, bool by_hand = false);
    /// Steering's.
    void follow(const HeadAim& aim);
    /// As the head says (PanTiltCamera).
    double lag_s() const { return head_->lag_s(); }
    /// Turns at these speeds until told otherwise, at the longest for drive_renewal_s: told the
    /// same again, it goes on.
    void drive(const HeadAngles& speed_rad_s);
    /// Ends a drive, if there is one; other motions go on.
    void end_drive();
    void turn(const Turn& turn);
    void set(const Setting& setting);
    /// Stops the head; motions that still wait are dropped.
    void halt();
    Reading reading();
    /// Where its axes were at a time of the last second, by the clock; with inline calls, now.
    /// Empty while it does not say.
    std::optional<HeadAngles> axes_when(std::int64_t time_ns);
    /// How much larger its camera shows things than at its widest; 1 where its lens does not say.
    double magnification() const;
    /// What happened to the head since the last call.
    std::vector<HeadNote> take_notes();
    /// The last command was refused by the device.
    bool move_failed() const;

  private:
    struct Look {
        HeadAngles angles;
        bool by_hand = false;
        std::optional<HeadAim> aim = std::nullopt;
    };
    struct Drive {
        HeadAngles speed_rad_s;
    };
    using Wish = std::variant<Look, Drive, Turn>;

    void run(const std::stop_token& stop);
    void put(const Wish& wish);
    void move(const Wish& wish);
    Result<Done> carry_out(const Wish& wish);
    void change(const Setting& setting);
    void stop_moving();
    bool drive_is_over();
    void poll();

    std::shared_ptr<PanTiltCamera> head_;
    const Threading threading_;
    const Clock& clock_;
    const HeadLimits limits_;
    mutable std::mutex mutex_;
    std::condition_variable_any commanded_;
    std::optional<Wish> waiting_;
    bool halt_waits_ = false;
    std::deque<Setting> settings_;
    std::optional<HeadAngles> driven_;  // at this speed,
    std::int64_t drive_until_ns_ = 0;   // so long
    HeadStatus status_;
    std::optional<LensStatus> lens_;
    HeadAbilities abilities_;
    std::string move_fault_;
    std::string status_fault_;
    struct Past {
        std::int64_t time_ns = 0;
        HeadAngles axes;
    };
    std::deque<Past> past_;
    HeadAxes axes_;
    std::vector<HeadNote> notes_;  // the worker's own
    std::jthread thread_;          // last, so that it ends before what it uses
};

}  // namespace kambara
