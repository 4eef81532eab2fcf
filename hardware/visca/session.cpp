// SPDX-License-Identifier: GPL-3.0-or-later
#include "hardware/visca/session.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace kambara::visca {
namespace {

using Kind = HeadNote::Kind;

// Where an address set remains unanswered so often over TCP, the camera is taken to know none.
constexpr int tries_before_no_addresses = 3;
// A start-up that is stuck in a later step begins again.
constexpr int tries_before_over = 3;
// Of a head that is known, every so many tries: it may have lost its power, and its address.
constexpr int tries_before_address = 4;
// Beside what replies have taken so far.
constexpr std::int64_t margin_ns = 5'000'000;
constexpr double farthest_deviations = 3.0;
// So much longer is waited after every miss in a row.
constexpr double growing_patience = 1.25;

bool may_be_repeated(const Message& message) {
    switch (message.op) {
        case Op::relative:
        case Op::atmd_start_stop:
        case Op::md_frame:
            return false;
        case Op::shutter:
        case Op::iris:
        case Op::gain:
        case Op::bright:
        case Op::red_gain:
        case Op::blue_gain:
        case Op::compensation:
            return message.values[0] == 0;
        case Op::memory_reset:
        case Op::memory_set:
        case Op::memory_recall:
            return true;
        default:
            return message.values.empty() || message.values.back() != 0x10;
    }
}

}  // namespace

void Session::open(std::int64_t now_ns) {
    close();
    start_over(now_ns);
}

void Session::close() {
    forget_all();
    state_ = State::closed;
    output_.clear();
}

bool Session::free(std::int64_t now_ns) const {
    return ready() && !waiting_ && now_ns >= quiet_until_ns_;
}

bool Session::socket_free() const {
    const int sockets = identity_ && identity_->sockets > 0 ? identity_->sockets : 2;
    return static_cast<int>(executing_.size()) < sockets;
}

std::int64_t Session::line_ns(std::size_t bytes) const {
    return static_cast<std::int64_t>(bytes) * options_.byte_ns;
}

std::int64_t Session::reply_deadline_ns(const Bytes& packet, std::int64_t now_ns,
                                        int misses) const {
    std::int64_t patience_ns = options_.reply_timeout_ns + line_ns(longest_packet);
    // The mean and four deviations, as TCP waits; longer after misses, since it may be slow.
    if (reply_mean_ns_ >= 0.0) {
        const double learnt_ns = reply_mean_ns_ + 4.0 * reply_deviation_ns_ + margin_ns;
        patience_ns = std::min(
            patience_ns, static_cast<std::int64_t>(learnt_ns * std::pow(growing_patience, misses)));
    }
    return now_ns + line_ns(packet.size()) + patience_ns;
}

void Session::learn_reply_time(const Sent& sent, std::int64_t now_ns) {
    if (sent.tries > 1) {
        return;  // it is not known which one was replied to
    }
    const auto took_ns = static_cast<double>(now_ns - sent.out_ns);
    if (reply_mean_ns_ < 0.0) {
        reply_mean_ns_ = took_ns;
        reply_deviation_ns_ = 0.5 * took_ns;
        return;
    }
    // One that was held up on its way says little of the next ones.
    const double most_ns = farthest_deviations * reply_deviation_ns_ + margin_ns;
    const double off_ns = std::clamp(took_ns - reply_mean_ns_, -most_ns, most_ns);
    reply_deviation_ns_ += 0.25 * (std::abs(off_ns) - reply_deviation_ns_);
    reply_mean_ns_ += 0.125 * off_ns;
}

Session::Id Session::send(const Message& message, std::int64_t now_ns, const Sending& sending) {
    if (!free(now_ns)) {
        throw std::logic_error("kambara::visca::Session: it is not free");
    }
    const Bytes packet = encode(message, options_.address, options_.dialect);
    waiting_ = Sent{++last_id_,
                    message,
                    sequence_ + 1,
                    1,
                    reply_deadline_ns(packet, now_ns, unanswered_),
                    sending,
                    now_ns + line_ns(packet.size())};
    transmit(packet);
    return last_id_;
}

std::optional<int> Session::socket_of(Id id) const {
    const auto found = std::find_if(executing_.begin(), executing_.end(),
                                    [&](const Executing& one) { return one.id == id; });
    return found == executing_.end() || found->socket == 0 ? std::nullopt
                                                           : std::optional(found->socket);
}

void Session::abandon(Id id) {
    std::erase_if(executing_, [&](const Executing& one) { return one.id == id; });
}

