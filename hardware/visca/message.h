// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "hardware/visca/packet.h"

namespace kambara::visca {

/// Everything that can be said to a camera. The bytes, and the values each takes, are in
/// message_table.cpp (visca: commands, AT and MD).
enum class Op {
    // Interface; address_set and if_clear may be broadcast.
    address_set,  ///< number for the first camera
    if_clear,
    cancel,  ///< socket
    // Camera.
    power,  ///< 2 on, 3 standby; so are all that are switched, where nothing else is said
    key_lock,
    camera_id,
    zoom,                ///< 0 stop, 2 tele, 3 wide
    zoom_tele_variable,  ///< speed
    zoom_wide_variable,
    zoom_direct,
    zoom_focus_direct,  ///< zoom, focus
    digital_zoom,
    focus,  ///< 0 stop, 2 far, 3 near
    focus_far_variable,
    focus_near_variable,
    focus_direct,
    focus_mode,     ///< 2 auto, 3 manual, 0x10 the other one
    focus_trigger,  ///< 1 one push, 2 infinity
    af_sensitivity,
    focus_near_limit,
    white_balance,  ///< 0 auto, 1 indoor, 2 outdoor, 3 one push, 4 ATW, 5 manual
    white_balance_trigger,
    red_gain,  ///< 0 reset, 2 up, 3 down; as are shutter, iris, gain, bright, compensation
    blue_gain,
    red_gain_direct,
    blue_gain_direct,
    exposure_mode,  ///< 0 auto, 3 manual, 0xA shutter, 0xB iris, 0xD bright
    slow_shutter,
    shutter,
    shutter_direct,
    iris,
    iris_direct,
    gain,
    gain_direct,
    bright,
    bright_direct,
    compensation_mode,
    compensation,
    compensation_direct,
    back_light,
    memory_reset,  ///< number
    memory_set,
    memory_recall,
    // Pan-tilter.
    ir_receive,
    data_screen,
    drive,  ///< pan speed, tilt speed, pan (1 left, 2 right, 3 stop), tilt (1 up, 2 down, 3 stop)
    absolute,  ///< pan speed, tilt speed, pan, tilt
    relative,
    home,
    reset,
    limit_set,    ///< corner (1 up and right, 0 down and left), pan, tilt
    limit_clear,  ///< corner
    // Target tracking and motion detection of the EVI-D30.
    at_mode,  ///< 2 on, 3 off, 0x10 the other one
    at_exposure,
    at_zoom,
    atmd_frame,
    at_frame_offset,
    atmd_start_stop,
    at_chase,  ///< 0 to 2; 0x10 the next one
    at_entry,
    md_mode,
    md_frame,
    md_detect,
    md_y_level,
    md_hue_level,
    md_size,
    md_display_time,
    md_refresh_mode,
    md_refresh_time,
    md_measure_1,
    md_measure_2,
    wide_lens,
    notify,  ///< 0x20 AT lost, 0x21 MD found
    // Inquiries; what is answered is said behind.
    ask_version,  ///< vendor, model, ROM, sockets
    ask_power,
    ask_key_lock,
    ask_camera_id,
    ask_zoom,
    ask_focus_mode,
    ask_focus,
    ask_white_balance,
    ask_exposure_mode,
    ask_shutter,
    ask_iris,
    ask_gain,
    ask_back_light,
    ask_memory,
    ask_data_screen,
    ask_status,     ///< the pan-tilt status word
    ask_max_speed,  ///< pan, tilt
    ask_position,   ///< pan, tilt
    ask_video_system,
    ask_at_object,  ///< x, y, status
    ask_md_object,
    ask_atmd_mode,  ///< 0 normal, 1 AT, 2 MD
    ask_at_status,
    ask_md_status,
};

struct Message {
    Op op = Op::if_clear;
    std::vector<int> values = {};
    bool operator==(const Message&) const = default;
};

/// What differs between models in how the same is said.
struct Dialect {
    int pan_nibbles = 4;  ///< of a pan position; 5 with BRC
    /// libvisca sends the MD refresh time with the Y level's code, 0x0B; its inquiry has 0x11.
    std::uint8_t md_refresh_time_code = 0x0B;
    bool operator==(const Dialect&) const = default;
};

bool is_inquiry(Op op);
/// Moves the head.
bool is_motion(Op op);
/// For people: "pan-tilt absolute".
std::string name_of(Op op);
/// Known to the EVI-D30 and D31.
bool known_to_d30(Op op);
std::vector<Op> all_ops();

/// The packet to the camera `address` (1 to 7, or broadcast_address). Broken invariants (values
/// that the message has no room for, or another number of them) throw std::invalid_argument.
Bytes encode(const Message& message, int address, const Dialect& dialect = {});

struct Addressed {
    Message message;
    int address = 1;
};

/// The reverse, from a whole packet; empty for what is no message of the table.
std::optional<Addressed> decode_message(std::span<const std::uint8_t> packet,
                                        const Dialect& dialect = {});

/// The data of an answer (between `y0 50` and the terminator): to values, empty where they do not
/// fit the inquiry; and back.
std::optional<std::vector<int>> decode_answer(Op inquiry, std::span<const std::uint8_t> data,
                                              const Dialect& dialect = {});
Bytes encode_answer(Op inquiry, const std::vector<int>& values, const Dialect& dialect = {});

}  // namespace kambara::visca
