// SPDX-License-Identifier: GPL-3.0-or-later
#include <iterator>
#include <utility>

#include "core/vsystem/json_fields.h"
#include "core/vsystem/serialise.h"

namespace kambara {
namespace {

using namespace json_fields;

constexpr const char* run_names[] = {"paused", "running", "ended", "failed"};
constexpr const char* model_names[] = {"constant_velocity", "constant_acceleration"};
constexpr const char* event_names[] = {"note", "warning", "fault"};

template <class Enum, std::size_t N>
Enum read_name(const Json& json, const char* key, const char* const (&names)[N]) {
    const auto name = get<std::string>(json, key);
    for (std::size_t i = 0; i < N; ++i) {
        if (name == names[i]) {
            return static_cast<Enum>(i);
        }
    }
    throw Fault{std::string("\"") + key + "\" is \"" + name + "\", which is not known"};
}

// The upper triangle, row by row, of a covariance, and back.
Eigen::Matrix<double, 6, 1> upper_of(const Eigen::Matrix3d& c) {
    Eigen::Matrix<double, 6, 1> upper;
    upper << c(0, 0), c(0, 1), c(0, 2), c(1, 1), c(1, 2), c(2, 2);
    return upper;
}

Eigen::Matrix3d from_upper(const Eigen::Matrix<double, 6, 1>& c) {
    Eigen::Matrix3d m;
    m << c[0], c[1], c[2], c[1], c[3], c[4], c[2], c[4], c[5];
    return m;
}

Json json_of(const Position& p) {
    Json json{{"point_in_left_mm", from_vector<3>(p.point_in_left_mm)},
              {"covariance_mm2", from_vector<6>(upper_of(p.covariance_mm2))},
              {"method", to_string(p.method)},
              {"residual_px", p.residual_px},
              {"parallax_rad", p.parallax_rad},
              {"epipolar_offset_px", p.epipolar.offset_px},
              {"epipolar_noise_sigma_px", p.epipolar.noise_sigma_px}};
    if (p.calibration_covariance_mm2) {
        json["calibration_covariance_mm2"] =
            from_vector<6>(upper_of(*p.calibration_covariance_mm2));
    }
    put_optional(json, "epipolar_calibration_sigma_px", p.epipolar.calibration_sigma_px);
    return json;
}

Position read_position(const Json& json) {
    Position p;
    p.point_in_left_mm = get_vector<3>(json, "point_in_left_mm");
    p.covariance_mm2 = from_upper(get_vector<6>(json, "covariance_mm2"));
    if (json.contains("calibration_covariance_mm2")) {
        p.calibration_covariance_mm2 =
            from_upper(get_vector<6>(json, "calibration_covariance_mm2"));
    }
    const auto method = position_method_from(get<std::string>(json, "method"));
    if (!method) {
        throw Fault{"\"method\" is not known"};
    }
    p.method = *method;
    p.epipolar = {get<double>(json, "epipolar_offset_px"),
                  get<double>(json, "epipolar_noise_sigma_px"),
                  get_optional<double>(json, "epipolar_calibration_sigma_px")};
    p.residual_px = get<double>(json, "residual_px");
    p.parallax_rad = get<double>(json, "parallax_rad");
    return p;
}

Json json_of(const MotionEstimate& m) {
    return {{"smoothed_in_left_mm", from_vector<3>(m.point_mm)},
            {"velocity_mm_s", from_vector<3>(m.velocity_mm_s)},
            {"velocity_covariance_mm2_s2", from_vector<6>(upper_of(m.velocity_covariance_mm2_s2))},
            {"acceleration_mm_s2", from_vector<3>(m.acceleration_mm_s2)},
            {"model", model_names[static_cast<int>(m.model)]},
            {"innovation", m.innovation},
            {"consistent", m.consistent},
            {"by_vehicle", m.by_vehicle}};
}

MotionEstimate read_motion(const Json& json) {
    MotionEstimate m;
    m.point_mm = get_vector<3>(json, "smoothed_in_left_mm");
    m.velocity_mm_s = get_vector<3>(json, "velocity_mm_s");
    m.velocity_covariance_mm2_s2 = from_upper(get_vector<6>(json, "velocity_covariance_mm2_s2"));
    m.acceleration_mm_s2 = get_vector<3>(json, "acceleration_mm_s2");
    m.model = read_name<MotionModel>(json, "model", model_names);
    m.innovation = get<double>(json, "innovation");
    m.consistent = get<bool>(json, "consistent");
    m.by_vehicle = get<bool>(json, "by_vehicle");
    return m;
}

Json json_of(const TrackSnapshot& track) {
    const TrackEstimate& e = track.estimate;
    Json json{{"id", track.id},
              {"state", to_string(e.state)},
              {"reason", e.reason},
              {"quality", e.quality},
              {"template_size_px", {e.template_size_px.x(), e.template_size_px.y()}},
              {"template_updates", e.template_updates}};
    if (e.left_px) {
        json["left_px"] = from_vector<2>(*e.left_px);
    }
    if (e.right_px) {
        json["right_px"] = from_vector<2>(*e.right_px);
    }
    if (e.position) {
        json["position"] = json_of(*e.position);
    }
    if (e.motion) {
        json["motion"] = json_of(*e.motion);
    }
    return json;
}

TrackState read_state(const Json& json) {
    const auto state = track_state_from(get<std::string>(json, "state"));
    if (!state) {
        throw Fault{"\"state\" is not known"};
    }
    return *state;
}

Eigen::Vector2i read_size(const Json& json) {
    const auto size = get_vector<2>(json, "template_size_px");
    if (!(size.cwiseAbs().maxCoeff() < 1e6)) {
        throw Fault{"\"template_size_px\" is not a size"};
    }
    return size.cast<int>();
}

TrackSnapshot read_track(const Json& json) {
    TrackSnapshot track;
    track.id = get<int>(json, "id");
    track.estimate.state = read_state(json);
    track.estimate.reason = get<std::string>(json, "reason");
    track.estimate.quality = get<double>(json, "quality");
    track.estimate.template_size_px = read_size(json);
    track.estimate.template_updates = get<int>(json, "template_updates");
    if (json.contains("left_px")) {
        track.estimate.left_px = get_vector<2>(json, "left_px");
    }
    if (json.contains("right_px")) {
        track.estimate.right_px = get_vector<2>(json, "right_px");
    }
    if (json.contains("position")) {
        track.estimate.position = read_position(json.at("position"));
    }
    if (json.contains("motion")) {
        track.estimate.motion = read_motion(json.at("motion"));
    }
    return track;
}

Json json_of(const RigWatchState& watch) {
    return {{"matches", watch.matches},
            {"offset_px", watch.offset_px},
            {"sigma_px", watch.sigma_px},
            {"turn_rad", watch.turn_rad},
            {"moved", watch.moved}};
}

RigWatchState read_rig_watch(const Json& json) {
    return {get<int>(json, "matches"), get<double>(json, "offset_px"),
            get<double>(json, "sigma_px"), get<double>(json, "turn_rad"), get<bool>(json, "moved")};
}

Json json_of(const HeadSnapshot& head) {
    Json json{{"pan_rad", head.angles.pan_rad},
              {"tilt_rad", head.angles.tilt_rad},
              {"moving", head.moving},
              {"automatic", head.automatic},
              {"at_limit", head.at_limit},
              {"fault", head.fault},
              {"axes_pan_rad", head.axes.pan_rad},
              {"axes_tilt_rad", head.axes.tilt_rad}};
    if (head.commanded) {
        json["commanded_pan_rad"] = head.commanded->pan_rad;
        json["commanded_tilt_rad"] = head.commanded->tilt_rad;
    }
    if (head.lens) {
        json["lens"] = {{"zoom_share", head.lens->zoom_share},
                        {"horizontal_view_rad", head.lens->horizontal_view_rad},
                        {"widest_view_rad", head.lens->widest_view_rad},
                        {"focus_share", head.lens->focus_share},
                        {"autofocus", head.lens->autofocus}};
    }
    json["abilities"] = {
        {"drive", head.abilities.drive},         {"reset", head.abilities.reset},
        {"zoom", head.abilities.zoom},           {"focus", head.abilities.focus},
        {"autofocus", head.abilities.autofocus}, {"presets", head.abilities.presets}};
    json["limits"] = {{"pan_rad", head.limits.pan_rad},
                      {"tilt_rad", head.limits.tilt_rad},
                      {"pan_speed_rad_s", head.limits.pan_speed_rad_s},
                      {"tilt_speed_rad_s", head.limits.tilt_speed_rad_s}};
    return json;
}

HeadSnapshot read_head(const Json& json) {
    HeadSnapshot head;
    head.angles = {get<double>(json, "pan_rad"), get<double>(json, "tilt_rad")};
    head.axes = head.angles;
    if (json.contains("axes_pan_rad")) {
        head.axes = {get<double>(json, "axes_pan_rad"), get<double>(json, "axes_tilt_rad")};
    }
    head.moving = get<bool>(json, "moving");
    head.automatic = get<bool>(json, "automatic");
    head.at_limit = get<bool>(json, "at_limit");
    head.fault = get<std::string>(json, "fault");
    if (json.contains("commanded_pan_rad")) {
        head.commanded = HeadAngles{get<double>(json, "commanded_pan_rad"),
                                    get<double>(json, "commanded_tilt_rad")};
    }
    if (json.contains("lens")) {
        const Json& lens = json.at("lens");
        head.lens =
            LensStatus{get<double>(lens, "zoom_share"), get<double>(lens, "horizontal_view_rad"),
                       get<double>(lens, "widest_view_rad"), get<double>(lens, "focus_share"),
                       get<bool>(lens, "autofocus")};
    }
    const Json& able = field(json, "abilities");
    head.abilities = {get<bool>(able, "drive"),     get<bool>(able, "reset"),
                      get<bool>(able, "zoom"),      get<bool>(able, "focus"),
                      get<bool>(able, "autofocus"), get<int>(able, "presets")};
    const Json& limits = field(json, "limits");
    head.limits = {get<double>(limits, "pan_rad"), get<double>(limits, "tilt_rad"),
                   get<double>(limits, "pan_speed_rad_s"), get<double>(limits, "tilt_speed_rad_s")};
    return head;
}

Json json_of(const ServoSnapshot& servo) {
    Json json{{"on", servo.on},
              {"state", to_string(servo.state)},
              {"reason", servo.reason},
              {"template_size_px", {servo.template_size_px.x(), servo.template_size_px.y()}},
              {"quality", servo.quality},
              {"alone", servo.alone}};
    if (servo.pan_tilt_px) {
        json["pan_tilt_px"] = from_vector<2>(*servo.pan_tilt_px);
    }
    if (servo.correction) {
        json["correction_pan_rad"] = servo.correction->pan_rad;
        json["correction_tilt_rad"] = servo.correction->tilt_rad;
    }
    return json;
}

ServoSnapshot read_servo(const Json& json) {
    ServoSnapshot servo;
    servo.on = get<bool>(json, "on");
    servo.state = read_state(json);
    servo.reason = get<std::string>(json, "reason");
    servo.template_size_px = read_size(json);
    servo.quality = get<double>(json, "quality");
    servo.alone = get<bool>(json, "alone");
    if (json.contains("pan_tilt_px")) {
        servo.pan_tilt_px = get_vector<2>(json, "pan_tilt_px");
    }
    if (json.contains("correction_pan_rad")) {
        servo.correction = HeadAngles{get<double>(json, "correction_pan_rad"),
                                      get<double>(json, "correction_tilt_rad")};
    }
    return servo;
}

Snapshot read_snapshot(const Json& json) {
    Snapshot snapshot;
    snapshot.frame = get<std::int64_t>(json, "frame");
    snapshot.time_ns = get<std::int64_t>(json, "time_ns");
    snapshot.run = read_name<RunState>(json, "run", run_names);
    if (json.contains("failure")) {
        const Json& failure = json.at("failure");
        snapshot.failure =
            Error{get<std::string>(failure, "cause"), get<std::string>(failure, "remedy")};
    }
    const Json& tracks = field(json, "tracks");
    if (!tracks.is_array()) {
        throw Fault{"\"tracks\" is not a list"};
    }
    for (const Json& track : tracks) {
        snapshot.tracks.push_back(read_track(track));
    }
    snapshot.steered_target = get_optional<int>(json, "steered_target");
    if (json.contains("head")) {
        snapshot.head = read_head(json.at("head"));
    }
    if (json.contains("servo")) {
        snapshot.servo = read_servo(json.at("servo"));
    }
    if (json.contains("rig_watch")) {
        snapshot.rig_watch = read_rig_watch(json.at("rig_watch"));
    }
    snapshot.rate_hz = get<double>(json, "rate_hz");
    snapshot.processing_ms = get<double>(json, "processing_ms");
    snapshot.latency_ms = get<double>(json, "latency_ms");
    snapshot.frames_lost = get<std::uint64_t>(json, "frames_lost");
    snapshot.frames_total = get<std::int64_t>(json, "frames_total");
    return snapshot;
}

}  // namespace

std::string to_json(const Snapshot& snapshot) {
    Json tracks = Json::array();
    for (const TrackSnapshot& track : snapshot.tracks) {
        tracks.push_back(json_of(track));
    }
    Json json{{"frame", snapshot.frame},
              {"time_ns", snapshot.time_ns},
              {"run", run_names[static_cast<int>(snapshot.run)]},
              {"tracks", std::move(tracks)},
              {"rate_hz", snapshot.rate_hz},
              {"processing_ms", snapshot.processing_ms},
              {"latency_ms", snapshot.latency_ms},
              {"frames_lost", snapshot.frames_lost},
              {"frames_total", snapshot.frames_total}};
    put_optional(json, "steered_target", snapshot.steered_target);
    if (snapshot.failure) {
        json["failure"] = {{"cause", snapshot.failure->cause},
                           {"remedy", snapshot.failure->remedy}};
    }
    if (snapshot.rig_watch) {
        json["rig_watch"] = json_of(*snapshot.rig_watch);
    }
    if (snapshot.head) {
        json["head"] = json_of(*snapshot.head);
    }
    if (snapshot.servo) {
        json["servo"] = json_of(*snapshot.servo);
    }
    return text_of(json);
}

std::string to_json(const Event& event) {
    return text_of(Json{{"kind", event_names[static_cast<int>(event.kind)]},
                        {"frame", event.frame},
                        {"time_ns", event.time_ns},
                        {"text", event.text}});
}

Result<Snapshot> snapshot_from_json(std::string_view text) {
    return read_text(text, "snapshot", read_snapshot);
}

Result<Event> event_from_json(std::string_view text) {
    return read_text(text, "event", [](const Json& json) {
        return Event{read_name<Event::Kind>(json, "kind", event_names),
                     get<std::int64_t>(json, "frame"), get<std::int64_t>(json, "time_ns"),
                     get<std::string>(json, "text")};
    });
}

}  // namespace kambara
