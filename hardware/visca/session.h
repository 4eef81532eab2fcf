// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/devices/pan_tilt_camera.h"
#include "hardware/visca/ip_header.h"
#include "hardware/visca/message.h"
#include "hardware/visca/reply.h"

namespace kambara::visca {

/// How the packets travel (visca: start-up sequence, VISCA over IP).
enum class Wiring {
    serial,
    tcp,       ///< as on a serial line
    udp,       ///< packets without a header
    udp_sony,  ///< with header and sequence numbers
};

/// What the version inquiry said.
struct Identity {
    int vendor = 0;
    int model = 0;
    int rom = 0;
    int sockets = 2;
    bool operator==(const Identity&) const = default;
};

/// The controller's end of a link to one camera: start-up, one message at a time until it is
/// acknowledged, replies matched by socket (and sequence number), time-outs, repetition. Does no
/// input and output and knows no clock: bytes go in and out, and it is told the time (ns, never
/// running back). Used by one thread at a time.
///
///   closed --open--> resetting (udp_sony) --> addressing (serial, tcp) --> clearing -->
///   identifying
///                        ^                                                                  |
///                        '------------- network change, no answer any more ------------- ready
///
/// Start-up is tried again without end; a head that has answered before is asked who it is, and
/// only every fourth time given an address again, which takes longer. Of a message that was given
/// to `send` exactly one last outcome comes; a command has `acknowledged` before it. What is sent
/// again without need does no harm (a position), else it is not (a relative move, a switch to the
/// other position).
class Session {
  public:
    struct Options {
        Wiring wiring = Wiring::serial;
        int address = 1;
        Dialect dialect = {};
        /// Replies with another sequence number are passed over. Some cameras count wrongly.
        bool checks_sequence = true;
        /// From when a packet is out until its reply must have come: the four fields of the slowest
        /// camera known. Once replies have shown to come sooner, less is waited for the next one,
        /// and more again after each that did not come.
        std::int64_t reply_timeout_ns = 80'000'000;
        /// What a byte takes on the line.
        std::int64_t byte_ns = 0;
        /// So often a message is sent again.
        int repetitions = 2;
        /// After more than `repetitions` in a row without a reply, and so long a silence, the link
        /// is started up anew.
        std::int64_t silence_ns = 500'000'000;
        /// Nothing new is sent so long after something that was sent twice: its second reply may
        /// still come.
        std::int64_t quiet_ns = 60'000'000;
    };
    enum class State { closed, resetting, addressing, clearing, identifying, ready };
    using Id = std::uint64_t;

    struct Outcome {
        enum class Kind {
            acknowledged,
            completed,
            answered,    ///< with `values`
            refused,     ///< for `fault`
            unanswered,  ///< also when repeated
            incomplete,  ///< acknowledged, but no completion came in time
            forgotten,   ///< the link was lost, or the camera's power
        };
        Id id = 0;
        Message message;
        Kind kind = Kind::completed;
        Fault fault = Fault::syntax;
        std::vector<int> values = {};
        int socket = 0;
    };

    explicit Session(const Options& options) : options_(options) {}

    /// The link is there, or is gone.
    void open(std::int64_t now_ns);
    void close();

    State state() const { return state_; }
    bool ready() const { return state_ == State::ready; }
    const std::optional<Identity>& identity() const { return identity_; }
    void set_dialect(const Dialect& dialect) { options_.dialect = dialect; }

    /// What a head that has answered before is told along with what is to start the link up again
    /// (but for a new address), since perhaps only its answers are held up. Nothing is heard of it:
    /// it is to be sent again once the head answers. Harmless when repeated; empty: nothing.
    void set_wish(std::optional<Message> wish) { wish_ = std::move(wish); }

    /// Something can be sent now; a command needs a free socket as well.
    bool free(std::int64_t now_ns) const;
    bool socket_free() const;
    struct Sending {
        std::int64_t completion_ns = 10'000'000'000;  ///< how long a command may take
        /// Without a reply it is sent again; else that is left to who sent it, who may know better
        /// by then.
        bool again = true;
    };
    /// Only when free.
    Id send(const Message& message, std::int64_t now_ns, const Sending& sending);
    Id send(const Message& message, std::int64_t now_ns) {
        return send(message, now_ns, Sending());
    }
    /// The socket in which it is executed; empty where it is not (any more), or not known.
    std::optional<int> socket_of(Id id) const;

