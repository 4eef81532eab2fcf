// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "core/base/clock.h"
#include "hardware/visca/head_kind.h"
#include "hardware/visca/head_queue.h"
#include "hardware/visca/link.h"
#include "hardware/visca/position_estimate.h"
#include "hardware/visca/session.h"

namespace kambara::visca {

/// Keeps a head at what is wanted of it: opens the link and opens it again, tells the head what the
/// queue holds, asks where it looks, and tells again what was lost. Knows no threads: whoever runs
/// it calls `step` again and again, on one thread; the rest may be called from any.
///
/// The motion that is wanted goes through
///
///   waiting --free socket--> sent --ACK--> executing --completion--> done
///      ^                      |               |                       |
///      '-- refused, no reply -+-- link lost --+-- it looks elsewhere -'
///
/// A newer motion takes its place at any time but while it is sent.
class HeadDriver {
  public:
    struct Options {
        Session::Options session;
        std::vector<HeadKind> heads;
        std::optional<HeadKind> model;  ///< empty: by the version inquiry
        std::int64_t reopen_ns = 50'000'000;
        /// How much later than told the motors are where they should be while they follow.
        double motor_lag_s = 0.05;
        /// While it follows something, the head turns no faster than gets it to the aim just in
        /// time, so that it does not stop and start with every aim.
        bool paces = true;
        double make_up_s = 0.1;  ///< so long it takes to make up for what it is off by
        /// An aim that could not be told for so long is dropped: a newer one will come, unless the
        /// target is not seen any more.
        std::int64_t stale_aim_ns = 50'000'000;
    };

    HeadDriver(Link& link, HeadQueue& queue, const Clock& clock, Options options);

    /// One round: what is due is sent, then it waits for what comes, a tenth of a second at most.
    void step();
    /// A halt is wanted, and the head has not acknowledged it yet. On the thread of `step`.
    bool halts() const { return halt_ != Halt::none || queue_.halt_waits(); }

    /// The rest is for any thread.

    /// The head answers and its kind is known.
    bool connected() const;
    /// Why not; empty where it is.
    std::string fault() const;
    std::optional<HeadKind> model() const;
    /// An error while the head does not answer.
    Result<HeadStatus> status() const;
    Result<LensStatus> lens() const;
    std::vector<HeadNote> take_notes();
    std::uint64_t position_readings() const;
    /// From the first byte of an aim to the head's being there: the line's time, half a field's
    /// wait, and what the motors take (Options::motor_lag_s).
    double lag_s() const;
    /// The oldest aim so far when its first byte went out.
    double oldest_aim_s() const;

  private:
    enum class Stage { waiting, sent, executing, done };
    struct Current {
        Motion motion;
        Stage stage = Stage::waiting;
        Session::Id id = 0;
        std::int64_t not_before_ns = 0;
        int corrections = 0;
    };
    enum class Halt { none, wanted, sent };
    struct Setting {
        Message message;
        Session::Id id = 0;
        int refusals = 0;
        std::int64_t not_before_ns = 0;
    };
    struct Move {
        std::int64_t started_ns = 0;
        std::optional<std::int64_t> superseded_ns = std::nullopt;
    };

    void tell_wish(std::int64_t now_ns);
    void open_link(std::int64_t now_ns);
    void lose_link(const Error& error, std::int64_t now_ns);
    void follow_session(std::int64_t now_ns);
    void became_ready(std::int64_t now_ns);
    void lost(std::int64_t now_ns);
    void handle(const Session::Outcome& outcome, std::int64_t now_ns);
    void handle_motion(const Session::Outcome& outcome, std::int64_t now_ns);
    void motion_begins(const Session::Outcome& outcome, bool is_current, std::int64_t now_ns);
    void motion_ends(const Session::Outcome& outcome, std::int64_t now_ns);
    void motion_refused(const Session::Outcome& outcome, std::int64_t now_ns);
    /// What the head is taken to do from now on, until it says where it is.
    void expect(const Motion& motion, std::int64_t now_ns);
    void handle_halt(const Session::Outcome& outcome, std::int64_t now_ns);
    void handle_setting(const Session::Outcome& outcome, std::int64_t now_ns);
    void handle_answer(const Session::Outcome& outcome, std::int64_t now_ns);
    void read_position(const std::vector<int>& steps, std::int64_t now_ns);
    void verify(const HeadAngles& angles);
    void take_wishes(std::int64_t now_ns);
    void send_next(std::int64_t now_ns);
    bool send_cancel(std::int64_t now_ns);
    bool send_motion(std::int64_t now_ns);
    void take_aim(Motion& motion, std::int64_t now_ns) const;
    std::optional<HeadAngles> pace_towards(const Motion& motion, std::int64_t now_ns) const;
    double way_there_s() const;
    bool send_setting(std::int64_t now_ns);
    void ask(Op inquiry, std::int64_t now_ns);
    Message message_of(const Motion& motion) const;
    Message stop_message() const;
    void clear_moves();
    void abandon_superseded(std::int64_t now_ns);
    std::int64_t position_interval_ns() const;
    std::int64_t wait_until_ns(std::int64_t now_ns) const;
    void note(HeadNote::Kind kind, std::string text);
    void publish_fault(std::string fault);

    Link& link_;
    HeadQueue& queue_;
    const Clock& clock_;
    const Options options_;
    Session session_;
    bool open_ = false;
    bool ready_ = false;
    bool open_fault_noted_ = false;
    std::int64_t next_open_ns_ = 0;
    bool replaces_moves_ = true;

    std::optional<Current> current_;
    int syntax_errors_ = 0;
    std::map<Session::Id, Move> moves_;  // acknowledged, not completed
    std::deque<int> cancels_;            // sockets
    Session::Id cancel_id_ = 0;
    Halt halt_ = Halt::none;
    Session::Id halt_id_ = 0;
    std::int64_t halt_not_before_ns_ = 0;
    std::optional<Setting> setting_;
    bool motion_unanswered_ = false;
    std::int64_t position_asked_ns_ = 0;
    std::int64_t power_asked_ns_ = 0;
    std::int64_t lens_asked_ns_ = 0;
    int lens_turn_ = 0;
    bool power_is_known_ = false;

    mutable std::mutex mutex_;  // of what follows
    std::optional<HeadKind> model_;
    PositionEstimate estimate_;
    bool connected_ = false;
    std::string fault_;
    std::optional<LensStatus> lens_;
    std::deque<HeadNote> notes_;
    std::uint64_t readings_ = 0;
    std::int64_t oldest_aim_ns_ = 0;
};

}  // namespace kambara::visca
