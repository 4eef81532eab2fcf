// SPDX-License-Identifier: GPL-3.0-or-later
// How replies find the messages they belong to.
#include <algorithm>
#include <utility>

#include "hardware/visca/session.h"

namespace kambara::visca {
namespace {

using Kind = HeadNote::Kind;

}  // namespace

void Session::receive(std::span<const std::uint8_t> bytes, std::int64_t now_ns) {
    if (state_ == State::closed) {
        return;
    }
    // Over UDP cameras answer with the header or without, whatever they were asked with.
    const bool datagrams = options_.wiring == Wiring::udp || options_.wiring == Wiring::udp_sony;
    const auto datagram = datagrams ? decode_datagram(bytes) : std::nullopt;
    if (datagram && datagram->type == PayloadType::control_reply) {
        receive_control(*datagram, now_ns);
        return;
    }
    Sequence sequence;
    if (datagram) {
        if (options_.wiring == Wiring::udp_sony && options_.checks_sequence) {
            sequence = datagram->sequence;
        }
        bytes = datagram->payload;
    }
    if (datagrams) {
        reader_.reset();  // a packet never goes on in the next datagram
    }
    for (const Bytes& packet : reader_.read(bytes)) {
        receive_packet(packet, sequence, now_ns);
    }
    if (reader_.bytes_thrown_away() > thrown_away_noted_) {
        note(Kind::warning, std::to_string(reader_.bytes_thrown_away() - thrown_away_noted_) +
                                " bytes from the head made no sense and were passed over.");
        thrown_away_noted_ = reader_.bytes_thrown_away();
    }
}

void Session::receive_control(const Datagram& datagram, std::int64_t now_ns) {
    const auto fault = control_fault(datagram);
    if (!fault) {
        if (state_ == State::resetting) {
            enter(State::clearing, now_ns);
        }
        return;
    }
    if (!waiting_) {
        if (state_ != State::ready) {
            note(Kind::warning, "The head complains of the sequence number; it is reset.");
            start_over(now_ns);
        }
        return;
    }
    if (*fault == ControlFault::sequence_abnormal && waiting_->tries > 1 &&
        !is_inquiry(waiting_->message.op)) {
        // It had been done: only the acknowledgement was lost.
        execute(take_waiting(now_ns), 0, now_ns);
        return;
    }
    if (*fault == ControlFault::sequence_abnormal && waiting_->tries == 1) {
        note(Kind::warning, "The head complains of the sequence number; it is reset.");
        start_over(now_ns);
        return;
    }
    // What was lost is the reply, or the message was damaged: it goes under a new number.
    ++waiting_->tries;
    waiting_->sequence = sequence_ + 1;
    const Bytes packet = encode(waiting_->message, options_.address, options_.dialect);
    waiting_->deadline_ns = reply_deadline_ns(packet, now_ns, unanswered_);
    transmit(packet);
}

void Session::receive_packet(std::span<const std::uint8_t> packet, Sequence sequence,
                             std::int64_t now_ns) {
    const auto from = decode_reply(packet);
    if (!from) {
        note(Kind::warning, "Not a reply: " + hex_from_bytes(packet) + ".");
        return;
    }
    if (std::holds_alternative<NetworkChanged>(from->reply)) {
        // Over IP there is none; where it comes all the same, the camera has just been powered.
        note(Kind::warning, "The head was switched on, or the chain has changed: starting anew.");
        knows_address_ = false;
        start_over(now_ns);
        return;
    }
    if (state_ != State::ready) {
        if (!receive_in_start(*from, now_ns)) {
            note(Kind::note, "Passed over at the start: " + hex_from_bytes(packet) + ".");
        }
        return;
    }
    if (from->address != options_.address) {
        note(Kind::note, "Passed over, not of this head: " + hex_from_bytes(packet) + ".");
        return;
    }
    std::visit(
        [&](const auto& reply) {
            if constexpr (requires { on(reply, sequence, now_ns); }) {
                on(reply, sequence, now_ns);
            }
        },
        from->reply);
}

bool Session::is_for_waiting(Sequence sequence) const {
    return waiting_ && (!sequence || *sequence == waiting_->sequence);
}

Session::Sent Session::take_waiting(std::int64_t now_ns) {
    Sent sent = *std::exchange(waiting_, std::nullopt);
    unanswered_ = 0;
    heard_ns_ = now_ns;
    learn_reply_time(sent, now_ns);
    if (sent.tries > 1 && options_.wiring != Wiring::udp_sony) {
        quiet_until_ns_ = now_ns + options_.quiet_ns;
    }
    return sent;
}

std::vector<Session::Executing>::iterator Session::executing_in(int socket, Sequence sequence) {
    const auto by_sequence = [&](const Executing& one) { return one.sequence == *sequence; };
    const auto by_socket = [&](const Executing& one) { return one.socket == socket; };
    if (sequence) {
        return std::find_if(executing_.begin(), executing_.end(), by_sequence);
    }
    const auto found = std::find_if(executing_.begin(), executing_.end(), by_socket);
    if (found != executing_.end()) {
        return found;
    }
    // A camera without sockets, or one whose acknowledgement was lost: the oldest.
    return socket == 0 ? executing_.begin()
                       : std::find_if(executing_.begin(), executing_.end(),
                                      [](const Executing& one) { return one.socket == 0; });
}

void Session::execute(const Sent& sent, int socket, std::int64_t now_ns) {
    // Its socket is its own: the completion of what was in it has been lost.
    if (socket != 0) {
        std::erase_if(executing_, [&](const Executing& one) {
            if (one.socket != socket) {
                return false;
            }
            tell(one, Outcome::Kind::completed);
            return true;
        });
    }
    executing_.push_back(
        {sent.id, sent.message, socket, sent.sequence, now_ns + sent.sending.completion_ns});
    outcomes_.push_back(
        {sent.id, sent.message, Outcome::Kind::acknowledged, Fault::syntax, {}, socket});
}

void Session::on(const Acknowledged& reply, Sequence sequence, std::int64_t now_ns) {
    if (is_for_waiting(sequence) && !is_inquiry(waiting_->message.op) &&
        waiting_->message.op != Op::cancel) {
        execute(take_waiting(now_ns), reply.socket, now_ns);
        return;
    }
    // A socket is in use that is not known of. Should there be none free, the camera will say so.
    note(Kind::note, "A late acknowledgement came.");
}

void Session::on(const Completed& reply, Sequence sequence, std::int64_t now_ns) {
    if (!reply.data.empty()) {
        if (is_for_waiting(sequence) && is_inquiry(waiting_->message.op)) {
            if (auto values = decode_answer(waiting_->message.op, reply.data, options_.dialect)) {
                const Sent sent = take_waiting(now_ns);
                outcomes_.push_back({sent.id, sent.message, Outcome::Kind::answered, Fault::syntax,
                                     std::move(*values)});
                return;
            }
        }
        // Cameras without sockets complete commands with data.
        if (executing_.empty() || is_for_waiting(sequence)) {
            note(Kind::note, "An answer came that nothing was asked for.");
            return;
        }
    }
    const auto one = executing_in(reply.socket, sequence);
    if (one != executing_.end()) {
        tell(*one, Outcome::Kind::completed);
        executing_.erase(one);
        return;
    }
    if (is_for_waiting(sequence) && !is_inquiry(waiting_->message.op) &&
        waiting_->message.op != Op::cancel && reply.data.empty()) {
        // Its acknowledgement was lost, or the camera gives none.
        tell(take_waiting(now_ns), Outcome::Kind::completed);
        return;
    }
    note(Kind::note, "A completion came of a command that is not known any more.");
}

void Session::on(const Refused& reply, Sequence sequence, std::int64_t now_ns) {
    const auto refuse = [&](const Sent& sent) {
        outcomes_.push_back(
            {sent.id, sent.message, Outcome::Kind::refused, reply.fault, {}, reply.socket});
    };
    const bool of_a_cancel = reply.fault == Fault::cancelled || reply.fault == Fault::no_socket;
    if (of_a_cancel) {
        const bool cancel_waits = waiting_ && waiting_->message.op == Op::cancel;
        const auto one = executing_in(reply.socket, std::nullopt);
        if (one != executing_.end()) {
            tell(*one, Outcome::Kind::refused, reply.fault);
            executing_.erase(one);
        }
        if (cancel_waits) {
            tell(take_waiting(now_ns), Outcome::Kind::completed);
        }
        return;
    }
    if (is_for_waiting(sequence)) {
        const Sent sent = take_waiting(now_ns);
        note(Kind::warning,
             "The head refuses " + name_of(sent.message.op) + ": " + name_of(reply.fault) + ".");
        refuse(sent);
        return;
    }
    const auto one = executing_in(reply.socket, sequence);
    if (one != executing_.end()) {
        note(Kind::warning,
             "The head gives up " + name_of(one->message.op) + ": " + name_of(reply.fault) + ".");
        tell(*one, Outcome::Kind::refused, reply.fault);
        executing_.erase(one);
        return;
    }
    note(Kind::note, "A late error came: " + name_of(reply.fault) + ".");
}

}  // namespace kambara::visca
