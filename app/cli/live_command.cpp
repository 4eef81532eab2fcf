// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/live_command.h"

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <thread>

#include "app/cli/terminal.h"
#include "app/cli/truth_comparison.h"
#include "app/sources/sources.h"
#include "core/base/angles.h"
#include "core/base/latest_value.h"
#include "hardware/simulated/simulated_world.h"

namespace kambara::cli {
namespace {

constexpr std::chrono::milliseconds refresh_on_terminal{100};
constexpr std::chrono::milliseconds refresh_in_file{1000};

struct Shown {
    SnapshotPtr snapshot;
    TruthSample truth;
};

std::string format(const char* pattern, auto... values) {
    char text[320];
    std::snprintf(text, sizeof text, pattern, values...);
    return text;
}

std::string header() {
    return "  time s  state        measured x, y, z mm (1 sigma)                      true x, y, z "
           "mm          range err  head pan, tilt  off     rate\n";
}

std::string row(const Shown& shown) {
    const Snapshot& snapshot = *shown.snapshot;
    const TrackEstimate estimate = steered_estimate(snapshot);
    std::string text = format("%8.2f  %-11s  ", static_cast<double>(snapshot.time_ns) * 1e-9,
                              to_string(estimate.state).c_str());
    if (estimate.position) {
        const Eigen::Vector3d& p = estimate.position->point_in_left_mm;
        const Eigen::Vector3d s = estimate.position->covariance_mm2.diagonal().cwiseSqrt();
        text += format("%8.1f %8.1f %8.1f (%4.1f %4.1f %5.1f)", p.x(), p.y(), p.z(), s.x(), s.y(),
                       s.z());
        if (const auto& c = estimate.position->calibration_covariance_mm2) {
            text += format(" calibration (%4.1f %4.1f %5.1f)", std::sqrt((*c)(0, 0)),
                           std::sqrt((*c)(1, 1)), std::sqrt((*c)(2, 2)));
        }
    } else {
        text += format("%-46s", ("no position: " + estimate.reason).substr(0, 46).c_str());
    }
    const Eigen::Vector3d& t = shown.truth.point_in_left_mm;
    text += format("  %8.1f %8.1f %8.1f  ", t.x(), t.y(), t.z());
    text += std::isfinite(shown.truth.range_error_pct)
                ? format("%+8.3f %%  ", shown.truth.range_error_pct)
                : format("%10s  ", "-");
    if (snapshot.head) {
        text += format("%+6.1f %+6.1f deg  %4.2f deg", deg_from_rad(snapshot.head->angles.pan_rad),
                       deg_from_rad(snapshot.head->angles.tilt_rad), shown.truth.head_error_deg);
    }
    return text + format("  %4.1f Hz", snapshot.rate_hz);
}

nlohmann::json json_of(const TruthSummary& truth, std::uint64_t frames_lost) {
    return {{"frames", truth.frames},
            {"frames_lost", frames_lost},
            {"tracked_fraction", truth.tracked_fraction},
            {"range_error_mean_pct", truth.range_error_mean_pct},
            {"range_error_worst_pct", truth.range_error_worst_pct},
            {"head_within_1_deg_fraction", truth.head_within_1_deg_fraction}};
}

// Draws at an even pace until the time is over; on a terminal in one place, else line by line.
void show_until_over(LatestValue<Shown>& newest, std::optional<double> seconds) {
    const bool terminal = output_is_terminal();
    std::fputs(header().c_str(), stdout);
    const auto started = std::chrono::steady_clock::now();
    while (!interrupted()) {
        std::this_thread::sleep_for(terminal ? refresh_on_terminal : refresh_in_file);
        if (const auto shown = newest.try_take()) {
            std::printf(terminal ? "\r\033[K%s" : "%s\n", row(*shown).c_str());
            std::fflush(stdout);
        }
        const std::chrono::duration<double> so_far = std::chrono::steady_clock::now() - started;
        if (seconds && so_far.count() >= *seconds) {
            break;
        }
    }
    if (terminal) {
        std::fputs("\n", stdout);
    }
}

Result<Outcome> live(const LiveOptions& options) {
    SteadyClock clock;
    SourceOptions source;
    source.left = "sim:" + options.profile;
    source.pan_tilt = options.pan_tilt;
    source.live = true;
    source.pan_tilt_pictures = options.servo;
    auto sources = open_sources(source, clock);
    if (!sources) {
        return sources.error();
    }
    const auto world = sources->world;
    VisionSystemOptions system_options;
    system_options.every_frame = false;
    auto opened = open_vision_system(std::move(sources->parts), system_options, clock);
    if (!opened) {
        return opened.error();
    }
    VsystemInterface& system = **opened;
    // The target stands where the truth puts it in the newest picture: the part of the operator.
    const std::int64_t frame = system.latest()->frame;
    const Rectangle rectangle = world->suggested_template(31, frame);
    TruthComparison truth(world, {rectangle.centre_x_px(), rectangle.centre_y_px()}, frame);
    if (const auto done = system.execute(SelectTemplate{rectangle, frame}); !done) {
        return done.error();
    }
    if (const auto done = system.execute(StartTracking{}); !done) {
        return done.error();
    }
    if (options.servo) {
        if (const auto done = system.execute(ServoHead{}); !done) {
            return done.error();
        }
    }
    LatestValue<Shown> newest;
    const auto observation = system.observe([&](const SnapshotPtr& snapshot) {
        newest.put({snapshot, truth.add(*snapshot)});
    });
    show_until_over(newest, options.seconds);
    if (const auto done = system.execute(Flow{Flow::Kind::pause}); !done) {
        return done.error();
    }
    const TruthSummary summary = truth.summary();
    return Outcome{
        std::nullopt, json_of(summary, system.latest()->frames_lost).dump(2),
        format("%lld pairs, tracked in %.1f %%; range error mean %.3f %%, worst %.3f %%; %s; "
               "%llu pairs lost.\n",
               static_cast<long long>(summary.frames), 100.0 * summary.tracked_fraction,
               summary.range_error_mean_pct, summary.range_error_worst_pct,
               head_sentence(summary.head_within_1_deg_fraction).c_str(),
               static_cast<unsigned long long>(system.latest()->frames_lost))};
}

}  // namespace

Outcome run_live(const LiveOptions& options) {
    auto outcome = live(options);
    return outcome ? *outcome : Outcome{outcome.error()};
}

}  // namespace kambara::cli