    /// Its socket counts as free from now on; no outcome comes.
    void abandon(Id id);

    void receive(std::span<const std::uint8_t> bytes, std::int64_t now_ns);
    void tick(std::int64_t now_ns);
    /// When `tick` has something to do next.
    std::optional<std::int64_t> deadline_ns() const;

    /// What is to be put on the link: packets, or datagrams.
    std::vector<Bytes> take_output();
    std::vector<Outcome> take_outcomes();
    std::vector<HeadNote> take_notes();

  private:
    struct Sent {
        Id id = 0;
        Message message;
        std::uint32_t sequence = 0;
        int tries = 1;
        std::int64_t deadline_ns = 0;
        Sending sending;
        std::int64_t out_ns = 0;  // its last byte
    };
    struct Executing {
        Id id = 0;
        Message message;
        int socket = 0;  // 0: not known
        std::uint32_t sequence = 0;
        std::int64_t deadline_ns = 0;
    };
    using Sequence = std::optional<std::uint32_t>;

    void enter(State state, std::int64_t now_ns);
    void start_over(std::int64_t now_ns);
    void send_start_message(std::int64_t now_ns);
    void send_wish();
    void start_step_timed_out(std::int64_t now_ns);
    void transmit(const Bytes& packet, bool again = false);
    void waiting_timed_out(std::int64_t now_ns);
    void learn_reply_time(const Sent& sent, std::int64_t now_ns);
    std::int64_t line_ns(std::size_t bytes) const;
    std::int64_t reply_deadline_ns(const Bytes& packet, std::int64_t now_ns, int misses) const;
    void receive_packet(std::span<const std::uint8_t> packet, Sequence sequence,
                        std::int64_t now_ns);
    void receive_control(const Datagram& datagram, std::int64_t now_ns);
    bool receive_in_start(const ReplyFrom& reply, std::int64_t now_ns);
    void on(const Acknowledged& reply, Sequence sequence, std::int64_t now_ns);
    void on(const Completed& reply, Sequence sequence, std::int64_t now_ns);
    void on(const Refused& reply, Sequence sequence, std::int64_t now_ns);
    void execute(const Sent& sent, int socket, std::int64_t now_ns);
    std::vector<Executing>::iterator executing_in(int socket, Sequence sequence);
    bool is_for_waiting(Sequence sequence) const;
    Sent take_waiting(std::int64_t now_ns);
    bool identify(const Identity& identity);
    void forget_all();
    void tell(const Sent& sent, Outcome::Kind kind);
    void tell(const Executing& executing, Outcome::Kind kind, Fault fault = Fault::syntax);
    void note(HeadNote::Kind kind, std::string text);

    Options options_;
    State state_ = State::closed;
    std::optional<Identity> identity_;
    int cameras_ = 0;
    int start_tries_ = 0;
    int unanswered_ = 0;  // in a row
    std::int64_t heard_ns_ = 0;
    std::optional<Message> wish_;
    bool knows_address_ = false;        // as it answered, and was not powered since
    std::optional<Identity> doubtful_;  // said once, and not what it was before
    double reply_mean_ns_ = -1.0;       // from a packet's last byte on; below 0: not known
    double reply_deviation_ns_ = 0.0;
    std::int64_t start_deadline_ns_ = 0;
    bool silence_noted_ = false;
    PacketReader reader_;
    std::uint64_t thrown_away_noted_ = 0;
    std::uint32_t sequence_ = 0;
    Id last_id_ = 0;
    std::optional<Sent> waiting_;
    std::vector<Executing> executing_;
    std::int64_t quiet_until_ns_ = 0;
    std::vector<Bytes> output_;
    std::vector<Outcome> outcomes_;
    std::vector<HeadNote> notes_;
};

}  // namespace kambara::visca