void Session::transmit(const Bytes& packet, bool again) {
    if (options_.wiring != Wiring::udp_sony) {
        output_.push_back(packet);
        return;
    }
    // The same message keeps its number, so that the camera can tell that it knows it.
    sequence_ += again ? 0 : 1;
    output_.push_back(encode(Datagram{type_of_packet(packet), sequence_, packet}));
}

void Session::tick(std::int64_t now_ns) {
    if (state_ != State::closed && state_ != State::ready && now_ns >= start_deadline_ns_) {
        start_step_timed_out(now_ns);
    }
    if (waiting_ && now_ns >= waiting_->deadline_ns) {
        waiting_timed_out(now_ns);
    }
    for (auto one = executing_.begin(); one != executing_.end();) {
        if (now_ns < one->deadline_ns) {
            ++one;
            continue;
        }
        note(Kind::warning, "No completion of " + name_of(one->message.op) + " came.");
        tell(*one, Outcome::Kind::incomplete);
        one = executing_.erase(one);
    }
}

void Session::waiting_timed_out(std::int64_t now_ns) {
    // What cut the last packet short must not run into the next one.
    reader_.reset();
    const std::string name = name_of(waiting_->message.op);
    const bool harmless = may_be_repeated(waiting_->message);
    ++unanswered_;
    if (waiting_->sending.again && harmless && unanswered_ <= options_.repetitions) {
        note(Kind::warning, "No reply to " + name + ": it is sent again.");
        const Bytes packet = encode(waiting_->message, options_.address, options_.dialect);
        ++waiting_->tries;
        waiting_->deadline_ns = reply_deadline_ns(packet, now_ns, unanswered_);
        transmit(packet, true);
        return;
    }
    const Sent sent = *std::exchange(waiting_, std::nullopt);
    tell(sent, Outcome::Kind::unanswered);
    if (unanswered_ > options_.repetitions && now_ns >= heard_ns_ + options_.silence_ns) {
        note(Kind::fault, "The head does not answer any more; trying to reach it.");
        silence_noted_ = true;
        start_over(now_ns);
    } else {
        note(Kind::warning, "No reply to " + name + ".");
        quiet_until_ns_ = harmless ? now_ns : now_ns + options_.quiet_ns;
    }
}

std::optional<std::int64_t> Session::deadline_ns() const {
    if (state_ == State::closed) {
        return std::nullopt;
    }
    if (state_ != State::ready) {
        return start_deadline_ns_;
    }
    std::optional<std::int64_t> first;
    const auto take = [&](std::int64_t time_ns) {
        first = std::min(first.value_or(time_ns), time_ns);
    };
    if (waiting_) {
        take(waiting_->deadline_ns);
    }
    for (const Executing& one : executing_) {
        take(one.deadline_ns);
    }
    return first;
}

void Session::forget_all() {
    if (const auto sent = std::exchange(waiting_, std::nullopt)) {
        tell(*sent, Outcome::Kind::forgotten);
    }
    for (const Executing& one : std::exchange(executing_, {})) {
        tell(one, Outcome::Kind::forgotten);
    }
    reader_.reset();
}

// Start-up.

void Session::start_over(std::int64_t now_ns) {
    forget_all();
    unanswered_ = 0;
    switch (options_.wiring) {
        case Wiring::udp_sony:
            enter(State::resetting, now_ns);
            break;
        case Wiring::udp:
            enter(State::clearing, now_ns);
            break;
        default:
            cameras_ = 0;
            enter(State::addressing, now_ns);
    }
}

void Session::enter(State state, std::int64_t now_ns) {
    state_ = state;
    start_tries_ = 0;
    if (state == State::ready) {
        note(Kind::note, silence_noted_ ? "The head answers again." : "The head answers.");
        silence_noted_ = false;
        quiet_until_ns_ = now_ns;
        heard_ns_ = now_ns;
        knows_address_ = true;
    } else {
        send_start_message(now_ns);
    }
}

