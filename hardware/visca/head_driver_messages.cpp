// SPDX-License-Identifier: GPL-3.0-or-later
// What the driver tells the head, when, and what it makes of the outcome.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "hardware/visca/head_driver.h"

namespace kambara::visca {
namespace {

using Outcome = Session::Outcome;

constexpr std::int64_t ms = 1'000'000;
constexpr std::int64_t second = 1'000 * ms;
// After "not executable": as long as some models say so after a preset.
constexpr std::int64_t retry_ns = 240 * ms;
constexpr std::int64_t retry_full_ns = 50 * ms;
constexpr int most_refusals = 4;
constexpr int most_corrections = 3;
constexpr int most_syntax_errors = 10;  // in a row
constexpr double correction_steps = 1.5;
// Between two questions whether it is on, so that they keep nothing else waiting.
constexpr std::int64_t power_interval_ns = 150 * ms;
constexpr std::int64_t lens_interval_ns = 400 * ms;
// The longest way of any model at full speed, and time to spare; home, reset and presets have their
// own speeds, and power takes its time.
constexpr std::int64_t look_patience_ns = 6 * second;
constexpr std::int64_t other_patience_ns = 20 * second;

constexpr int stop_code = 3;
constexpr int power_on = 2;
constexpr int autofocus_on = 2;

}  // namespace

void HeadDriver::take_wishes(std::int64_t now_ns) {
    if (queue_.take_halt()) {
        halt_ = Halt::wanted;
        halt_not_before_ns_ = 0;
        current_.reset();
        clear_moves();
    }
    // What was sent is let be acknowledged; an operator's wish is not replaced by steering.
    if (current_ && current_->stage == Stage::sent) {
        return;
    }
    const bool hand_waits =
        current_ && current_->motion.by_hand && current_->stage == Stage::waiting;
    auto motion = queue_.take_motion(hand_waits);
    if (!motion) {
        return;
    }
    take_aim(*motion, now_ns);
    const bool same = current_ && ready_ && model_ && current_->motion.kind == Motion::Kind::look &&
                      motion->kind == Motion::Kind::look && current_->corrections == 0 &&
                      message_of(*motion) == message_of(current_->motion);
    if (same) {
        current_->motion = *motion;
        return;
    }
    current_ = Current{*motion};
    current_->not_before_ns = now_ns;
    if (!moves_.empty() && (motion->kind == Motion::Kind::drive || !replaces_moves_)) {
        clear_moves();
    }
}

// Every move under way is to be cancelled. Where it is not known which sockets they have: all.
void HeadDriver::clear_moves() {
    cancels_.clear();
    for (const auto& [id, move] : moves_) {
        if (const auto socket = session_.socket_of(id)) {
            cancels_.push_back(*socket);
        }
    }
}

void HeadDriver::send_next(std::int64_t now_ns) {
    if (!ready_ || !model_ || !session_.free(now_ns)) {
        return;
    }
    if (!cancels_.empty()) {
        if (send_cancel(now_ns)) {
            return;
        }
    } else if (halt_ == Halt::wanted && now_ns >= halt_not_before_ns_) {
        if (session_.socket_free()) {
            halt_id_ = session_.send(stop_message(), now_ns);
            halt_ = Halt::sent;
            return;
        }
    }
    const std::int64_t due_ns = position_asked_ns_ + position_interval_ns();
    const bool overdue = now_ns >= due_ns + position_interval_ns();
    const bool hand = current_ && current_->motion.by_hand;
    // Where it looks is of little use while it is not known to have been told where to.
    if ((hand || !overdue || motion_unanswered_) && halt_ == Halt::none && cancels_.empty() &&
        send_motion(now_ns)) {
        return;
    }
    if (!power_is_known_ && now_ns >= power_asked_ns_ + power_interval_ns) {
        power_asked_ns_ = now_ns;
        ask(Op::ask_power, now_ns);
        return;
    }
    if (!overdue && send_setting(now_ns)) {
        return;
    }
    if (now_ns >= due_ns) {
        position_asked_ns_ = now_ns;
        ask(Op::ask_position, now_ns);
    } else if (now_ns >= lens_asked_ns_ + lens_interval_ns &&
               !(current_ && current_->stage == Stage::waiting)) {
        lens_asked_ns_ = now_ns;
        constexpr Op turns[] = {Op::ask_zoom, Op::ask_focus_mode, Op::ask_focus};
        ask(turns[lens_turn_++ % 3], now_ns);
    }
}

void HeadDriver::ask(Op inquiry, std::int64_t now_ns) {
    // The next question is as good as the same one again.
    session_.send({inquiry}, now_ns, {0, false});
}

bool HeadDriver::send_cancel(std::int64_t now_ns) {
    const auto wait_ns = static_cast<std::int64_t>(model_->cancel_wait_s * 1e9);
    for (const auto& [id, move] : moves_) {
        if (now_ns < move.started_ns + wait_ns) {
            return false;
        }
    }
    cancel_id_ = session_.send({Op::cancel, {cancels_.front()}}, now_ns);
    cancels_.pop_front();
    return true;
}

// Where a target that is followed will be when the head gets there.
void HeadDriver::take_aim(Motion& motion, std::int64_t now_ns) const {
    if (!motion.aim || !model_) {
        return;
    }
    const HeadLimits limits = model_->limits();
    const HeadAngles then =
        motion.aim->at(now_ns + static_cast<std::int64_t>(std::llround(lag_s() * 1e9)));
    motion.angles = {std::clamp(then.pan_rad, -limits.pan_rad, limits.pan_rad),
                     std::clamp(then.tilt_rad, -limits.tilt_rad, limits.tilt_rad)};
    motion.speed_rad_s = pace_towards(motion, now_ns);
}

// The target's own rate, and so much more or less that what the head will be off when it is told
// is made up for a little later: made up at once, noise would jerk it. Where no rate is
// known, at once. Towards the aim always.
std::optional<HeadAngles> HeadDriver::pace_towards(const Motion& motion,
                                                   std::int64_t now_ns) const {
    std::lock_guard lock(mutex_);
    if (!options_.paces || !(options_.motor_lag_s > 0.0) || !estimate_.known()) {
        return std::nullopt;
    }
    const HeadAngles from = estimate_.at(now_ns + std::llround(way_there_s() * 1e9)).angles;
    const HeadAngles& rate = motion.aim->rate_rad_s;
    const double make_up_s = rate == HeadAngles{} ? options_.motor_lag_s : options_.make_up_s;
    const auto pace = [&](double to, double start, double rate_rad_s) {
        const double way = to - start;
        const double off = way - rate_rad_s * options_.motor_lag_s;
        return std::max(0.0, std::copysign(1.0, way) * (rate_rad_s + off / make_up_s));
    };
    return HeadAngles{pace(motion.angles.pan_rad, from.pan_rad, rate.pan_rad),
                      pace(motion.angles.tilt_rad, from.tilt_rad, rate.tilt_rad)};
}

bool HeadDriver::send_motion(std::int64_t now_ns) {
    if (!current_ || current_->stage != Stage::waiting || now_ns < current_->not_before_ns ||
        !session_.socket_free()) {
        return false;
    }
    if (current_->motion.aim) {
        const std::int64_t age_ns = now_ns - current_->motion.aim->computed_ns;
        if (age_ns > options_.stale_aim_ns) {
            current_.reset();
            return false;
        }
        take_aim(current_->motion, now_ns);
        current_->motion.aim.reset();  // if it must be told again, then as it is
        std::lock_guard lock(mutex_);
        oldest_aim_ns_ = std::max(oldest_aim_ns_, age_ns);
    }
    // A newer aim or speed is better than the same one again, and a halt may have come meanwhile.
    const Motion::Kind kind = current_->motion.kind;
    current_->id = session_.send(message_of(current_->motion), now_ns,
                                 {kind == Motion::Kind::look ? look_patience_ns : other_patience_ns,
                                  kind == Motion::Kind::other});
    current_->stage = Stage::sent;
    return true;
}

bool HeadDriver::send_setting(std::int64_t now_ns) {
    if (!setting_) {
        if (auto message = queue_.take_setting()) {
            setting_ = Setting{std::move(*message)};
        }
    }
    if (!setting_ || setting_->id != 0 || now_ns < setting_->not_before_ns ||
        !session_.socket_free()) {
        return false;
    }
    setting_->id = session_.send(setting_->message, now_ns);
    return true;
}

Message HeadDriver::message_of(const Motion& motion) const {
    const AxisModel& pan = model_->pan;
    const AxisModel& tilt = model_->tilt;
    const double pan_deg = deg_from_rad(motion.angles.pan_rad);
    const double tilt_deg = deg_from_rad(motion.angles.tilt_rad);
    switch (motion.kind) {
        case Motion::Kind::look: {
            const auto& speed = motion.speed_rad_s;
            return {Op::absolute,
                    {speed ? pan.nearest_code(deg_from_rad(speed->pan_rad)) : pan.fastest_code,
                     speed ? tilt.nearest_code(deg_from_rad(speed->tilt_rad)) : tilt.fastest_code,
                     pan.steps_from_deg(pan_deg), tilt.steps_from_deg(tilt_deg)}};
        }
        case Motion::Kind::drive: {
            const auto way = [](double speed, int back, int forth) {
                return speed < 0.0 ? back : (speed > 0.0 ? forth : stop_code);
            };
            return {Op::drive,
                    {pan.code_for(pan_deg), tilt.code_for(tilt_deg), way(pan_deg, 1, 2),
                     way(tilt_deg, 2, 1)}};
        }
        default:
            return motion.message;
    }
}

Message HeadDriver::stop_message() const {
    return {Op::drive, {model_->pan.fastest_code, model_->tilt.fastest_code, stop_code, stop_code}};
}

void HeadDriver::handle(const Outcome& outcome, std::int64_t now_ns) {
    if (outcome.kind == Outcome::Kind::answered) {
        handle_answer(outcome, now_ns);
    } else if (is_inquiry(outcome.message.op)) {
        if (outcome.kind == Outcome::Kind::refused) {
            power_is_known_ = power_is_known_ || outcome.message.op == Op::ask_power;
        }
    } else if (outcome.message.op == Op::cancel) {
        if (outcome.id == cancel_id_ && current_) {
            current_->not_before_ns =
                now_ns + static_cast<std::int64_t>(model_->cancel_wait_s * 1e9);
        }
    } else if (outcome.id == halt_id_) {
        handle_halt(outcome, now_ns);
    } else if (setting_ && outcome.id == setting_->id) {
        handle_setting(outcome, now_ns);
    } else {
        handle_motion(outcome, now_ns);
    }
}

void HeadDriver::handle_halt(const Outcome& outcome, std::int64_t now_ns) {
    switch (outcome.kind) {
        case Outcome::Kind::acknowledged:
        case Outcome::Kind::completed:
            // A completion after the acknowledgement may come when something else turns it.
            if (halt_ == Halt::sent) {
                halt_ = Halt::none;
                std::lock_guard lock(mutex_);
                estimate_.set_target(std::nullopt, now_ns);
            }
            break;
        case Outcome::Kind::refused:
            if (halt_ == Halt::sent) {
                halt_ = Halt::wanted;
                halt_not_before_ns_ = now_ns + retry_full_ns;
                clear_moves();
                if (cancels_.empty()) {
                    cancels_ = {1, 2};
                }
            }
            break;
        default:
            halt_ = halt_ == Halt::sent ? Halt::wanted : halt_;
    }
}

void HeadDriver::handle_setting(const Outcome& outcome, std::int64_t now_ns) {
    switch (outcome.kind) {
        case Outcome::Kind::acknowledged:
        case Outcome::Kind::completed:
            setting_.reset();
            break;
        case Outcome::Kind::refused: {
            const bool later =
                outcome.fault == Fault::buffer_full ||
                (outcome.fault == Fault::not_executable && ++setting_->refusals < most_refusals);
            if (later) {
                setting_->id = 0;
                setting_->not_before_ns = now_ns + retry_ns;
            } else {
                setting_.reset();
            }
            break;
        }
        default:
            // It is told again, unless a newer one has taken its place meanwhile.
            queue_.put_back(setting_->message);
            setting_.reset();
    }
}

void HeadDriver::handle_motion(const Outcome& outcome, std::int64_t now_ns) {
    const bool is_current = current_ && current_->id == outcome.id &&
                            (current_->stage == Stage::sent || current_->stage == Stage::executing);
    if (outcome.kind == Outcome::Kind::acknowledged) {
        motion_begins(outcome, is_current, now_ns);
        return;
    }
    moves_.erase(outcome.id);
    if (!is_current) {
        return;
    }
    if (outcome.kind == Outcome::Kind::refused) {
        motion_refused(outcome, now_ns);
    } else {
        motion_ends(outcome, now_ns);
    }
}

void HeadDriver::motion_begins(const Outcome& outcome, bool is_current, std::int64_t now_ns) {
    motion_unanswered_ = false;
    syntax_errors_ = 0;
    for (auto& [id, move] : moves_) {
        move.superseded_ns = move.superseded_ns.value_or(now_ns);
    }
    if (outcome.message.op != Op::drive) {
        moves_[outcome.id] = {now_ns};
    }
    if (is_current) {
        expect(current_->motion, now_ns);
        current_->stage = Stage::executing;
    } else if (!current_) {
        clear_moves();  // a halt came meanwhile
    }
}

void HeadDriver::expect(const Motion& motion, std::int64_t now_ns) {
    std::lock_guard lock(mutex_);
    if (motion.kind == Motion::Kind::look) {
        const Message message = message_of(motion);
        estimate_.set_target(
            HeadAngles{rad_from_deg(model_->pan.deg_from_steps(message.values[2])),
                       rad_from_deg(model_->tilt.deg_from_steps(message.values[3]))},
            HeadAngles{rad_from_deg(model_->pan.speed_deg_s(message.values[0])),
                       rad_from_deg(model_->tilt.speed_deg_s(message.values[1]))},
            now_ns);
    } else if (motion.kind == Motion::Kind::drive) {
        estimate_.set_drive(motion.angles.pan_rad, motion.angles.tilt_rad, now_ns);
    } else {
        estimate_.set_target(
            motion.message.op == Op::home ? std::optional(HeadAngles{}) : std::nullopt, now_ns);
    }
}

void HeadDriver::motion_ends(const Outcome& outcome, std::int64_t now_ns) {
    const bool completed = outcome.kind == Outcome::Kind::completed;
    if (completed && current_->stage == Stage::sent) {
        expect(current_->motion, now_ns);  // its acknowledgement was lost
    }
    if (completed || outcome.kind == Outcome::Kind::incomplete) {
        current_->stage = Stage::done;
        return;
    }
    // No reply, or the link was lost.
    current_->stage = Stage::waiting;
    motion_unanswered_ = true;
    if (outcome.message.op == Op::reset) {
        current_.reset();
    }
}

void HeadDriver::motion_refused(const Outcome& outcome, std::int64_t now_ns) {
    if (outcome.fault == Fault::not_executable || outcome.fault == Fault::buffer_full) {
        current_->stage = Stage::waiting;
        current_->not_before_ns =
            now_ns + (outcome.fault == Fault::buffer_full ? retry_full_ns : retry_ns);
        if (outcome.fault == Fault::not_executable) {
            // It may not take over from what is under way.
            clear_moves();
        }
    } else if (outcome.fault == Fault::cancelled) {
        current_->stage = Stage::done;
    } else if (outcome.fault == Fault::syntax || outcome.fault == Fault::message_length) {
        // On a bad line it was damaged on its way.
        current_->stage = Stage::waiting;
        if (++syntax_errors_ > most_syntax_errors) {
            syntax_errors_ = 0;
            note(HeadNote::Kind::fault, "The head does not understand " +
                                            name_of(outcome.message.op) +
                                            ": it is given up. Check the model.");
            current_.reset();
        }
    }
}

void HeadDriver::handle_answer(const Outcome& outcome, std::int64_t now_ns) {
    const auto& values = outcome.values;
    switch (outcome.message.op) {
        case Op::ask_position:
            read_position(values, now_ns);
            break;
        case Op::ask_power:
            power_is_known_ = true;
            if (values[0] != power_on) {
                note(HeadNote::Kind::note, "The head is in standby: it is switched on.");
                queue_.put(Message{Op::power, {power_on}});
            }
            break;
        case Op::ask_zoom:
        case Op::ask_focus:
        case Op::ask_focus_mode: {
            std::lock_guard lock(mutex_);
            LensStatus lens = lens_.value_or(LensStatus{});
            if (outcome.message.op == Op::ask_zoom) {
                lens.zoom_share = static_cast<double>(values[0]) / model_->zoom.tele;
                lens.horizontal_view_rad = model_->zoom.horizontal_view_rad(values[0]);
                lens.widest_view_rad = model_->zoom.horizontal_view_rad(0.0);
            } else if (outcome.message.op == Op::ask_focus) {
                lens.focus_share = static_cast<double>(values[0] - model_->focus_far) /
                                   std::max(1, std::abs(model_->focus_near - model_->focus_far));
            } else {
                lens.autofocus = values[0] == autofocus_on;
            }
            // Whoever asks early is not told a zoom that nobody has read.
            if (lens_ || outcome.message.op == Op::ask_zoom) {
                lens_ = lens;
            }
            break;
        }
        default:
            break;
    }
}

// A completion may be a lie: the position was damaged on its way, or the power was gone.
void HeadDriver::verify(const HeadAngles& angles) {
    if (!current_ || current_->stage != Stage::done ||
        current_->motion.kind != Motion::Kind::look || !estimate_.at_rest()) {
        return;
    }
    const Message wanted = message_of(current_->motion);
    const double pan_off =
        std::abs(deg_from_rad(angles.pan_rad) - model_->pan.deg_from_steps(wanted.values[2])) *
        model_->pan.steps_per_deg;
    const double tilt_off =
        std::abs(deg_from_rad(angles.tilt_rad) - model_->tilt.deg_from_steps(wanted.values[3])) *
        model_->tilt.steps_per_deg;
    if (std::max(pan_off, tilt_off) <= correction_steps) {
        current_->corrections = 0;
    } else if (current_->corrections < most_corrections) {
        ++current_->corrections;
        current_->stage = Stage::waiting;
        note(HeadNote::Kind::warning, "The head came to rest elsewhere: it is told again.");
    } else if (current_->corrections == most_corrections) {
        ++current_->corrections;
        note(HeadNote::Kind::warning, "The head stays " +
                                          std::to_string(std::lround(std::max(pan_off, tilt_off))) +
                                          " steps short of where it should look.");
    }
}

}  // namespace kambara::visca
