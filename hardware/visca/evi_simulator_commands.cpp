// SPDX-License-Identifier: GPL-3.0-or-later
// What the simulated EVI-D30 does at each command, and what it answers.
#include <algorithm>
#include <cmath>
#include <utility>

#include "hardware/visca/evi_d30.h"
#include "hardware/visca/evi_simulator.h"

namespace kambara::visca {
namespace {

using namespace evi_d30;

int whole(double value) {
    return static_cast<int>(std::lround(value));
}

}  // namespace

std::optional<EviSimulator::Waits> EviSimulator::begin(const Message& message) {
    switch (message.op) {
        case Op::drive:
        case Op::absolute:
        case Op::relative:
        case Op::home:
        case Op::reset:
        case Op::limit_set:
        case Op::limit_clear:
            return begin_motion(message);
        case Op::zoom:
        case Op::zoom_tele_variable:
        case Op::zoom_wide_variable:
        case Op::zoom_direct:
        case Op::focus:
        case Op::focus_direct:
        case Op::memory_reset:
        case Op::memory_set:
        case Op::memory_recall:
            return begin_lens(message);
        case Op::power: {
            const int was = std::exchange(settings_[Op::power], message.values[0]);
            if (message.values[0] == off) {
                pan_.drive(0.0);
                tilt_.drive(0.0);
                return std::nullopt;
            }
            if (was == on) {
                return std::nullopt;
            }
            begin({Op::reset});
            return Waits::time;
        }
        default:
            set(message);
            return std::nullopt;
    }
}

std::optional<EviSimulator::Waits> EviSimulator::begin_motion(const Message& message) {
    const auto& v = message.values;
    switch (message.op) {
        case Op::drive: {
            const auto way = [](int code, int back, int forth) {
                return code == back ? -1.0 : (code == forth ? 1.0 : 0.0);
            };
            pan_.drive(way(v[2], 1, 2) * v[0] * pan_steps_s_per_code);
            tilt_.drive(way(v[3], 2, 1) * v[1] * tilt_steps_s_per_code);
            moved_ = true;
            const bool stop = v[2] == 3 && v[3] == 3;
            return stop && options_.completes_stop_at_rest ? std::optional(Waits::pan_tilt)
                                                           : std::nullopt;
        }
        case Op::absolute:
            turn_to(v[2], v[3], v[0], v[1]);
            return Waits::pan_tilt;
        case Op::relative:
            turn_to(pan_.position() + v[2], tilt_.position() + v[3], v[0], v[1]);
            return Waits::pan_tilt;
        case Op::home:
            turn_to(0.0, 0.0, pan_speed_codes, tilt_speed_codes);
            return Waits::pan_tilt;
        case Op::reset:
            initialising_ = true;
            returns_home_ = true;
            turn_to(-pan_stop_steps, -tilt_stop_steps, pan_speed_codes, tilt_speed_codes);
            return Waits::pan_tilt;
        case Op::limit_set: {
            const double pan = std::clamp<double>(v[1], -pan_stop_steps, pan_stop_steps);
            const double tilt = std::clamp<double>(v[2], -tilt_stop_steps, tilt_stop_steps);
            if (v[0] == 1) {
                pan_.set_stops(pan_.low(), std::max(pan, pan_.low()));
                tilt_.set_stops(tilt_.low(), std::max(tilt, tilt_.low()));
            } else {
                pan_.set_stops(std::min(pan, pan_.high()), pan_.high());
                tilt_.set_stops(std::min(tilt, tilt_.high()), tilt_.high());
            }
            return std::nullopt;
        }
        default:  // limit_clear
            if (v[0] == 1) {
                pan_.set_stops(pan_.low(), pan_stop_steps);
                tilt_.set_stops(tilt_.low(), tilt_stop_steps);
            } else {
                pan_.set_stops(-pan_stop_steps, pan_.high());
                tilt_.set_stops(-tilt_stop_steps, tilt_.high());
            }
            return std::nullopt;
    }
}

void EviSimulator::turn_to(double pan, double tilt, int pan_code, int tilt_code) {
    pan_.move_to(pan, pan_code * pan_steps_s_per_code);
    tilt_.move_to(tilt, tilt_code * tilt_steps_s_per_code);
    moved_ = true;
}

std::optional<EviSimulator::Waits> EviSimulator::begin_lens(const Message& message) {
    const auto& v = message.values;
    const double zoom_speed = zoom_tele / options_.zoom_range_s;
    const double focus_speed = (focus_near - focus_far) / options_.focus_range_s;
    const auto variable = [&](int code) {
        return zoom_speed * std::max(code, slowest_zoom) / fastest_zoom;
    };
    switch (message.op) {
        case Op::zoom:
            zoom_.drive(v[0] == 0 ? 0.0 : (v[0] == 2 ? zoom_speed : -zoom_speed));
            return std::nullopt;
        case Op::zoom_tele_variable:
            zoom_.drive(variable(v[0]));
            return std::nullopt;
        case Op::zoom_wide_variable:
            zoom_.drive(-variable(v[0]));
            return std::nullopt;
        case Op::zoom_direct:
            zoom_.move_to(v[0], zoom_speed);
            return Waits::zoom;
        case Op::focus:
            focus_.drive(v[0] == 0 ? 0.0 : (v[0] == 3 ? focus_speed : -focus_speed));
            return std::nullopt;
        case Op::focus_direct:
            focus_.move_to(v[0], focus_speed);
            return Waits::focus;
        case Op::memory_reset:
            presets_[static_cast<std::size_t>(v[0])] = {0.0, 0.0, 0.0, focus_far};
            return std::nullopt;
        case Op::memory_set:
            presets_[static_cast<std::size_t>(v[0])] = {pan_.position(), tilt_.position(),
                                                        zoom_.position(), focus_.position()};
            return std::nullopt;
        default: {  // memory_recall
            const Preset& preset = presets_[static_cast<std::size_t>(v[0])];
            settings_[Op::memory_recall] = v[0];
            turn_to(preset.pan, preset.tilt, pan_speed_codes, tilt_speed_codes);
            zoom_.move_to(preset.zoom, zoom_speed);
            focus_.move_to(preset.focus, focus_speed);
            return Waits::lens_and_head;
        }
    }
}

void EviSimulator::set(const Message& message) {
    const int value = message.values.empty() ? 0 : message.values[0];
    switch (message.op) {
        case Op::shutter:
        case Op::iris:
        case Op::gain:
            step_value(message.op, value);
            break;
        case Op::shutter_direct:
            settings_[Op::shutter] = std::min(value, last_shutter);
            break;
        case Op::iris_direct:
            settings_[Op::iris] = std::min(value, last_iris);
            break;
        case Op::gain_direct:
            settings_[Op::gain] = std::min(value, last_gain);
            break;
        case Op::atmd_start_stop:
            settings_[message.op] = setting(message.op, off) == on ? off : on;
            break;
        case Op::at_chase:
            settings_[message.op] = value == other_one ? (setting(message.op, 0) + 1) % 3 : value;
            break;
        default:
            settings_[message.op] =
                value == other_one ? (setting(message.op, off) == on ? off : on) : value;
    }
    // The two modes of recognition exclude each other.
    if (message.op == Op::at_mode && setting(Op::at_mode, off) == on) {
        settings_[Op::md_mode] = off;
    } else if (message.op == Op::md_mode && setting(Op::md_mode, off) == on) {
        settings_[Op::at_mode] = off;
    }
}

void EviSimulator::step_value(Op which, int direction) {
    const int most =
        which == Op::shutter ? last_shutter : (which == Op::iris ? last_iris : last_gain);
    const int was = setting(which, 0);
    const int wanted = direction == 0 ? 0 : (direction == 2 ? was + 1 : was - 1);
    settings_[which] = std::clamp(wanted, 0, most);
}

void EviSimulator::answer(Op inquiry, Tag tag) {
    say(Completed{0, encode_answer(inquiry, answer_to(inquiry))}, tag, address_);
}

std::vector<int> EviSimulator::answer_to(Op inquiry) const {
    const bool at = setting(Op::at_mode, off) == on;
    const bool md = setting(Op::md_mode, off) == on;
    const bool recognising = setting(Op::atmd_start_stop, off) == on;
    switch (inquiry) {
        case Op::ask_version:
            return {vendor, model, options_.rom, sockets};
        case Op::ask_power:
            return {setting(Op::power, on)};
        case Op::ask_key_lock:
            return {setting(Op::key_lock, off) == on ? 2 : 0};
        case Op::ask_camera_id:
            return {setting(Op::camera_id, 0)};
        case Op::ask_zoom:
            return {whole(zoom_.position())};
        case Op::ask_focus_mode:
            return {setting(Op::focus_mode, on)};
        case Op::ask_focus:
            return {whole(focus_.position())};
        case Op::ask_white_balance:
            return {setting(Op::white_balance, 0)};
        case Op::ask_exposure_mode:
            return {setting(Op::exposure_mode, 0)};
        case Op::ask_shutter:
            return {setting(Op::shutter, 0)};
        case Op::ask_iris:
            return {setting(Op::iris, 0)};
        case Op::ask_gain:
            return {setting(Op::gain, 0)};
        case Op::ask_back_light:
            return {setting(Op::back_light, off)};
        case Op::ask_memory:
            return {setting(Op::memory_recall, 0)};
        case Op::ask_data_screen:
            return {setting(Op::data_screen, off)};
        case Op::ask_status:
            return {status_word()};
        case Op::ask_max_speed:
            return {pan_speed_codes, tilt_speed_codes};
        case Op::ask_position:
            return {whole(pan_.position()), whole(tilt_.position())};
        case Op::ask_video_system:
            return {options_.pal ? 1 : 0};
        case Op::ask_at_object:
            // It has no picture: what it should track is lost.
            return {0, 0, at && recognising ? 2 : 0};
        case Op::ask_md_object:
            return {0, 0, md && recognising ? 1 : 0};
        case Op::ask_atmd_mode:
            return {at ? 1 : (md ? 2 : 0)};
        default:  // ask_at_status, ask_md_status: no source tells their bits
            return {0};
    }
}

int EviSimulator::status_word() const {
    const bool moving = pan_.moving() || tilt_.moving();
    // What turns it while it initialises is no drive.
    const int motion = initialising_ || !moved_ ? 0 : (moving ? 1 : 2);
    return (pan_.at_low() ? 1 : 0) | (pan_.at_high() ? 2 : 0) | (tilt_.at_high() ? 4 : 0) |
           (tilt_.at_low() ? 8 : 0) | motion << 10 | (initialising_ ? 1 : 2) << 12;
}

}  // namespace kambara::visca
