// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/calibrate_zoom_command.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "app/cli/named_table.h"
#include "core/calibration/zoom_calibration.h"
#include "core/camera/rig_file.h"
#include "core/devices/head_state.h"
#include "hardware/media/picture_file.h"
#include "hardware/visca/measured_zoom.h"

namespace kambara::cli {
namespace {

Result<std::vector<ZoomView>> views_in(const std::filesystem::path& file) {
    const auto table = read_named_table(file, {"pan_tilt", "zoom_share"});
    if (!table) {
        return table.error();
    }
    std::vector<ZoomView> views;
    for (const NamedRow& row : table->rows) {
        const auto share = row.number("zoom_share");
        if (!share || !(*share >= 0.0 && *share <= 1.0)) {
            return Error{"Line " + std::to_string(row.line) + " of " + file.string() +
                             ": zoom_share is no number from 0 to 1.",
                         "Write what pan-tilt position tells: 0 wide, 1 tele."};
        }
        auto picture = read_picture(file.parent_path() / row.cells.at("pan_tilt"));
        if (!picture) {
            return picture.error();
        }
        views.push_back({*share, std::make_shared<const Image>(grey_from(*picture))});
    }
    return views;
}

Result<std::optional<visca::WidestLens>> widest_in(const std::string& text) {
    if (text.empty()) {
        return std::optional<visca::WidestLens>();
    }
    visca::WidestLens lens;
    const auto comma = text.find(',');
    const auto number = [&](std::size_t from, std::size_t to, double& value) {
        const auto [end, fault] = std::from_chars(text.data() + from, text.data() + to, value);
        return fault == std::errc() && end == text.data() + to && value > 0.0;
    };
    if (comma == std::string::npos || !number(0, comma, lens.f_mm) ||
        !number(comma + 1, text.size(), lens.sensor_width_mm)) {
        return Error{"--widest \"" + text + "\" is no focal length and width.",
                     "Write both in mm, for example 5.4,4.9."};
    }
    return std::optional(lens);
}

// Of the lens as the table has it; empty where it does not know it.
std::optional<double> table_magnification(const visca::HeadKind& kind, double share) {
    LensStatus lens;
    lens.widest_view_rad = kind.zoom.horizontal_view_rad(0.0);
    lens.horizontal_view_rad = kind.zoom.horizontal_view_rad(std::round(share * kind.zoom.tele));
    return lens.horizontal_view_rad > 0.0 ? std::optional(lens.magnification()) : std::nullopt;
}

}  // namespace

Outcome run_calibrate_zoom(const CalibrateZoomOptions& options) {
    const auto widest = widest_in(options.widest);
    if (!widest) {
        Outcome outcome{widest.error()};
        outcome.wrong_usage = true;
        return outcome;
    }
    const auto rig = read_rig_file(options.rig);
    if (!rig) {
        return Outcome{rig.error()};
    }
    if (!rig->pan_tilt) {
        return Outcome{Error{"The rig file holds no pan-tilt camera.",
                             "Calibrate it first, at its widest: calibrate --pan-tilt."}};
    }
    auto heads = options.heads.empty()
                     ? Result<std::vector<visca::HeadKind>>(visca::built_in_heads())
                     : visca::read_heads_file(options.heads);
    if (!heads) {
        return Outcome{heads.error()};
    }
    const auto kind = std::find_if(heads->begin(), heads->end(), [&](const visca::HeadKind& one) {
        return one.name == options.head;
    });
    if (kind == heads->end()) {
        std::string names;
        for (const visca::HeadKind& one : *heads) {
            names += (names.empty() ? "" : ", ") + one.name;
        }
        return Outcome{Error{"There is no head \"" + options.head + "\" in the table.",
                             "Choose " + names + "."}};
    }
    auto views = views_in(options.views);
    if (!views) {
        return Outcome{views.error()};
    }
    const auto places = calibrate_zoom(*rig->pan_tilt, std::move(*views));
    if (!places) {
        return Outcome{places.error()};
    }
    std::vector<std::pair<double, double>> curve;
    nlohmann::json told = nlohmann::json::array();
    std::string summary = "  zoom  magnification    sigma   the table's  points   RMS\n";
    double worst_pct = -1.0;
    for (const ZoomPlace& place : *places) {
        curve.emplace_back(place.zoom_share, place.magnification);
        const auto by_table = table_magnification(*kind, place.zoom_share);
        told.push_back({{"zoom_share", place.zoom_share},
                        {"magnification", place.magnification},
                        {"magnification_sigma", place.magnification_sigma},
                        {"table_magnification", nullptr},
                        {"points", place.points},
                        {"rms_px", place.rms_px}});
        char text[120];
        std::snprintf(text, sizeof text, "%6.3f  %13.4f  %7.4f", place.zoom_share,
                      place.magnification, place.magnification_sigma);
        summary += text;
        if (by_table) {
            told.back()["table_magnification"] = *by_table;
            worst_pct =
                std::max(worst_pct, 100.0 * std::abs(*by_table / place.magnification - 1.0));
            std::snprintf(text, sizeof text, "  %12.4f", *by_table);
        } else {
            std::snprintf(text, sizeof text, "  %12s", "not known");
        }
        summary += text;
        std::snprintf(text, sizeof text, "  %6d  %.3f px\n", place.points, place.rms_px);
        summary += place.points > 0 ? text : "\n";
    }
    const auto measured = visca::with_measured_zoom(*kind, curve, *widest);
    if (!measured) {
        return Outcome{measured.error()};
    }
    *kind = *measured;
    if (const auto written = visca::write_heads_file(options.out, *heads); !written) {
        return Outcome{written.error()};
    }
    nlohmann::json json{{"head", options.head},
                        {"worst_table_error_pct", nullptr},
                        {"places", std::move(told)},
                        {"out", options.out.string()}};
    char text[160] = "";
    if (worst_pct >= 0.0) {
        json["worst_table_error_pct"] = worst_pct;
        std::snprintf(text, sizeof text, "The table was off by %.2f %% at most.\n", worst_pct);
    }
    summary += text;
    summary += "Name the file in the head's URI to use it: heads=" + options.out.string() + "\n";
    return Outcome{std::nullopt, json.dump(2), summary};
}

}  // namespace kambara::cli
