// SPDX-License-Identifier: GPL-3.0-or-later
#include "hardware/visca/head_driver.h"

#include <algorithm>
#include <cstdio>
#include <utility>

namespace kambara::visca {
namespace {

constexpr std::int64_t ms = 1'000'000;
constexpr std::int64_t longest_wait_ns = 100 * ms;
constexpr std::int64_t soon_ns = 5 * ms;
// Between two questions for the position: what a slow line allows beside commands.
constexpr std::int64_t shortest_interval_ns = 33 * ms;
constexpr std::int64_t interval_at_rest_ns = 100 * ms;
constexpr int bytes_of_inquiry_and_answer = 16;
constexpr int bytes_of_answer = 11;
constexpr int bytes_of_look = 15;
constexpr std::size_t most_notes = 1000;
// A completion of what was taken over from that has not come by then was lost.
constexpr std::int64_t superseded_patience_ns = 100 * ms;

}  // namespace

HeadDriver::HeadDriver(Link& link, HeadQueue& queue, const Clock& clock, Options options)
    : link_(link),
      queue_(queue),
      clock_(clock),
      options_(std::move(options)),
      session_(options_.session),
      fault_("The head (" + link.name() +
             ") has not answered yet. Check its power, the line and the address.") {}

void HeadDriver::step() {
    std::int64_t now_ns = clock_.now_ns();
    if (!open_) {
        take_wishes(now_ns);
        tell_wish(now_ns);
        if (now_ns >= next_open_ns_) {
            open_link(now_ns);
        }
    }
    if (open_) {
        tell_wish(now_ns);
        session_.tick(now_ns);
        follow_session(now_ns);
        take_wishes(now_ns);
        send_next(now_ns);
        for (const Bytes& packet : session_.take_output()) {
            if (const auto sent = link_.send(packet); !sent) {
                lose_link(sent.error(), now_ns);
                break;
            }
        }
    }
    auto received = link_.receive(wait_until_ns(now_ns));
    now_ns = clock_.now_ns();
    if (!received) {
        lose_link(received.error(), now_ns);
        return;
    }
    for (const Bytes& bytes : *received) {
        session_.receive(bytes, now_ns);
    }
    follow_session(now_ns);
}

// What a head that is being reached again is to do: to stop, where a halt could not be told, or
// where it is driven and nobody is told where to; else, where to look.
void HeadDriver::tell_wish(std::int64_t now_ns) {
    if (!ready_ && model_ &&
        (halt_ != Halt::none || (current_ && current_->motion.kind == Motion::Kind::drive))) {
        session_.set_wish(stop_message());
        return;
    }
    bool look = !ready_ && model_ && current_ && current_->motion.kind == Motion::Kind::look;
    if (look && current_->motion.aim) {
        look = now_ns - current_->motion.aim->computed_ns <= options_.stale_aim_ns;
    }
    session_.set_wish(look ? std::optional(message_of(current_->motion)) : std::nullopt);
}

void HeadDriver::open_link(std::int64_t now_ns) {
    if (const auto opened = link_.open(); !opened) {
        next_open_ns_ = now_ns + options_.reopen_ns;
        if (!std::exchange(open_fault_noted_, true)) {
            note(HeadNote::Kind::fault, opened.error().text());
        }
        publish_fault(opened.error().text());
        return;
    }
    open_ = true;
    if (std::exchange(open_fault_noted_, false)) {
        note(HeadNote::Kind::note, "The line to the head (" + link_.name() + ") is there again.");
    }
    session_.open(now_ns);
}

void HeadDriver::lose_link(const Error& error, std::int64_t now_ns) {
    if (!open_) {
        return;
    }
    open_ = false;
    open_fault_noted_ = true;
    next_open_ns_ = now_ns + options_.reopen_ns;
    note(HeadNote::Kind::fault, error.text());
    link_.close();
    session_.close();
    follow_session(now_ns);
    publish_fault(error.text());
}

void HeadDriver::follow_session(std::int64_t now_ns) {
    for (const Session::Outcome& outcome : session_.take_outcomes()) {
        handle(outcome, now_ns);
    }
    for (HeadNote& one : session_.take_notes()) {
        note(one.kind, std::move(one.text));
    }
    if (session_.ready() != ready_) {
        ready_ = session_.ready();
        if (ready_) {
            became_ready(now_ns);
        } else {
            lost(now_ns);
        }
    }
    abandon_superseded(now_ns);
}

void HeadDriver::became_ready(std::int64_t now_ns) {
    const Identity identity = *session_.identity();
    auto model = options_.model ? options_.model : find_head(options_.heads, identity.model);
    if (!model) {
        char code[8];
        std::snprintf(code, sizeof code, "%04X", static_cast<unsigned>(identity.model));
        const std::string text = "The head (" + link_.name() +
                                 ") is of a kind that is not known (" + code +
                                 "). Name one of the table of heads with model=.";
        note(HeadNote::Kind::fault, text);
        publish_fault(text);
        return;
    }
    session_.set_dialect(model->dialect());
    replaces_moves_ = model->replaces_moves;
    power_is_known_ = false;
    power_asked_ns_ = 0;
    // Due, but what is wanted of it comes first: so much time has been lost already.
    position_asked_ns_ = now_ns - position_interval_ns();
    {
        std::lock_guard lock(mutex_);
        model_ = model;
        estimate_.set_speeds(rad_from_deg(model->pan.fastest_deg_s),
                             rad_from_deg(model->tilt.fastest_deg_s));
        connected_ = true;
        fault_.clear();
    }
    // What still matters is told again: the head may have lost its power.
    if (halt_ == Halt::sent) {
        halt_ = Halt::wanted;
    }
    if (current_ && current_->motion.kind == Motion::Kind::look) {
        current_->stage = Stage::waiting;
        current_->corrections = 0;
    } else if (current_ && current_->motion.kind == Motion::Kind::drive) {
        // It may have been turning all the time; whoever drove it did not see where to.
        current_.reset();
        halt_ = Halt::wanted;
    }
    if (current_) {
        current_->not_before_ns = now_ns;
    }
}

void HeadDriver::lost(std::int64_t) {
    moves_.clear();
    cancels_.clear();
    cancel_id_ = 0;
    std::lock_guard lock(mutex_);
    connected_ = false;
    if (fault_.empty()) {
        fault_ = "The head (" + link_.name() + ") does not answer. Check its power and the line.";
    }
    estimate_.forget();
    lens_.reset();
}

void HeadDriver::abandon_superseded(std::int64_t now_ns) {
    std::erase_if(moves_, [&](const auto& one) {
        const bool over = one.second.superseded_ns &&
                          now_ns >= *one.second.superseded_ns + superseded_patience_ns;
        if (over) {
            session_.abandon(one.first);
        }
        return over;
    });
}

std::int64_t HeadDriver::position_interval_ns() const {
    // A quarter of the line's time.
    const std::int64_t moving_ns =
        std::max(shortest_interval_ns, 4 * bytes_of_inquiry_and_answer * options_.session.byte_ns);
    const bool at_rest = moves_.empty() && estimate_.known() && estimate_.at_rest() &&
                         !(current_ && current_->stage != Stage::done);
    return at_rest ? std::max(moving_ns, interval_at_rest_ns) : moving_ns;
}

std::int64_t HeadDriver::wait_until_ns(std::int64_t now_ns) const {
    if (!open_) {
        return std::clamp(next_open_ns_, now_ns, now_ns + longest_wait_ns);
    }
    std::int64_t until_ns = session_.deadline_ns().value_or(now_ns + longest_wait_ns);
    if (!model_) {
        return std::clamp(until_ns, now_ns, now_ns + longest_wait_ns);
    }
    if (session_.free(now_ns)) {
        // What is wanted but may not be sent yet is looked at again soon.
        const bool held = (current_ && current_->stage == Stage::waiting) || setting_ ||
                          halt_ != Halt::none || !cancels_.empty();
        until_ns = std::min(until_ns,
                            held ? now_ns + soon_ns : position_asked_ns_ + position_interval_ns());
    } else if (ready_ && !session_.deadline_ns()) {
        until_ns = now_ns + soon_ns;
    }
    return std::clamp(until_ns, now_ns, now_ns + longest_wait_ns);
}

// What the outside sees.

void HeadDriver::read_position(const std::vector<int>& steps, std::int64_t now_ns) {
    // It was so when the camera began to say it.
    const std::int64_t time_ns = now_ns - bytes_of_answer * options_.session.byte_ns;
    const HeadAngles angles{rad_from_deg(model_->pan.deg_from_steps(steps[0])),
                            rad_from_deg(model_->tilt.deg_from_steps(steps[1]))};
    bool believed = false;
    {
        std::lock_guard lock(mutex_);
        believed = estimate_.add_reading(angles, time_ns);
        readings_ += believed ? 1 : 0;
    }
    if (believed) {
        verify(angles);
    } else {
        note(HeadNote::Kind::warning, "The head said to be where it can't be; asked again.");
    }
}

bool HeadDriver::connected() const {
    std::lock_guard lock(mutex_);
    return connected_;
}

std::string HeadDriver::fault() const {
    std::lock_guard lock(mutex_);
    return fault_;
}

std::optional<HeadKind> HeadDriver::model() const {
    std::lock_guard lock(mutex_);
    return model_;
}

Result<HeadStatus> HeadDriver::status() const {
    std::lock_guard lock(mutex_);
    if (!connected_ || !estimate_.known()) {
        return Error{fault_.empty() ? "The head (" + link_.name() + ") has not told where it looks."
                                    : fault_,
                     ""};
    }
    return estimate_.at(clock_.now_ns());
}

Result<LensStatus> HeadDriver::lens() const {
    std::lock_guard lock(mutex_);
    if (!lens_) {
        return Error{
            fault_.empty() ? "The head (" + link_.name() + ") has not told of its lens." : fault_,
            ""};
    }
    return *lens_;
}

std::vector<HeadNote> HeadDriver::take_notes() {
    std::lock_guard lock(mutex_);
    std::vector<HeadNote> taken(notes_.begin(), notes_.end());
    notes_.clear();
    return taken;
}

std::uint64_t HeadDriver::position_readings() const {
    std::lock_guard lock(mutex_);
    return readings_;
}

// Until the motors are told.
double HeadDriver::way_there_s() const {
    constexpr double half_field_s = 1.0 / 120.0;
    return 1e-9 * static_cast<double>(bytes_of_look * options_.session.byte_ns) + half_field_s;
}

double HeadDriver::lag_s() const {
    return way_there_s() + options_.motor_lag_s;
}

double HeadDriver::oldest_aim_s() const {
    std::lock_guard lock(mutex_);
    return static_cast<double>(oldest_aim_ns_) * 1e-9;
}

void HeadDriver::note(HeadNote::Kind kind, std::string text) {
    std::lock_guard lock(mutex_);
    notes_.push_back({kind, std::move(text)});
    if (notes_.size() > most_notes) {
        notes_.pop_front();
    }
}

void HeadDriver::publish_fault(std::string fault) {
    std::lock_guard lock(mutex_);
    fault_ = std::move(fault);
}

}  // namespace kambara::visca
