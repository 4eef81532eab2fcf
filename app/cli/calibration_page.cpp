// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/calibration_page.h"

#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>

#include "core/report/html_report.h"

namespace kambara::cli {
namespace {

using Json = nlohmann::json;

std::string number(double value, const char* format = "%.4g") {
    char text[48];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

std::string fixed(const Json& value, int decimals) {
    char text[48];
    std::snprintf(text, sizeof text, "%.*f", decimals, value.get<double>());
    return text;
}

void add_verdict(HtmlReport& page, const Json& json) {
    page.heading("Verdict: " + json["verdict"].get<std::string>());
    for (const Json& reason : json["reasons"]) {
        page.paragraph(reason.get<std::string>());
    }
    for (const Json& note : json["notes"]) {
        page.paragraph(note.get<std::string>());
    }
    page.table({"", ""},
               {{"views used", std::to_string(json["views_used"].get<int>())},
                {"corners used", std::to_string(json["corners_used"].get<int>()) + " of " +
                                     std::to_string(json["corners_total"].get<int>())},
                {"residuals", fixed(json["rms_px"], 3) + " px"}});
    std::vector<std::vector<std::string>> rows;
    for (const Json& view : json["views_rejected"]) {
        rows.push_back({view["file"].get<std::string>(), view["reason"].get<std::string>()});
    }
    if (!rows.empty()) {
        page.heading("Pictures left out");
        page.table({"picture", "why"}, rows);
    }
}

void add_camera(HtmlReport& page, const std::string& name, std::size_t place, const Json& camera,
                const CalibrationReport& report) {
    page.heading("Camera: " + name);
    std::vector<std::vector<std::string>> rows;
    for (const auto& [key, sigma] : camera["sigma"].items()) {
        rows.push_back(
            {key, number(camera[key].get<double>(), "%.7g"), number(sigma.get<double>(), "%.2g")});
    }
    page.table({"parameter", "value", "1 sigma"}, rows);
    page.paragraph("Residuals " + fixed(camera["rms_px"], 3) + " px over " +
                   std::to_string(camera["corners_used"].get<int>()) + " corners in " +
                   std::to_string(camera["views_used"].get<int>()) +
                   " views; what hangs together over the picture " +
                   fixed(camera["systematic_px"], 3) + " px. Corners were seen in " +
                   number(100.0 * camera["picture_share"].get<double>(), "%.0f") +
                   " % of the picture's fields.");
    const Camera& lens = report.cameras[place]->camera;
    std::vector<HtmlReport::Arrow> arrows;
    std::map<int, std::pair<double, int>> views;
    for (const Residual& r : report.residuals) {
        if (r.camera != static_cast<int>(place)) {
            continue;
        }
        arrows.push_back({r.px.x(), r.px.y(), r.residual_px.x(), r.residual_px.y(), !r.used});
        if (r.used) {
            views[r.view].first += r.residual_px.squaredNorm();
            ++views[r.view].second;
        }
    }
    page.picture_arrows("Residuals, 100 times as long as they are", lens.width_px, lens.height_px,
                        100.0, arrows);
    std::vector<HtmlReport::Bar> bars;
    bars.reserve(views.size());
    for (const auto& [view, sum] : views) {
        bars.push_back({"view " + std::to_string(view + 1), std::sqrt(sum.first / sum.second)});
    }
    page.bars("Residuals view by view", "px", bars, 3);
}

void add_checks(HtmlReport& page, const Json& json) {
    page.heading("Checks");
    std::vector<std::vector<std::string>> rows{
        {"depth of the corners", fixed(json["depth"]["nearest_mm"], 0) + " to " +
                                     fixed(json["depth"]["farthest_mm"], 0) + " mm"}};
    if (json.contains("held_out")) {
        const Json& check = json["held_out"];
        rows.push_back({"lengths in views that took no part",
                        fixed(check["mean_error_mm"], 3) + " mm off in the mean, " +
                            fixed(check["largest_error_mm"], 3) + " mm at most"});
        rows.push_back(
            {"size of the target in them", fixed(check["scale_error_percent"], 3) + " % off"});
    }
    if (json.contains("baseline_check")) {
        const Json& check = json["baseline_check"];
        rows.push_back({"baseline by tape", fixed(check["measured_mm"], 2) + " +- " +
                                                fixed(check["measured_sigma_mm"], 2) + " mm"});
        rows.push_back({"by the pictures alone", fixed(check["found_mm"], 2) + " +- " +
                                                     fixed(check["found_sigma_mm"], 2) + " mm"});
    }
    page.table({"check", ""}, rows);
    if (!json.contains("pairs")) {
        return;
    }
    rows.clear();
    for (const auto& [name, pair] : json["pairs"].items()) {
        rows.push_back({name, fixed(pair["baseline_mm"], 3), fixed(pair["baseline_sigma_mm"], 3),
                        fixed(pair["T_mm"][0], 2), fixed(pair["T_mm"][1], 2),
                        fixed(pair["T_mm"][2], 2)});
    }
    page.heading("Between the cameras");
    page.table({"pair", "distance mm", "1 sigma mm", "T x mm", "T y mm", "T z mm"}, rows);
}

void add_range(HtmlReport& page, const Json& range) {
    page.heading("How far ranges are open");
    page.paragraph(
        "One standard deviation in percent of the range, from what the calibration "
        "leaves open; in brackets with the noise of one measurement (" +
        fixed(range["noise_px"], 3) + " px) in the pictures. Mean " +
        fixed(range["mean_percent"], 3) + " %, at worst " + fixed(range["worst_percent"], 3) +
        " %, with noise in the mean " + fixed(range["mean_with_noise_percent"], 3) + " %.");
    std::map<double, std::map<double, std::string>> cells;
    std::vector<std::string> header{"depth mm"};
    std::map<double, bool> azimuths;
    for (const Json& p : range["points"]) {
        if (p["height_mm"].get<double>() == 0.0) {
            const double mm = p["range_mm"].get<double>();
            const double azimuth = p["azimuth_deg"].get<double>();
            azimuths[azimuth] = true;
            cells[p["depth_mm"].get<double>()][azimuth] =
                number(100.0 * p["sigma_calibration_mm"].get<double>() / mm, "%.3f") + " (" +
                number(100.0 * p["sigma_total_mm"].get<double>() / mm, "%.3f") + ")";
        }
    }
    for (const auto& [azimuth, there] : azimuths) {
        header.push_back(number(azimuth, "%.0f") + " deg");
    }
    std::vector<std::vector<std::string>> rows;
    for (const auto& [depth, row] : cells) {
        std::vector<std::string> texts{number(depth, "%.0f")};
        for (const auto& [azimuth, there] : azimuths) {
            const auto cell = row.find(azimuth);
            texts.push_back(cell == row.end() ? "-" : cell->second);
        }
        rows.push_back(texts);
    }
    page.shaded_table(header, rows);
}

std::string fate_of(const Shot& shot, const SessionPart& session, const CalibrationReport& report) {
    if (!shot.kept) {
        return "dropped by hand";
    }
    std::string fate = "used";
    for (const RejectedView& view : report.views_rejected) {
        if (session.numbers.at(static_cast<std::size_t>(view.view)) == shot.number) {
            fate = "left out: " + (view.camera.empty() ? "" : view.camera + ": ") + view.reason;
        }
    }
    return fate;
}

void add_session(HtmlReport& page, const SessionPart& session, const CalibrationReport& report) {
    page.heading("Shots");
    std::vector<std::vector<std::string>> rows;
    std::size_t pose = 0;
    const bool all_told = session.coverage.poses.size() == session.numbers.size();
    for (const Shot& shot : session.shots) {
        std::vector<std::string> row{"shot " + std::to_string(shot.number)};
        if (shot.kept && all_told) {
            const HeldPose& held = session.coverage.poses[pose++];
            row.insert(row.end(), {number(held.depth_mm, "%.0f"), number(held.turn_deg, "%.0f"),
                                   number(held.tilt_deg, "%.0f"), number(held.roll_deg, "%.0f")});
        } else {
            row.insert(row.end(), 4, "-");
        }
        row.push_back(fate_of(shot, session, report));
        rows.push_back(std::move(row));
    }
    page.table({"", "depth mm", "turn deg", "tilt deg", "roll deg", ""}, rows);
    page.heading("Coverage");
    page.paragraph("Depths " + number(session.coverage.nearest_mm, "%.0f") + " to " +
                   number(session.coverage.farthest_mm, "%.0f") + " mm, slant up to " +
                   number(session.coverage.widest_slant_deg, "%.0f") +
                   " degrees. In how many shots a corner lies in each field of the picture:");
    for (std::size_t c = 0; c < most_cameras; ++c) {
        if (!session.setup.cameras[c]) {
            continue;
        }
        const PictureCoverage& picture = session.coverage.pictures[c];
        std::vector<std::string> header{camera_names[c]};
        std::vector<std::vector<std::string>> fields;
        for (int x = 0; x < PictureCoverage::across; ++x) {
            header.push_back(std::to_string(x + 1));
        }
        for (int y = 0; y < PictureCoverage::down; ++y) {
            std::vector<std::string> row{"row " + std::to_string(y + 1)};
            for (int x = 0; x < PictureCoverage::across; ++x) {
                row.push_back(std::to_string(
                    picture.views[static_cast<std::size_t>(y) * PictureCoverage::across +
                                  static_cast<std::size_t>(x)]));
            }
            fields.push_back(std::move(row));
        }
        page.shaded_table(header, fields);
    }
}

}  // namespace

std::string calibration_page(const Json& json, const CalibrationReport& report,
                             const std::string& settings, const SessionPart* session) {
    HtmlReport page("Calibration");
    page.paragraph(settings);
    add_verdict(page, json);
    if (json.contains("cameras")) {
        for (std::size_t c = 0; c < most_cameras; ++c) {
            if (report.cameras[c]) {
                add_camera(page, camera_names[c], c, json["cameras"][camera_names[c]], report);
            }
        }
        add_checks(page, json);
    }
    if (json.contains("range_error") && !report.range_errors.empty()) {
        add_range(page, json["range_error"]);
    }
    if (session != nullptr) {
        add_session(page, *session, report);
    }
    return page.text();
}

}  // namespace kambara::cli
