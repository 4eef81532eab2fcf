// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/pan_tilt_command.h"

#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>
#include <thread>

#include "app/cli/terminal.h"
#include "app/sources/heads.h"
#include "core/base/angles.h"
#include "core/base/clock.h"

namespace kambara::cli {
namespace {

constexpr std::chrono::milliseconds look_interval{20};
// So long a head that was told something may stay where it is before it counts as at rest.
constexpr std::chrono::milliseconds at_rest_for{400};
// The lens is asked for less often.
constexpr std::chrono::milliseconds lens_at_rest_for{1500};
constexpr std::chrono::seconds longest_motion{30};
// All that is told of the lens comes with the first three questions.
constexpr std::chrono::milliseconds lens_patience{2000};
constexpr double lens_tolerance = 0.01;

std::optional<double> number_in(const std::string& text) {
    double value = 0.0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
    return fault == std::errc() && end == text.data() + text.size() ? std::optional(value)
                                                                    : std::nullopt;
}

std::optional<HeadAngles> angles_in(const std::string& text) {
    const auto comma = text.find(',');
    if (comma == std::string::npos) {
        return std::nullopt;
    }
    const auto pan = number_in(text.substr(0, comma));
    const auto tilt = number_in(text.substr(comma + 1));
    return pan && tilt ? std::optional(HeadAngles{rad_from_deg(*pan), rad_from_deg(*tilt)})
                       : std::nullopt;
}

// What is to be done, or nothing where the action and its value do not go together.
std::optional<Result<Done>> act(PanTiltCamera& head, const PanTiltOptions& options) {
    const std::string& action = options.action;
    const auto number = number_in(options.value);
    const auto angles = angles_in(options.value);
    if (action == "move" && angles) {
        return head.move_by_hand(*angles);
    }
    if (action == "drive" && angles) {
        return head.drive(angles->pan_rad, angles->tilt_rad);
    }
    if (action == "zoom" && number) {
        return head.zoom_to(*number);
    }
    if (action == "focus" && options.value == "auto") {
        return head.autofocus();
    }
    if (action == "focus" && number) {
        return head.focus_to(*number);
    }
    if (action == "keep" && number) {
        return head.keep_preset(static_cast<int>(*number));
    }
    if (action == "recall" && number) {
        return head.recall_preset(static_cast<int>(*number));
    }
    if (!options.value.empty()) {
        return std::nullopt;
    }
    if (action == "halt") {
        return head.halt();
    }
    if (action == "home") {
        return head.home();
    }
    if (action == "reset") {
        return head.reset();
    }
    return action == "position" ? std::optional(Result<Done>(Done{})) : std::nullopt;
}

// Until neither angles nor zoom have changed for a while.
Result<Done> wait_until_at_rest(PanTiltCamera& head, std::chrono::milliseconds rest) {
    using Clock = std::chrono::steady_clock;
    const auto began = Clock::now();
    auto changed = began;
    HeadAngles last;
    double last_zoom = 0.0;
    while (Clock::now() - changed < rest && !interrupted()) {
        std::this_thread::sleep_for(look_interval);
        const auto status = head.status();
        if (!status) {
            return status.error();
        }
        const auto lens = head.lens();
        const double zoom = lens ? lens->zoom_share : 0.0;
        if (status->moving || status->angles != last || zoom != last_zoom) {
            changed = Clock::now();
        }
        last = status->angles;
        last_zoom = zoom;
        if (Clock::now() - began > longest_motion) {
            return Error{"The head has not come to rest for half a minute.", "Halt it."};
        }
    }
    return Done{};
}

// What was asked for stands only where the head says so: a question that was lost leaves an old
// answer.
Result<Done> check_lens(PanTiltCamera& head, const PanTiltOptions& options) {
    const auto wanted = number_in(options.value);
    const bool zoom = options.action == "zoom";
    if (!wanted || (!zoom && options.action != "focus")) {
        return Done{};
    }
    const auto lens = head.lens();
    if (!lens) {
        return lens.error();
    }
    const double told = zoom ? lens->zoom_share : lens->focus_share;
    if (std::abs(told - *wanted) <= lens_tolerance) {
        return Done{};
    }
    char cause[160];
    std::snprintf(cause, sizeof cause, "The head was sent to %s %.3f and tells %.3f.",
                  options.action.c_str(), *wanted, told);
    return Error{cause, "Ask again (pan-tilt position); if it stays so, check the line."};
}

void wait_for(double seconds) {
    const auto until = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
    while (std::chrono::steady_clock::now() < until && !interrupted()) {
        std::this_thread::sleep_for(look_interval);
    }
}

std::string summary_of(const nlohmann::json& told) {
    char text[160];
    std::snprintf(text, sizeof text, "%s: pan %+.2f deg, tilt %+.2f deg%s",
                  told["name"].get<std::string>().c_str(), told["pan_deg"].get<double>(),
                  told["tilt_deg"].get<double>(), told["moving"].get<bool>() ? ", moving" : "");
    std::string summary = text;
    if (told.contains("zoom_share")) {
        std::snprintf(text, sizeof text, ", zoom %.3f (%.1f deg wide)",
                      told["zoom_share"].get<double>(), told["horizontal_view_deg"].get<double>());
        summary += text;
    }
    return summary + "\n";
}

}  // namespace

Outcome run_pan_tilt(const PanTiltOptions& options) {
    SteadyClock clock;
    const auto opened = open_head(options.device, clock);
    if (!opened) {
        return Outcome{opened.error()};
    }
    PanTiltCamera& head = **opened;
    const auto done = act(head, options);
    if (!done) {
        Outcome outcome{
            Error{"pan-tilt " + options.action +
                      (options.value.empty() ? "" : " " + options.value) + " is not understood.",
                  "Say position, move PAN,TILT, drive PAN,TILT, halt, home, reset, zoom "
                  "SHARE, focus SHARE, focus auto, keep N or recall N."}};
        outcome.wrong_usage = true;
        return outcome;
    }
    if (!*done) {
        return Outcome{done->error()};
    }
    const auto lens_until = std::chrono::steady_clock::now() + lens_patience;
    while (!head.lens() && std::chrono::steady_clock::now() < lens_until) {
        std::this_thread::sleep_for(look_interval);
    }
    const bool drives = options.action == "drive";
    if (drives && options.seconds) {
        wait_for(*options.seconds);
        if (const auto halted = head.halt(); !halted) {
            return Outcome{halted.error()};
        }
    }
    if ((!drives || options.seconds) && options.action != "position") {
        const bool lens =
            options.action == "zoom" || options.action == "focus" || options.action == "recall";
        if (const auto rests = wait_until_at_rest(head, lens ? lens_at_rest_for : at_rest_for);
            !rests) {
            return Outcome{rests.error()};
        }
    }
    if (const auto lens = check_lens(head, options); !lens) {
        return Outcome{lens.error()};
    }
    const auto status = head.status();
    if (!status) {
        return Outcome{status.error()};
    }
    for (const HeadNote& note : head.take_notes()) {
        if (note.kind != HeadNote::Kind::note) {
            std::fprintf(stderr, "%s\n", note.text.c_str());
        }
    }
    nlohmann::json told{{"name", head.name()},
                        {"pan_deg", deg_from_rad(status->angles.pan_rad)},
                        {"tilt_deg", deg_from_rad(status->angles.tilt_rad)},
                        {"moving", status->moving}};
    if (const auto lens = head.lens()) {
        told["zoom_share"] = lens->zoom_share;
        told["horizontal_view_deg"] = deg_from_rad(lens->horizontal_view_rad);
        told["autofocus"] = lens->autofocus;
        told["focus_share"] = lens->focus_share;
    }
    std::string summary = summary_of(told);
    if (drives && !options.seconds) {
        summary += "It turns on until it is halted (pan-tilt halt) or at its end.\n";
    }
    return Outcome{std::nullopt, told.dump(2), summary};
}

}  // namespace kambara::cli
