// SPDX-License-Identifier: GPL-3.0-or-later
#include "hardware/simulated/simulated_profile.h"

#include <charconv>

namespace kambara {
namespace {

Error refused(const std::string& cause) {
    return {cause,
            "Give default, chessboard or two-plane-24, and after a ? any of seed, noise, haze, "
            "particles, frames, rate, medium, target, as in default?seed=3&noise=1."};
}

template <class Number>
bool read(std::string_view text, double lowest, double highest, Number& number) {
    Number value{};
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
    // The comparison is false for what is no number at all.
    if (code != std::errc{} || end != text.data() + text.size() ||
        !(static_cast<double>(value) >= lowest && static_cast<double>(value) <= highest)) {
        return false;
    }
    number = value;
    return true;
}

bool apply(std::string_view key, std::string_view value, SimulatedProfile& profile) {
    if (key == "seed") {
        return read(value, 0, 4294967295.0, profile.seed);
    }
    if (key == "noise") {
        return read(value, 0, 50, profile.noise_grey);
    }
    if (key == "haze") {
        return read(value, 0, 10, profile.haze_per_m);
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
    if (key == "medium" && (value == "air" || value == "water")) {
        profile.medium = value == "air" ? Medium::air : Medium::water;
        return true;
    }
    if (key == "target" && profile.calibration_target) {
        const auto target = parse_target(value);
        if (target) {
            profile.calibration_target = *target;
        }
        return target.ok();
    }
    return false;
}

}  // namespace

Result<SimulatedProfile> simulated_profile(std::string_view text) {
    const auto question = text.find('?');
    SimulatedProfile profile;
    profile.name = std::string(text.substr(0, question));
    if (profile.name == "chessboard") {
        profile.calibration_target = ChessboardTarget{9, 6, 30.0};
    } else if (profile.name == "two-plane-24") {
        profile.calibration_target = TwoPlaneTarget{};
    } else if (profile.name != "default") {
        return refused("There is no simulated profile \"" + profile.name + "\".");
    }
    std::string_view rest =
        question == std::string_view::npos ? std::string_view() : text.substr(question + 1);
    while (!rest.empty()) {
        const std::string_view item = rest.substr(0, rest.find('&'));
        rest.remove_prefix(std::min(rest.size(), item.size() + 1));
        const auto equals = item.find('=');
        if (equals == std::string_view::npos ||
            !apply(item.substr(0, equals), item.substr(equals + 1), profile)) {
            return refused("The simulated profile's \"" + std::string(item) +
                           "\" is not understood or not possible.");
        }
    }
    return profile;
}

}  // namespace kambara
