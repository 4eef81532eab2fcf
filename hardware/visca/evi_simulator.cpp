// SPDX-License-Identifier: GPL-3.0-or-later
#include "hardware/visca/evi_simulator.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "hardware/visca/evi_d30.h"

namespace kambara::visca {
namespace {

constexpr std::int64_t step_ns = 1'000'000;
constexpr double step_s = 1e-3;
constexpr std::int64_t ntsc_field_ns = 16'683'333;
constexpr std::int64_t pal_field_ns = 20'000'000;
constexpr std::size_t most_waiting = 16;

using namespace evi_d30;

// A lens has next to no mass: it is at speed in this part of its way's time.
constexpr double lens_start_share = 0.02;

AxisMotion lens_axis(double low, double high, double range_s) {
    const double speed = (high - low) / range_s;
    return {{low, high, speed / (lens_start_share * range_s)}, low};
}

}  // namespace

EviSimulator::EviSimulator(std::int64_t now_ns, const Options& options)
    : options_(options),
      field_ns_(options.pal ? pal_field_ns : ntsc_field_ns),
      time_ns_(now_ns),
      next_field_ns_(now_ns + field_ns_),
      next_step_ns_(now_ns + step_ns),
      pan_({-pan_stop_steps, pan_stop_steps, options.pan_acceleration_deg_s2 * pan_steps_per_deg},
           0.0),
      tilt_({-tilt_stop_steps, tilt_stop_steps,
             options.tilt_acceleration_deg_s2 * tilt_steps_per_deg},
            0.0),
      zoom_(lens_axis(0.0, zoom_tele, options.zoom_range_s)),
      focus_(lens_axis(focus_far, focus_near, options.focus_range_s)) {
    reset_state();
}

void EviSimulator::reset_state() {
    waiting_.clear();
    tasks_ = {};
    settings_ = {{Op::power, on},        {Op::focus_mode, on},
                 {Op::exposure_mode, 0}, {Op::white_balance, 0},
                 {Op::back_light, off},  {Op::data_screen, off},
                 {Op::iris, 0x0E},       {Op::gain, 1},
                 {Op::key_lock, off},    {Op::camera_id, 0},
                 {Op::memory_recall, 0}, {Op::shutter, 0},
                 {Op::at_mode, off},     {Op::atmd_start_stop, off},
                 {Op::md_mode, off}};
    pan_.set_stops(-pan_stop_steps, pan_stop_steps);
    tilt_.set_stops(-tilt_stop_steps, tilt_stop_steps);
    returns_home_ = false;
    moved_ = false;
}

void EviSimulator::receive(std::span<const std::uint8_t> packet, Tag tag, std::int64_t now_ns) {
    auto said = advance(now_ns);
    outputs_.insert(outputs_.end(), said.begin(), said.end());
    if (packet.size() < shortest_packet || (packet[0] & 0xF0) != 0x80) {
        return;
    }
    const int to = packet[0] & 0x0F;
    if (to != address_ && to != broadcast_address) {
        return;
    }
    if (waiting_.size() >= most_waiting) {
        say(Refused{0, Fault::buffer_full}, tag, address_);
        return;
    }
    waiting_.push_back({Bytes(packet.begin(), packet.end()), tag});
}

void EviSimulator::receive_too_long(Tag tag, std::int64_t now_ns) {
    auto said = advance(now_ns);
    outputs_.insert(outputs_.end(), said.begin(), said.end());
    say(Refused{0, Fault::message_length}, tag, address_);
}

std::optional<std::int64_t> EviSimulator::next_event_ns() const {
    if (!outputs_.empty()) {
        return time_ns_;
    }
    const bool at_work = std::any_of(tasks_.begin(), tasks_.end(),
                                     [](const auto& task) { return task.has_value(); }) ||
                         initialising_;
    if (at_work) {
        return std::min(next_step_ns_, next_field_ns_);
    }
    return waiting_.empty() ? std::nullopt : std::optional(next_field_ns_);
}

std::vector<EviSimulator::Output> EviSimulator::advance(std::int64_t now_ns) {
    while (std::min(next_step_ns_, next_field_ns_) <= now_ns) {
        if (next_step_ns_ <= next_field_ns_) {
            time_ns_ = next_step_ns_;
            next_step_ns_ += step_ns;
            move_on();
        } else {
            time_ns_ = next_field_ns_;
            next_field_ns_ += field_ns_;
            if (!waiting_.empty()) {
                const Waiting next = std::move(waiting_.front());
                waiting_.pop_front();
                take(next);
            }
        }
        complete_finished();
    }
    time_ns_ = std::max(time_ns_, now_ns);
    return std::exchange(outputs_, {});
}

void EviSimulator::power_cycle(Tag tag, std::int64_t now_ns) {
    auto said = advance(now_ns);
    outputs_.insert(outputs_.end(), said.begin(), said.end());
    reset_state();
    begin({Op::reset});
    tells_network_change_ = tag;
}

void EviSimulator::move_on() {
    for (AxisMotion* axis : {&pan_, &tilt_, &zoom_, &focus_}) {
        axis->advance(step_s);
    }
    if (returns_home_ && !pan_.moving() && !tilt_.moving()) {
        returns_home_ = false;
        turn_to(0.0, 0.0, pan_speed_codes, tilt_speed_codes);
    } else if (initialising_ && !pan_.moving() && !tilt_.moving()) {
        initialising_ = false;
        if (const auto tag = std::exchange(tells_network_change_, std::nullopt)) {
            say(NetworkChanged{}, *tag, address_);
        }
    }
}

void EviSimulator::say(const Reply& reply, Tag tag, int address) {
    outputs_.push_back({tag, encode(ReplyFrom{reply, address}), time_ns_});
}

void EviSimulator::take(const Waiting& waiting) {
    const auto read = decode_message(waiting.packet);
    const bool broadcast = (waiting.packet[0] & 0x0F) == broadcast_address;
    const Tag tag = waiting.tag;
    if (broadcast) {
        if (read && read->message.op == Op::address_set) {
            address_ = std::min(read->message.values[0], most_cameras);
            say(AddressesSet{address_ + 1}, tag, broadcast_address);
        } else if (read && read->message.op == Op::if_clear) {
            clear_interface();
            say(InterfaceCleared{}, tag, broadcast_address);
        }
        return;
    }
    if (!read || read->message.op == Op::address_set || !known_to_d30(read->message.op) ||
        has_bad_value(read->message)) {
        say(Refused{0, Fault::syntax}, tag, address_);
    } else if (is_inquiry(read->message.op)) {
        answer(read->message.op, tag);
    } else if (read->message.op == Op::cancel) {
        cancel(read->message.values[0], tag);
    } else if (read->message.op == Op::if_clear) {
        clear_interface();
        say(Completed{0, {}}, tag, address_);
    } else {
        command(read->message, tag);
    }
}

void EviSimulator::clear_interface() {
    waiting_.clear();
    if (in_move() && !initialising_) {
        pan_.drive(0.0);
        tilt_.drive(0.0);
    }
    tasks_ = {};
}

void EviSimulator::cancel(int socket, Tag tag) {
    const auto index = static_cast<std::size_t>(socket - 1);
    if (socket < 1 || socket > sockets || !tasks_[index]) {
        say(Refused{socket, Fault::no_socket}, tag, address_);
        return;
    }
    const Task task = *std::exchange(tasks_[index], std::nullopt);
    if (is_motion(task.message.op)) {
        pan_.drive(0.0);
        tilt_.drive(0.0);
        returns_home_ = false;
        initialising_ = false;
    }
    if (task.waits == Waits::zoom || task.waits == Waits::lens_and_head) {
        zoom_.drive(0.0);
    }
    if (task.waits == Waits::focus || task.waits == Waits::lens_and_head) {
        focus_.drive(0.0);
    }
    say(Refused{socket, Fault::cancelled}, tag, address_);
}

void EviSimulator::command(const Message& message, Tag tag) {
    const auto free = std::find_if(tasks_.begin(), tasks_.end(),
                                   [](const auto& task) { return !task.has_value(); });
    if (free == tasks_.end()) {
        say(Refused{0, Fault::buffer_full}, tag, address_);
        return;
    }
    const int socket = static_cast<int>(free - tasks_.begin()) + 1;
    if (!is_executable(message)) {
        say(Refused{socket, Fault::not_executable}, tag, address_);
        return;
    }
    say(Acknowledged{socket}, tag, address_);
    if (is_motion(message.op)) {
        finish_motion_before(socket);
    }
    if (const auto waits = begin(message)) {
        const auto power_on_ns = static_cast<std::int64_t>(options_.power_on_s * 1e9);
        *free = Task{message, tag, *waits, time_ns_ + power_on_ns};
    } else {
        say(Completed{socket, {}}, tag, address_);
    }
}

void EviSimulator::finish_motion_before(int but_socket) {
    for (int socket = 1; socket <= sockets; ++socket) {
        auto& task = tasks_[static_cast<std::size_t>(socket - 1)];
        if (task && socket != but_socket && is_motion(task->message.op)) {
            say(Completed{socket, {}}, task->tag, address_);
            task.reset();
        }
    }
    returns_home_ = false;
    initialising_ = false;
}

bool EviSimulator::in_move() const {
    return initialising_ || std::any_of(tasks_.begin(), tasks_.end(), [](const auto& task) {
               return task && is_motion(task->message.op) && task->message.op != Op::drive;
           });
}

bool EviSimulator::has_bad_value(const Message& message) const {
    const auto& values = message.values;
    switch (message.op) {
        case Op::drive: {
            const bool stop = values[2] == 3 && values[3] == 3;
            return values[0] > pan_speed_codes || values[1] > tilt_speed_codes ||
                   (!stop && (values[0] < 1 || values[1] < 1));
        }
        case Op::absolute:
        case Op::relative:
            return values[0] < 1 || values[0] > pan_speed_codes || values[1] < 1 ||
                   values[1] > tilt_speed_codes;
        case Op::memory_reset:
        case Op::memory_set:
        case Op::memory_recall:
            return values[0] >= presets;
        case Op::zoom_direct:
            return values[0] > static_cast<int>(zoom_tele);
        case Op::white_balance:
            return values[0] > 3;
        default:
            return false;
    }
}

bool EviSimulator::is_executable(const Message& message) const {
    if (message.op == Op::power) {
        return true;
    }
    if (setting(Op::power, on) == off || initialising_) {
        return false;
    }
    const int exposure = setting(Op::exposure_mode, 0);
    switch (message.op) {
        case Op::focus:
        case Op::focus_direct:
            return setting(Op::focus_mode, on) == off;
        case Op::shutter:
        case Op::shutter_direct:
            return exposure == 0x03 || exposure == 0x0A;
        case Op::iris:
        case Op::iris_direct:
            return exposure == 0x03 || exposure == 0x0B;
        case Op::gain:
        case Op::gain_direct:
            return exposure == 0x03;
        case Op::bright:
            return exposure == 0x0D;
        case Op::white_balance_trigger:
            return setting(Op::white_balance, 0) == 3;
        case Op::drive:
            return !(options_.refuses_drive_in_move && in_move());
        default:
            return true;
    }
}

int EviSimulator::setting(Op op, int otherwise) const {
    const auto found = settings_.find(op);
    return found == settings_.end() ? otherwise : found->second;
}

bool EviSimulator::is_done(const Task& task) const {
    const bool head = !pan_.moving() && !tilt_.moving() && !returns_home_ && !initialising_;
    switch (task.waits) {
        case Waits::pan_tilt:
            return head;
        case Waits::zoom:
            return !zoom_.moving();
        case Waits::focus:
            return !focus_.moving();
        case Waits::lens_and_head:
            return head && !zoom_.moving() && !focus_.moving();
        case Waits::time:
            return time_ns_ >= task.until_ns && head;
    }
    return true;
}

void EviSimulator::complete_finished() {
    for (int socket = 1; socket <= sockets; ++socket) {
        auto& task = tasks_[static_cast<std::size_t>(socket - 1)];
        if (task && is_done(*task)) {
            say(Completed{socket, {}}, task->tag, address_);
            task.reset();
        }
    }
}

EviSimulator::State EviSimulator::state() const {
    const auto in_use = std::count_if(tasks_.begin(), tasks_.end(),
                                      [](const auto& task) { return task.has_value(); });
    return {pan_.position(),
            tilt_.position(),
            zoom_.position(),
            focus_.position(),
            pan_.moving() || tilt_.moving(),
            setting(Op::power, on) == on,
            static_cast<int>(in_use)};
}

}  // namespace kambara::visca
