// SPDX-License-Identifier: GPL-3.0-or-later
#include "hardware/simulated/simulated_profile.h"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <type_traits>
#include <vector>

#include "core/base/angles.h"

namespace kambara {
namespace {

Error refused(const std::string& cause) {
    return {cause,
            "Give default, stations, plumb, chessboard or two-plane-24, and after a ? any of seed, "
            "noise, "
            "colour, "
            "water, lamps, haze, veil, forward, blur, snow, particles, step, swap, nearest, "
            "farthest, circle, turn, sway, swing, feed, feed_delay, feed_noise, arm, ahead, "
            "skew, backlash, frames, rate, "
            "medium, target, as in default?seed=3&noise=1."};
}

// These and apply() give nothing when they took the value, else why they did not.
template <class Number>
std::string read(std::string_view text, double lowest, double highest, Number& number) {
    Number value{};
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
    // The comparison is false for what is no number at all.
    if (code != std::errc{} || end != text.data() + text.size() ||
        !(static_cast<double>(value) >= lowest && static_cast<double>(value) <= highest)) {
        char range[64];
        std::snprintf(range, sizeof range, "from %.10g to %.10g", lowest, highest);
        return (std::is_integral_v<Number> ? "it takes a whole number " : "it takes a number ") +
               std::string(range);
    }
    number = value;
    return {};
}

std::string read(std::string_view text, bool& flag) {
    if (text != "0" && text != "1") {
        return "it takes 0 or 1";
    }
    flag = text == "1";
    return {};
}

std::string read_metres(std::string_view text, double lowest, double highest, double& value_mm) {
    double value_m = 0.0;
    std::string problem = read(text, lowest, highest, value_m);
    if (problem.empty()) {
        value_mm = 1e3 * value_m;
    }
    return problem;
}

std::string read_degrees(std::string_view text, double lowest, double highest, double& value_rad) {
    double value_deg = 0.0;
    std::string problem = read(text, lowest, highest, value_deg);
    if (problem.empty()) {
        value_rad = rad_from_deg(value_deg);
    }
    return problem;
}

std::string apply_water(std::string_view name, SimulatedProfile& profile) {
    const auto kind = water_kind(name);
    if (!kind) {
        return "it takes clear, coastal or harbour";
    }
    const WaterPreset preset = preset_of(*kind);
    profile.water = *kind;
    profile.medium = Medium::water;
    profile.haze_per_m = preset.attenuation_per_m;
    profile.veil_grey = preset.veil_grey;
    profile.forward_share = preset.forward_share;
    profile.blur_px = preset.blur_px;
    profile.snow_per_litre = preset.snow_per_litre;
    profile.particles = 0;
    return {};
}

std::string apply(std::string_view key, std::string_view value, SimulatedProfile& profile) {
    if (key == "seed") {
        return read(value, 0, 4294967295.0, profile.seed);
    }
    if (key == "noise") {
        return read(value, 0, 50, profile.noise_grey);
    }
    if (key == "colour") {
        return read(value, profile.colour);
    }
    if (key == "water") {
        return apply_water(value, profile);
    }
    if (key == "lamps") {
        return read(value, profile.lamps);
    }
    if (key == "haze") {
        return read(value, 0, 10, profile.haze_per_m);
    }
    if (key == "veil") {
        return read(value, 0, 255, profile.veil_grey);
    }
    if (key == "forward") {
        return read(value, 0, 1, profile.forward_share);
    }
    if (key == "snow") {
        return read(value, 0, 100, profile.snow_per_litre);
    }
    if (key == "blur") {
        return read(value, 0, 10, profile.blur_px);
    }
    if (key == "step") {
        return read(value, 0, 0.95, profile.step);
    }
    if (key == "swap") {
        return read(value, 0, 1e6, profile.swap_s);
    }
    if (key == "nearest") {
        return read_metres(value, 0.5, 20, profile.nearest_mm);
    }
    if (key == "farthest") {
        return read_metres(value, 0.5, 20, profile.farthest_mm);
    }
    if (key == "circle") {
        return read_metres(value, 0.01, 0.6, profile.circle_mm);
    }
    if (key == "likes") {
        return read(value, 0, 10, profile.likes);
    }
    if (key == "turn") {
        return read_degrees(value, 0, 400, profile.turn_rad_s);
    }
    if (key == "sway") {
        return read_metres(value, 0, 2, profile.sway_mm_s);
    }
    if (key == "swing") {
        return read(value, 0.1, 600, profile.turn_period_s);
    }
    if (key == "feed") {
        return read(value, profile.feed);
    }
    if (key == "feed_delay") {
        return read(value, 0, 1, profile.feed_delay_s);
    }
    if (key == "feed_noise") {
        return read_degrees(value, 0, 20, profile.feed_turn_noise_rad_s);
    }
    if (key == "knock") {
        return read(value, 0, 1e6, profile.knock_s);
    }
    if (key == "knock_deg") {
        return read_degrees(value, -5, 5, profile.knock_rad);
    }
    if (key == "arm") {
        return read(value, -200, 200, profile.head_arm_mm);
    }
    if (key == "ahead") {
        return read(value, -200, 200, profile.head_ahead_mm);
    }
    if (key == "skew") {
        return read_degrees(value, -5, 5, profile.head_skew_rad);
    }
    if (key == "backlash") {
        std::string problem = read_degrees(value, 0, 3, profile.head_backlash.pan_rad);
        profile.head_backlash.tilt_rad = profile.head_backlash.pan_rad;
        return problem;
    }
    if (key == "particles") {
        return read(value, 0, 5000, profile.particles);
    }
    if (key == "frames") {
        return read(value, 1, 1e9, profile.frames);
    }
    if (key == "rate") {
        return read(value, 0.1, 1000, profile.rate_hz);
    }
    if (key == "medium") {
        if (value != "air" && value != "water") {
            return "it takes air or water";
        }
        profile.medium = value == "air" ? Medium::air : Medium::water;
        return {};
    }
    if (key == "target") {
        if (!profile.calibration_target) {
            return "the profile " + profile.name + " shows no calibration target";
        }
        const auto target = parse_target(value);
        if (!target) {
            return "it takes chessboard:9x6:30, charuco:5x7:40:20:DICT_6X6_250, two-plane-24 or a "
                   "target file";
        }
        profile.calibration_target = *target;
        return {};
    }
    return "there is no such key";
}

}  // namespace

std::optional<HeadModel> true_head(const SimulatedProfile& profile,
                                   const Camera& pan_tilt_at_home) {
    if (profile.head_arm_mm == 0.0 && profile.head_ahead_mm == 0.0 &&
        profile.head_skew_rad == 0.0 && profile.head_backlash == HeadAngles{}) {
        return std::nullopt;
    }
    HeadModel head;
    head.tilt_axis_ahead_mm = profile.head_ahead_mm;
    head.tilt_axis_skew_rad = profile.head_skew_rad;
    head.T_camera_from_tilt.t_mm = {0.0, 0.0, -profile.head_arm_mm};
    head.pan_backlash_rad = profile.head_backlash.pan_rad;
    head.tilt_backlash_rad = profile.head_backlash.tilt_rad;
    const RigidTransform T_camera_from_base = T_camera_from_rig(head, {});  // at home
    head.T_base_from_rig = T_camera_from_base.inverse() * pan_tilt_at_home.T_camera_from_rig;
    return head;
}

Result<SimulatedProfile> simulated_profile(std::string_view text) {
    const auto question = text.find('?');
    SimulatedProfile profile;
    profile.name = std::string(text.substr(0, question));
    if (profile.name == "chessboard") {
        profile.calibration_target = ChessboardTarget{9, 6, 30.0};
    } else if (profile.name == "two-plane-24") {
        profile.calibration_target = two_plane_24();
    } else if (profile.name == "stations") {
        profile.path = TargetPath::stations;
    } else if (profile.name == "plumb") {
        profile.path = TargetPath::plumb;
    } else if (profile.name != "default") {
        return refused("There is no simulated profile \"" + profile.name + "\".");
    }
    std::string_view rest =
        question == std::string_view::npos ? std::string_view() : text.substr(question + 1);
    std::vector<std::string_view> items;
    while (!rest.empty()) {
        items.push_back(rest.substr(0, rest.find('&')));
        rest.remove_prefix(std::min(rest.size(), items.back().size() + 1));
    }
    // What is said of the water in particular counts more than its kind, wherever that is said.
    std::stable_partition(items.begin(), items.end(),
                          [](std::string_view item) { return item.starts_with("water="); });
    for (const std::string_view item : items) {
        const auto equals = item.find('=');
        const std::string problem =
            equals == std::string_view::npos
                ? "it is not of the form key=value"
                : apply(item.substr(0, equals), item.substr(equals + 1), profile);
        if (!problem.empty()) {
            return refused("The simulated profile's \"" + std::string(item) +
                           "\" can't be used: " + problem + ".");
        }
    }
    if (profile.nearest_mm > profile.farthest_mm) {
        return refused("The simulated target's nearest distance lies beyond its farthest.");
    }
    return profile;
}

}  // namespace kambara
