// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/range_test_command.h"

#include <cmath>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/named_table.h"
#include "app/cli/range_test_page.h"
#include "app/cli/track_command.h"
#include "core/base/text_file.h"
#include "core/camera/nominal_rig.h"
#include "core/camera/rig_file.h"
#include "core/image/rectangle.h"
#include "core/stereo/position.h"
#include "core/stereo/range_experiment.h"
#include "hardware/simulated/simulated_world.h"
#include "hardware/simulated/station_path.h"

namespace kambara::cli {
namespace {

constexpr std::string_view simulation = "sim:";
const char* const pixel_columns[] = {"left_x_px", "left_y_px", "right_x_px", "right_y_px"};

// A known place, and the frames in which the target was there.
struct Held {
    double first_frame = 0.0;
    double last_frame = 0.0;
    Eigen::Vector3d known_mm = Eigen::Vector3d::Zero();
};

Error line_error(const std::string& file, const NamedRow& row, const std::string& what) {
    return {"Line " + std::to_string(row.line) + " of " + file + " " + what + ".",
            "Give every place its coordinates and its pixels or frames; see the range experiment "
            "in resources/README.md."};
}

Result<std::vector<Held>> held_places(const NamedTable& table, const std::string& file) {
    std::vector<Held> places;
    for (const NamedRow& row : table.rows) {
        const auto frames = row.pair("first_frame", "last_frame");
        const auto place = row.triple("x_mm", "y_mm", "z_mm");
        if (!frames || !place || frames->y() < frames->x()) {
            return line_error(file, row, "does not hold first_frame, last_frame, x_mm, y_mm, z_mm");
        }
        places.push_back({frames->x(), frames->y(), *place});
    }
    return places;
}

Result<SimulatedProfile> profile_of(const RangeTestOptions& options) {
    return simulated_profile(std::string_view(options.left).substr(simulation.size()));
}

// What the simulation itself knows of its stations.
Result<std::vector<Held>> simulated_places(const RangeTestOptions& options,
                                           const std::string& templ) {
    const auto profile = profile_of(options);
    if (!profile) {
        return profile.error();
    }
    if (profile->path != TargetPath::stations) {
        return Error{"The simulated profile " + profile->name + " has no known places.",
                     "Give --left sim:stations, or the places with --known."};
    }
    const SimulatedWorld world(*profile);
    const auto rectangle = parse_rectangle(templ);
    if (!rectangle) {
        return rectangle.error();
    }
    const auto on_target =
        world.target_point_under({rectangle->centre_x_px(), rectangle->centre_y_px()}, 0);
    if (!on_target) {
        return Error{"The template's centre is not on the simulated target.",
                     "Leave --template out."};
    }
    std::vector<Held> places;
    const double frames = station_path::stations * station_path::station_s * profile->rate_hz;
    int last_station = -1;
    for (std::int64_t frame = 0; static_cast<double>(frame) < frames; ++frame) {
        const int station = station_path::station_at(static_cast<double>(frame) / profile->rate_hz);
        if (station >= 0 && station != last_station) {
            const auto number = static_cast<double>(frame);
            places.push_back({number, number, world.point_in_left_mm(*on_target, frame)});
        } else if (station >= 0) {
            places.back().last_frame = static_cast<double>(frame);
        }
        last_station = station;
    }
    return places;
}

Result<std::vector<RangeStation>> stations_of_track(const std::vector<Held>& places,
                                                    const std::string& track) {
    const auto positions = read_track_positions(track);
    if (!positions) {
        return positions.error();
    }
    std::vector<RangeStation> stations;
    for (const Held& place : places) {
        RangeStation station{place.known_mm, {}};
        for (const TrackedPosition& one : *positions) {
            if (one.frame >= place.first_frame && one.frame <= place.last_frame) {
                station.readings_in_left_mm.push_back(one.point_in_left_mm);
            }
        }
        if (station.readings_in_left_mm.empty()) {
            return Error{"The target was not tracked in any of the frames " +
                             std::to_string(std::lround(place.first_frame)) + " to " +
                             std::to_string(std::lround(place.last_frame)) + ".",
                         "Leave that place out of the known ones, or choose a larger template."};
        }
        stations.push_back(std::move(station));
    }
    return stations;
}

Result<std::vector<RangeStation>> stations_of_pixels(const NamedTable& table, const Rig& rig,
                                                     const std::string& file) {
    std::vector<RangeStation> stations;
    for (const NamedRow& row : table.rows) {
        const auto place = row.triple("x_mm", "y_mm", "z_mm");
        const auto left = row.pair(pixel_columns[0], pixel_columns[1]);
        const auto right = row.pair(pixel_columns[2], pixel_columns[3]);
        if (!place || !left || !right) {
            return line_error(file, row, "does not hold a place and a pixel in both pictures");
        }
        const auto position = position_from_pair(rig, {*left}, {*right});
        if (!position) {
            return line_error(file, row, "gives no position: " + position.error().cause);
        }
        stations.push_back({*place, {position->point_in_left_mm}});
    }
    return stations;
}

// Follows the target and leaves the table where `track` says.
Result<Done> follow(const RangeTestOptions& options, const std::string& templ) {
    TrackOptions track;
    track.sources.left = options.left;
    track.sources.right = options.right;
    track.sources.rig = options.rig.string();
    track.templates = {templ};
    track.csv = options.track;
    if (options.left.starts_with(simulation)) {
        track.seconds = station_path::stations * station_path::station_s;
    }
    const Outcome outcome = run_track(track);
    if (outcome.failure) {
        return *outcome.failure;
    }
    return Done{};
}

// The template's rectangle in numbers, where the simulation is to choose it.
Result<std::string> template_of(const RangeTestOptions& options) {
    if (options.templ != "auto" || !options.left.starts_with(simulation)) {
        return options.templ;
    }
    const auto profile = profile_of(options);
    if (!profile) {
        return profile.error();
    }
    return to_string(SimulatedWorld(*profile).suggested_template(31));
}

Result<std::vector<RangeStation>> measured_stations(const RangeTestOptions& options,
                                                    const Rig& rig) {
    std::optional<NamedTable> known;
    if (!options.known.empty()) {
        auto read = read_named_table(options.known, {"x_mm", "y_mm", "z_mm"});
        if (!read) {
            return read.error();
        }
        known = std::move(*read);
    }
    if (known && options.track.empty()) {
        if (!known->has({std::begin(pixel_columns), std::end(pixel_columns)})) {
            return Error{options.known +
                             " has no columns left_x_px, left_y_px, right_x_px, "
                             "right_y_px.",
                         "Add them, or name the track table whose frames it speaks of: --track."};
        }
        return stations_of_pixels(*known, rig, options.known);
    }
    const auto templ = template_of(options);
    if (!templ) {
        return templ.error();
    }
    const auto places =
        known ? held_places(*known, options.known) : simulated_places(options, *templ);
    if (!places) {
        return places.error();
    }
    if (!options.left.empty()) {
        if (const auto done = follow(options, *templ); !done) {
            return done.error();
        }
    }
    return stations_of_track(*places, options.track);
}

nlohmann::json json_of(const RangeErrors& errors) {
    return {{"mean_range_error_pct", errors.mean_range_pct},
            {"worst_range_error_pct", errors.worst_range_pct},
            {"mean_depth_error_pct", errors.mean_depth_pct},
            {"worst_depth_error_pct", errors.worst_depth_pct},
            {"mean_position_error_mm", errors.mean_position_mm},
            {"worst_position_error_mm", errors.worst_position_mm}};
}

std::string sentence(const char* when, const RangeErrors& e) {
    char line[200];
    std::snprintf(line, sizeof line,
                  "%-7s range error mean %.3f %%, worst %.3f %%; depth mean %.3f %%, worst %.3f "
                  "%%; position mean %.2f mm, worst %.2f mm\n",
                  when, e.mean_range_pct, e.worst_range_pct, e.mean_depth_pct, e.worst_depth_pct,
                  e.mean_position_mm, e.worst_position_mm);
    return line;
}

struct Judged {
    RangeExperiment experiment;
    double baseline_mm = 0.0;
};

Result<Judged> judged(const RangeTestOptions& options) {
    const bool simulated = options.left.starts_with(simulation);
    Rig rig = nominal_rig();
    if (options.rig.empty() && simulated) {
        const auto profile = profile_of(options);
        if (!profile) {
            return profile.error();
        }
        rig = nominal_rig(profile->medium);
    } else {
        auto read = read_rig_file(options.rig);
        if (!read) {
            return read.error();
        }
        rig = std::move(*read);
    }
    if (!rig.right) {
        return Error{"The rig file holds no right camera.", "Calibrate both cameras."};
    }
    auto stations = measured_stations(options, rig);
    if (!stations) {
        return stations.error();
    }
    if (options.frame == "rig") {
        for (RangeStation& station : *stations) {
            station.known_mm = rig.left.T_camera_from_rig * station.known_mm;
        }
    }
    const auto experiment = judge_ranges(
        *stations, {baseline_mm(rig), options.true_baseline_mm, options.frame == "own"});
    if (!experiment) {
        return experiment.error();
    }
    return Judged{*experiment, baseline_mm(rig)};
}

std::optional<Error> misuse(const RangeTestOptions& options) {
    if (options.known.empty() && !options.left.starts_with(simulation)) {
        return Error{"There are no known places.",
                     "Give them with --known, or --left sim:stations."};
    }
    if (!options.left.empty() && options.track.empty()) {
        return Error{"The track table has no name.", "Say with --track where it is to be written."};
    }
    if (options.rig.empty() && !options.left.starts_with(simulation)) {
        return Error{"There is no rig file.", "Name the one that measured with --rig."};
    }
    if (!options.left.empty() && !options.left.starts_with(simulation) && options.templ == "auto") {
        return Error{"Only a simulated rig can choose its template itself.",
                     "Give --template X,Y,W,H."};
    }
    return std::nullopt;
}

}  // namespace

Outcome run_range_test(const RangeTestOptions& options) {
    const auto failed = [](const Error& error) {
        return Outcome{error, nlohmann::json{{"error", error.text()}}.dump(2), ""};
    };
    if (const auto wrong = misuse(options)) {
        Outcome outcome = failed(*wrong);
        outcome.wrong_usage = true;
        return outcome;
    }
    const auto result = judged(options);
    if (!result) {
        return failed(result.error());
    }
    const RangeExperiment& experiment = result->experiment;
    if (options.csv) {
        const auto written = write_text_file_atomically(*options.csv, range_test_table(experiment));
        if (!written) {
            return failed(written.error());
        }
    }
    if (options.report) {
        const auto written = write_text_file_atomically(
            *options.report, range_test_page(experiment, result->baseline_mm));
        if (!written) {
            return failed(written.error());
        }
    }
    Outcome outcome;
    outcome.json =
        nlohmann::json{{"stations", experiment.before.stations.size()},
                       {"verdict", to_string(experiment.verdict)},
                       {"baseline_mm", result->baseline_mm},
                       {"corrected_baseline_mm", experiment.corrected_baseline_mm},
                       {"baseline_found", experiment.baseline_found},
                       {"corrected_baseline_sigma_mm", experiment.corrected_baseline_sigma_mm},
                       {"before", json_of(experiment.before)},
                       {"after", json_of(experiment.after)}}
            .dump(2);
    char line[160];
    std::snprintf(line, sizeof line, "%zu places, baseline %.2f mm, corrected %.2f mm\n",
                  experiment.before.stations.size(), result->baseline_mm,
                  experiment.corrected_baseline_mm);
    outcome.summary = line + sentence("before:", experiment.before) +
                      sentence("after:", experiment.after) + range_verdict_sentence(experiment) +
                      "\n";
    return outcome;
}

}  // namespace kambara::cli
