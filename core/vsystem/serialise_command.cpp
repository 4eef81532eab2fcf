// SPDX-License-Identifier: GPL-3.0-or-later
#include <type_traits>

#include "core/vsystem/json_fields.h"
#include "core/vsystem/serialise.h"

namespace kambara {
namespace {

using namespace json_fields;

Json from_rectangle(const Rectangle& r) {
    return {r.x, r.y, r.width, r.height};
}

Json fields_of(const SelectTemplate& c) {
    Json json{{"command", "select_template"}, {"rectangle_px", from_rectangle(c.rectangle)}};
    put_optional(json, "frame", c.frame);
    put_optional(json, "target", c.target);
    return json;
}
Json of_target(const char* command, const std::optional<int>& target) {
    Json json{{"command", command}};
    put_optional(json, "target", target);
    return json;
}
Json fields_of(const StartTracking& c) {
    return of_target("start_tracking", c.target);
}
Json fields_of(const StopTracking& c) {
    return of_target("stop_tracking", c.target);
}
Json fields_of(const UpdateTemplate& c) {
    return of_target("update_template", c.target);
}
Json fields_of(const ClearTemplate& c) {
    return of_target("clear_template", c.target);
}
Json fields_of(const SteerTo& c) {
    return of_target("steer_to", c.target);
}
Json fields_of(const MoveHead& c) {
    return {
        {"command", "move_head"}, {"pan_rad", c.angles.pan_rad}, {"tilt_rad", c.angles.tilt_rad}};
}
Json fields_of(const HaltHead&) {
    return {{"command", "halt_head"}};
}
Json fields_of(const Seek& c) {
    return {{"command", "seek"}, {"frame", c.frame}};
}
Json fields_of(const HoldFrame& c) {
    return {{"command", "hold_frame"}, {"frame", c.frame}};
}
Json fields_of(const SteerHead& c) {
    return {{"command", "steer_head"}, {"automatic", c.automatic}};
}
Json fields_of(const DriveHead& c) {
    return {{"command", "drive_head"}, {"pan_rad_s", c.pan_rad_s}, {"tilt_rad_s", c.tilt_rad_s}};
}
Json fields_of(const HomeHead&) {
    return {{"command", "home_head"}};
}
Json fields_of(const ResetHead&) {
    return {{"command", "reset_head"}};
}
Json fields_of(const CentreHead& c) {
    Json json{{"command", "centre_head"}, {"x_px", c.x_px}, {"y_px", c.y_px}};
    if (c.seen_from) {
        json["seen_from_pan_rad"] = c.seen_from->pan_rad;
        json["seen_from_tilt_rad"] = c.seen_from->tilt_rad;
    }
    return json;
}
Json fields_of(const ZoomHead& c) {
    return {{"command", "zoom_head"}, {"share", c.share}};
}
Json fields_of(const FocusHead& c) {
    return {{"command", "focus_head"}, {"share", c.share}};
}
Json fields_of(const AutofocusHead&) {
    return {{"command", "autofocus_head"}};
}
Json fields_of(const KeepPreset& c) {
    return {{"command", "keep_preset"}, {"number", c.number}};
}
Json fields_of(const RecallPreset& c) {
    return {{"command", "recall_preset"}, {"number", c.number}};
}
Json fields_of(const ServoHead& c) {
    return {{"command", "servo_head"}, {"on", c.on}};
}
Json fields_of(const SelectInPanTilt& c) {
    return {{"command", "select_in_pan_tilt"}, {"rectangle_px", from_rectangle(c.rectangle)}};
}
Json fields_of(const CaptureView&) {
    return {{"command", "capture_view"}};
}
Json fields_of(const Calibrate& c) {
    return {{"command", "calibrate"}, {"target", c.target}};
}
Json fields_of(const Flow& c) {
    const char* kinds[] = {"run", "pause", "step"};
    return {{"command", "flow"}, {"kind", kinds[static_cast<int>(c.kind)]}};
}

Json fields_of(const TellVehicleMotion& c) {
    return {{"command", "tell_vehicle_motion"},
            {"time_ns", c.motion.time_ns},
            {"velocity_mm_s", from_vector<3>(c.motion.velocity_mm_s)},
            {"turn_rad_s", from_vector<3>(c.motion.turn_rad_s)},
            {"velocity_sigma_mm_s", c.motion.velocity_sigma_mm_s},
            {"turn_sigma_rad_s", c.motion.turn_sigma_rad_s}};
}

Rectangle read_rectangle(const Json& json) {
    const Json& list = field(json, "rectangle_px");
    if (!list.is_array() || list.size() != 4) {
        throw Fault{"\"rectangle_px\" is not a list of 4"};
    }
    int numbers[4];
    for (std::size_t i = 0; i < 4; ++i) {
        numbers[i] = get<int>(Json{{"n", list.at(i)}}, "n");
    }
    return {numbers[0], numbers[1], numbers[2], numbers[3]};
}

Flow read_flow(const Json& json) {
    const auto kind = get<std::string>(json, "kind");
    if (kind == "run") {
        return {Flow::Kind::run};
    }
    if (kind == "pause") {
        return {Flow::Kind::pause};
    }
    if (kind == "step") {
        return {Flow::Kind::step};
    }
    throw Fault{"\"kind\" is none of run, pause, step"};
}

CentreHead read_centre(const Json& json) {
    CentreHead centre{get<double>(json, "x_px"), get<double>(json, "y_px")};
    if (json.contains("seen_from_pan_rad")) {
        centre.seen_from = HeadAngles{get<double>(json, "seen_from_pan_rad"),
                                      get<double>(json, "seen_from_tilt_rad")};
    }
    return centre;
}

std::optional<Command> read_head_command(const std::string& name, const Json& json) {
    if (name == "move_head") {
        return MoveHead{{get<double>(json, "pan_rad"), get<double>(json, "tilt_rad")}};
    }
    if (name == "halt_head") {
        return HaltHead{};
    }
    if (name == "steer_head") {
        return SteerHead{get<bool>(json, "automatic")};
    }
    if (name == "servo_head") {
        return ServoHead{get<bool>(json, "on")};
    }
    if (name == "select_in_pan_tilt") {
        return SelectInPanTilt{read_rectangle(json)};
    }
    if (name == "drive_head") {
        return DriveHead{get<double>(json, "pan_rad_s"), get<double>(json, "tilt_rad_s")};
    }
    if (name == "home_head") {
        return HomeHead{};
    }
    if (name == "reset_head") {
        return ResetHead{};
    }
    if (name == "centre_head") {
        return read_centre(json);
    }
    if (name == "zoom_head") {
        return ZoomHead{get<double>(json, "share")};
    }
    if (name == "focus_head") {
        return FocusHead{get<double>(json, "share")};
    }
    if (name == "autofocus_head") {
        return AutofocusHead{};
    }
    if (name == "keep_preset") {
        return KeepPreset{get<int>(json, "number")};
    }
    if (name == "recall_preset") {
        return RecallPreset{get<int>(json, "number")};
    }
    return std::nullopt;
}

Command read_command(const Json& json) {
    const auto name = get<std::string>(json, "command");
    if (const auto head = read_head_command(name, json)) {
        return *head;
    }
    if (name == "select_template") {
        return SelectTemplate{read_rectangle(json), get_optional<std::int64_t>(json, "frame"),
                              get_optional<int>(json, "target")};
    }
    if (name == "start_tracking") {
        return StartTracking{get_optional<int>(json, "target")};
    }
    if (name == "stop_tracking") {
        return StopTracking{get_optional<int>(json, "target")};
    }
    if (name == "update_template") {
        return UpdateTemplate{get_optional<int>(json, "target")};
    }
    if (name == "clear_template") {
        return ClearTemplate{get_optional<int>(json, "target")};
    }
    if (name == "steer_to") {
        return SteerTo{get<int>(json, "target")};
    }
    if (name == "seek") {
        return Seek{get<std::int64_t>(json, "frame")};
    }
    if (name == "hold_frame") {
        return HoldFrame{get<std::int64_t>(json, "frame")};
    }
    if (name == "capture_view") {
        return CaptureView{};
    }
    if (name == "calibrate") {
        return Calibrate{get<std::string>(json, "target")};
    }
    if (name == "flow") {
        return read_flow(json);
    }
    if (name == "tell_vehicle_motion") {
        VehicleMotion motion;
        motion.time_ns = get<std::int64_t>(json, "time_ns");
        motion.velocity_mm_s = get_vector<3>(json, "velocity_mm_s");
        motion.turn_rad_s = get_vector<3>(json, "turn_rad_s");
        motion.velocity_sigma_mm_s = get<double>(json, "velocity_sigma_mm_s");
        motion.turn_sigma_rad_s = get<double>(json, "turn_sigma_rad_s");
        return TellVehicleMotion{motion};
    }
    throw Fault{"there is no command \"" + name + "\""};
}

Reply read_reply(const Json& json) {
    const auto kind = get<std::string>(json, "reply");
    if (kind == "done") {
        return Done{};
    }
    if (kind != "calibration") {
        throw Fault{"there is no reply \"" + kind + "\""};
    }
    CalibrationOutcome outcome;
    outcome.verdict = get<std::string>(json, "verdict");
    const Json& reasons = field(json, "reasons");
    if (!reasons.is_array()) {
        throw Fault{"\"reasons\" is not a list"};
    }
    for (const Json& reason : reasons) {
        outcome.reasons.push_back(get<std::string>(Json{{"reason", reason}}, "reason"));
    }
    outcome.views_used = get<int>(json, "views_used");
    outcome.stereo_rms_px = get<double>(json, "stereo_rms_px");
    outcome.baseline_mm = get<double>(json, "baseline_mm");
    outcome.rig_text = get<std::string>(json, "rig_text");
    return outcome;
}

}  // namespace

std::string to_json(const Command& command) {
    return text_of(std::visit([](const auto& c) { return fields_of(c); }, command));
}

std::string to_json(const Reply& reply) {
    if (const auto* outcome = std::get_if<CalibrationOutcome>(&reply)) {
        return text_of(Json{{"reply", "calibration"},
                            {"verdict", outcome->verdict},
                            {"reasons", outcome->reasons},
                            {"views_used", outcome->views_used},
                            {"stereo_rms_px", outcome->stereo_rms_px},
                            {"baseline_mm", outcome->baseline_mm},
                            {"rig_text", outcome->rig_text}});
    }
    return text_of(Json{{"reply", "done"}});
}

Result<Command> command_from_json(std::string_view text) {
    return read_text(text, "command", read_command);
}

Result<Reply> reply_from_json(std::string_view text) {
    return read_text(text, "reply", read_reply);
}

}  // namespace kambara