void Session::send_start_message(std::int64_t now_ns) {
    ++start_tries_;
    // Of one that is known now and then long, in case that it has become slow; seldom so, since the
    // plug may be back at any time.
    const int misses =
        !knows_address_ || start_tries_ % tries_before_address == 0 ? start_tries_ : 0;
    // Over IP nothing is broadcast; nor where the camera knows no addresses.
    const bool broadcasts = cameras_ > 0;
    const Bytes version = encode({Op::ask_version}, options_.address);
    Bytes packet = version;
    if (state_ == State::resetting) {
        sequence_ = 0;
        output_.push_back(encode(sequence_reset()));
        start_deadline_ns_ = reply_deadline_ns(output_.back(), now_ns, misses);
        send_wish();
        return;
    }
    // One that was known before most likely still knows its address: it is just asked.
    if (state_ == State::addressing &&
        !(knows_address_ && start_tries_ % tries_before_address != 0)) {
        packet = encode({Op::address_set, {1}}, broadcast_address);
    } else if (state_ == State::clearing) {
        packet = encode({Op::if_clear}, broadcasts ? broadcast_address : options_.address);
    }
    transmit(packet);
    start_deadline_ns_ = reply_deadline_ns(packet, now_ns, misses);
    if (state_ == State::clearing || (state_ == State::addressing && packet == version)) {
        send_wish();
    }
}

void Session::send_wish() {
    if (wish_ && knows_address_) {
        const Bytes wished = encode(*wish_, options_.address, options_.dialect);
        transmit(wished);
        start_deadline_ns_ += line_ns(wished.size());
    }
}

void Session::start_step_timed_out(std::int64_t now_ns) {
    if (!silence_noted_ && start_tries_ >= tries_before_over) {
        note(Kind::fault, "The head does not answer. Check its power, the line and the address.");
        silence_noted_ = true;
    }
    reader_.reset();
    if (state_ == State::addressing && options_.wiring == Wiring::tcp &&
        start_tries_ >= tries_before_no_addresses) {
        cameras_ = 0;
        enter(State::clearing, now_ns);
    } else if ((state_ == State::clearing || state_ == State::identifying) &&
               start_tries_ >= tries_before_over) {
        start_over(now_ns);
    } else {
        send_start_message(now_ns);
    }
}

bool Session::receive_in_start(const ReplyFrom& from, std::int64_t now_ns) {
    if (const auto* set = std::get_if<AddressesSet>(&from.reply);
        set != nullptr && state_ == State::addressing) {
        cameras_ = set->next - 1;
        if (cameras_ < options_.address) {
            note(Kind::fault, "There is no camera " + std::to_string(options_.address) + ": " +
                                  std::to_string(cameras_) +
                                  " answered. Choose another address, or check the chain.");
        }
        // Of one that was known before nothing is to be cleared: what it executes is replaced, and
        // when it lost its power, it executes nothing.
        enter(knows_address_ ? State::identifying : State::clearing, now_ns);
        return true;
    }
    const auto* done = std::get_if<Completed>(&from.reply);
    if (state_ == State::clearing &&
        (std::holds_alternative<InterfaceCleared>(from.reply) ||
         (done != nullptr && done->data.empty() && from.address == options_.address))) {
        enter(State::identifying, now_ns);
        return true;
    }
    const bool asked =
        state_ == State::identifying || (state_ == State::addressing && knows_address_);
    if (asked && done != nullptr && from.address == options_.address) {
        if (const auto values = decode_answer(Op::ask_version, done->data)) {
            if (identify({values->at(0), values->at(1), values->at(2), values->at(3)})) {
                enter(State::ready, now_ns);
            } else {
                send_start_message(now_ns);
            }
            return true;
        }
    }
    // The question was damaged on its way.
    if (asked && std::holds_alternative<Refused>(from.reply) && from.address == options_.address &&
        start_tries_ < tries_before_over) {
        send_start_message(now_ns);
        return true;
    }
    return false;
}

// The end of an answer that came late looks like a version. What is new must be said twice.
bool Session::identify(const Identity& identity) {
    if (identity != identity_ && identity != doubtful_) {
        doubtful_ = identity;
        return false;
    }
    doubtful_.reset();
    identity_ = identity;
    return true;
}

// What comes out.

std::vector<Bytes> Session::take_output() {
    return std::exchange(output_, {});
}

std::vector<Session::Outcome> Session::take_outcomes() {
    return std::exchange(outcomes_, {});
}

std::vector<HeadNote> Session::take_notes() {
    return std::exchange(notes_, {});
}

void Session::note(HeadNote::Kind kind, std::string text) {
    notes_.push_back({kind, std::move(text)});
}

void Session::tell(const Sent& sent, Outcome::Kind kind) {
    outcomes_.push_back({sent.id, sent.message, kind});
}

void Session::tell(const Executing& executing, Outcome::Kind kind, Fault fault) {
    outcomes_.push_back({executing.id, executing.message, kind, fault, {}, executing.socket});
}

}  // namespace kambara::visca
