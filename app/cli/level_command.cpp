// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/level_command.h"

#include <cstdio>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/cli/named_table.h"
#include "core/base/angles.h"
#include "core/camera/rig_file.h"
#include "core/stereo/levelling.h"
#include "core/stereo/position.h"

namespace kambara::cli {
namespace {

Result<std::vector<Eigen::Vector3d>> listed_points(const std::string& file, const Rig& rig) {
    const auto table = read_named_table(file, {});
    if (!table) {
        return table.error();
    }
    std::vector<Eigen::Vector3d> points;
    for (const NamedRow& row : table->rows) {
        if (const auto point = row.triple("x_mm", "y_mm", "z_mm")) {
            points.push_back(*point);
            continue;
        }
        const auto left = row.pair("left_x_px", "left_y_px");
        const auto right = row.pair("right_x_px", "right_y_px");
        if (!left || !right || !rig.right) {
            return Error{"Line " + std::to_string(row.line) + " of " + file +
                             " holds no position and no pixel in both pictures.",
                         "Give columns x_mm,y_mm,z_mm, or left_x_px,left_y_px,right_x_px,"
                         "right_y_px and a rig of two cameras."};
        }
        const auto position = position_from_pair(rig, {*left}, {*right});
        if (!position) {
            return Error{"Line " + std::to_string(row.line) + " of " + file +
                             " gives no position: " + position.error().cause,
                         position.error().remedy};
        }
        points.push_back(position->point_in_left_mm);
    }
    return points;
}

Result<std::vector<Eigen::Vector3d>> points_in_rig(const LevelOptions& options, const Rig& rig) {
    std::vector<Eigen::Vector3d> points;
    if (!options.track.empty()) {
        const auto tracked = read_track_positions(options.track);
        if (!tracked) {
            return tracked.error();
        }
        for (const TrackedPosition& one : *tracked) {
            points.push_back(one.point_in_left_mm);
        }
    } else {
        auto listed = listed_points(options.points, rig);
        if (!listed) {
            return listed.error();
        }
        points = std::move(*listed);
    }
    const RigidTransform T_rig_from_left = rig.left.T_camera_from_rig.inverse();
    for (Eigen::Vector3d& point : points) {
        point = T_rig_from_left * point;
    }
    return points;
}

std::optional<Eigen::Vector3d> three_numbers(const std::string& text) {
    std::istringstream words(text);
    Eigen::Vector3d v;
    char first = 0;
    char second = 0;
    words >> v.x() >> first >> v.y() >> second >> v.z();
    return words && first == ',' && second == ',' && words.peek() == EOF ? std::optional(v)
                                                                         : std::nullopt;
}

Result<Levelling> levelled(const LevelOptions& options, Rig& rig) {
    const auto points = points_in_rig(options, rig);
    if (!points) {
        return points.error();
    }
    const Mount before = rig.mount.value_or(Mount{});
    auto levelling =
        options.by == "wall"
            ? level_from_wall(*points,
                              options.roll_deg ? rad_from_deg(*options.roll_deg) : before.roll_rad)
            : level_from_vertical(*points);
    if (!levelling) {
        return levelling.error();
    }
    const bool from_wall = options.by == "wall";
    rig = with_mount(std::move(rig), *levelling, from_wall);
    Mount& mount = *rig.mount;
    if (options.heading_deg) {
        mount.heading_rad = rad_from_deg(*options.heading_deg);
    }
    if (from_wall && options.roll_deg) {
        mount.roll_sigma_rad.reset();
    }
    if (!options.rig_in_vehicle.empty()) {
        mount.rig_in_vehicle_mm = *three_numbers(options.rig_in_vehicle);
    }
    levelling->mount = mount;
    if (options.out) {
        if (const auto written = write_rig_file(*options.out, rig); !written) {
            return written.error();
        }
    }
    return levelling;
}

std::optional<Error> misuse(const LevelOptions& options) {
    if (options.track.empty() == options.points.empty()) {
        return Error{"There must be one source of positions.",
                     "Name a track table with --track, or a list of points with --points."};
    }
    if (options.by != "vertical" && options.by != "wall") {
        return Error{"A mount can't be levelled by \"" + options.by + "\".",
                     "Give --by vertical or wall."};
    }
    if (!options.rig_in_vehicle.empty() && !three_numbers(options.rig_in_vehicle)) {
        return Error{"\"" + options.rig_in_vehicle + "\" is not a place.",
                     "Give --rig-at X,Y,Z in mm: forward, to the right, down."};
    }
    return std::nullopt;
}

}  // namespace

Outcome run_level(const LevelOptions& options) {
    const auto failed = [](const Error& error, bool wrong_usage) {
        Outcome outcome{error, nlohmann::json{{"error", error.text()}}.dump(2), ""};
        outcome.wrong_usage = wrong_usage;
        return outcome;
    };
    if (const auto wrong = misuse(options)) {
        return failed(*wrong, true);
    }
    auto rig = read_rig_file(options.rig);
    if (!rig) {
        return failed(rig.error(), false);
    }
    const auto levelling = levelled(options, *rig);
    if (!levelling) {
        return failed(levelling.error(), false);
    }
    const Mount& mount = levelling->mount;
    const double pitch_sigma_deg = deg_from_rad(mount.pitch_sigma_rad.value_or(0.0));
    nlohmann::json json{{"pitch_deg", deg_from_rad(mount.pitch_rad)},
                        {"pitch_sigma_deg", pitch_sigma_deg},
                        {"roll_deg", deg_from_rad(mount.roll_rad)},
                        {"roll_sigma_deg", nullptr},
                        {"points_used", levelling->points_used},
                        {"points_left_out", levelling->points_left_out},
                        {"rms_mm", levelling->rms_mm},
                        {"extent_mm", levelling->extent_mm}};
    if (mount.roll_sigma_rad) {
        json["roll_sigma_deg"] = deg_from_rad(*mount.roll_sigma_rad);
    }
    char line[320];
    std::snprintf(line, sizeof line,
                  "The rig looks %.3f degrees down (deviation %.3f), its right side hangs %.3f "
                  "degrees down%s.\n%d points over %.0f mm, %d left out; %.2f mm RMS off the %s.\n",
                  deg_from_rad(mount.pitch_rad), pitch_sigma_deg, deg_from_rad(mount.roll_rad),
                  options.by == "wall" ? " as was given" : "", levelling->points_used,
                  levelling->extent_mm, levelling->points_left_out, levelling->rms_mm,
                  options.by == "wall" ? "plane" : "line");
    Outcome outcome;
    outcome.json = json.dump(2);
    outcome.summary = line;
    return outcome;
}

}  // namespace kambara::cli
