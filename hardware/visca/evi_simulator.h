// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "hardware/visca/axis_motion.h"
#include "hardware/visca/message.h"
#include "hardware/visca/reply.h"

namespace kambara::visca {

/// An EVI-D30 as its controller sees it: packets in, packets out, at the times a camera takes. Does
/// no input and output and knows no clock: it is told the time, in ns from any origin, which never
/// runs back. Used by one thread at a time.
///
/// Packets wait until the next field of the picture, one is taken each field (16.7 or 20 ms). A
/// command gets one of two sockets, an acknowledgement at once and its completion when the motion
/// has ended:
///
///   packet --field--> no socket free: buffer full     --> forgotten
///                     not in this mode: not executable --> forgotten
///                     ACK --> executing --motion's end--> completion
///                               |--cancel--> cancelled
///                               |--a newer motion takes over--> completion
///                               '--interface clear, power cut--> forgotten
///
/// Facts of the camera are from the sheet visca (EVI-D30 units, status word, AT and MD). What no
/// source tells is an option.
class EviSimulator {
  public:
    struct Options {
        bool pal = false;
        int rom = 0x0101;
        double pan_acceleration_deg_s2 = 400.0;   ///< not known of the EVI-D30
        double tilt_acceleration_deg_s2 = 400.0;  ///< likewise
        double zoom_range_s = 2.0;                ///< end to end; likewise
        double focus_range_s = 2.0;               ///< likewise
        double power_on_s = 3.0;                  ///< likewise
        /// A drive command (stop, too) is not executable while a position is moved to, as Player's
        /// driver met it. A newer position takes over from an older one.
        bool refuses_drive_in_move = true;
        /// A stop is completed once the head has come to rest, or when something else takes over.
        bool completes_stop_at_rest = false;
    };

    /// Says whose packet it was; comes back with the replies.
    using Tag = std::uint64_t;
    struct Output {
        Tag tag = 0;
        Bytes packet;
        std::int64_t time_ns = 0;
    };
    /// What no controller sees so exactly.
    struct State {
        double pan_steps = 0.0;
        double tilt_steps = 0.0;
        double zoom = 0.0;
        double focus = 0.0;
        bool moving = false;
        bool on = true;
        int sockets_in_use = 0;
    };

    explicit EviSimulator(std::int64_t now_ns) : EviSimulator(now_ns, Options{}) {}
    EviSimulator(std::int64_t now_ns, const Options& options);

    /// A whole packet arrived. What is not for this camera is passed over.
    void receive(std::span<const std::uint8_t> packet, Tag tag, std::int64_t now_ns);
    /// A packet of more than 16 bytes arrived.
    void receive_too_long(Tag tag, std::int64_t now_ns);
    /// Lives on until then; what it said by then.
    std::vector<Output> advance(std::int64_t now_ns);
    /// When it may next have something to say.
    std::optional<std::int64_t> next_event_ns() const;

    /// The mains go and come back: everything but the presets is forgotten, the head turns to home,
    /// and the network change is told to `tag`.
    void power_cycle(Tag tag, std::int64_t now_ns);

    State state() const;
    int address() const { return address_; }

  private:
    static constexpr int sockets = 2;
    static constexpr int presets = 6;
    enum class Waits { pan_tilt, zoom, focus, lens_and_head, time };
    struct Task {
        Message message;
        Tag tag = 0;
        Waits waits = Waits::time;
        std::int64_t until_ns = 0;
    };
    struct Waiting {
        Bytes packet;
        Tag tag = 0;
    };
    struct Preset {
        double pan = 0.0;
        double tilt = 0.0;
        double zoom = 0.0;
        double focus = 0.0;
    };

    void reset_state();
    void say(const Reply& reply, Tag tag, int address);
    void take(const Waiting& waiting);
    void answer(Op inquiry, Tag tag);
    std::vector<int> answer_to(Op inquiry) const;
    void cancel(int socket, Tag tag);
    void clear_interface();
    void command(const Message& message, Tag tag);
    bool has_bad_value(const Message& message) const;
    bool is_executable(const Message& message) const;
    /// Carries it out or begins to; what its completion waits for, if it does.
    std::optional<Waits> begin(const Message& message);
    std::optional<Waits> begin_motion(const Message& message);
    std::optional<Waits> begin_lens(const Message& message);
    void set(const Message& message);
    void step_value(Op which, int direction);
    void turn_to(double pan, double tilt, int pan_code, int tilt_code);
    bool in_move() const;
    bool is_done(const Task& task) const;
    void complete_finished();
    void finish_motion_before(int but_socket);
    void move_on();
    int status_word() const;
    int setting(Op op, int otherwise) const;

    Options options_;
    std::int64_t field_ns_;
    std::int64_t time_ns_;
    std::int64_t next_field_ns_;
    std::int64_t next_step_ns_;
    int address_ = 1;
    std::deque<Waiting> waiting_;
    std::array<std::optional<Task>, sockets> tasks_;
    std::vector<Output> outputs_;
    AxisMotion pan_;
    AxisMotion tilt_;
    AxisMotion zoom_;
    AxisMotion focus_;
    std::array<Preset, presets> presets_;
    std::map<Op, int> settings_;
    bool returns_home_ = false;  // the second half of a reset
    bool initialising_ = false;
    bool moved_ = false;
    std::optional<Tag> tells_network_change_;
};

}  // namespace kambara::visca
