// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/range_test_page.h"

#include <cmath>
#include <cstdio>
#include <functional>
#include <map>

#include "core/report/html_report.h"

namespace kambara::cli {
namespace {

using Coordinate = std::function<double(const StationError&)>;

std::string number(double value, int decimals) {
    char text[64];
    std::snprintf(text, sizeof text, "%.*f", decimals, value);
    return text;
}

HtmlReport::Series errors_against(const char* label, const RangeErrors& errors,
                                  const Coordinate& coordinate) {
    HtmlReport::Series series{label, {}};
    for (const StationError& one : errors.stations) {
        series.points.push_back({coordinate(one), one.range_error_pct});
    }
    return series;
}

// Heights within 50 mm of each other are one level, as the target's stand stood.
std::map<long, std::vector<std::size_t>> levels_of(const RangeErrors& errors) {
    std::map<long, std::vector<std::size_t>> levels;
    for (std::size_t i = 0; i < errors.stations.size(); ++i) {
        levels[std::lround(errors.stations[i].known_in_left_mm.y() / 50.0)].push_back(i);
    }
    return levels;
}

void add_estimates(HtmlReport& page, const RangeErrors& errors, const std::string& when,
                   const std::string& title, const std::vector<std::size_t>& stations) {
    HtmlReport::Series known{"known", {}};
    HtmlReport::Series measured{"measured, " + when, {}};
    for (const std::size_t i : stations) {
        const StationError& one = errors.stations[i];
        known.points.push_back({one.known_in_left_mm.x(), one.known_in_left_mm.z()});
        measured.points.push_back({one.measured_in_left_mm.x(), one.measured_in_left_mm.z()});
    }
    page.scatter(title, "side x, mm", "depth z, mm", {known, measured});
}

std::vector<std::string> summary_row(const char* when, double baseline_mm,
                                     const RangeErrors& errors) {
    return {when,
            number(baseline_mm, 2),
            number(errors.mean_range_pct, 3),
            number(errors.worst_range_pct, 3),
            number(errors.mean_depth_pct, 3),
            number(errors.worst_depth_pct, 3),
            number(errors.mean_position_mm, 2),
            number(errors.worst_position_mm, 2)};
}

}  // namespace

std::string range_verdict_sentence(const RangeExperiment& experiment) {
    const std::string bar = " (1999 reached " + number(mean_range_error_1999_pct, 2) +
                            " % in the mean, " + number(worst_range_error_1999_pct, 2) +
                            " % at worst)";
    std::string moved;
    for (std::size_t i = 0; i < experiment.before.stations.size(); ++i) {
        if (!experiment.before.stations[i].steady) {
            moved += (moved.empty() ? "" : ", ") + std::to_string(i + 1);
        }
    }
    switch (experiment.verdict) {
        case RangeVerdict::good:
            return "Good without any correction" + bar + ".";
        case RangeVerdict::good_corrected:
            return "Good after the correction of the baseline" + bar + ".";
        case RangeVerdict::not_good:
            return "Not good, even after the correction" + bar + ".";
        case RangeVerdict::moved:
            return "No verdict: the readings lie apart as if the target had moved while it was "
                   "measured (place " +
                   moved + "). Measure there again.";
        case RangeVerdict::too_few_places:
            break;
    }
    return "Not good without a correction" + bar +
           ", and a baseline that is fitted to fewer than " +
           std::to_string(least_stations_to_correct) +
           " places proves nothing: no verdict on the correction.";
}

std::string range_test_table(const RangeExperiment& experiment) {
    std::string table =
        "station,known_x_mm,known_y_mm,known_z_mm,measured_x_mm,measured_y_mm,measured_z_mm,"
        "scatter_mm,spread_mm,range_error_pct,depth_error_pct,position_error_mm,corrected_x_mm,"
        "corrected_y_mm,corrected_z_mm,corrected_range_error_pct,corrected_depth_error_pct,"
        "corrected_position_error_mm\n";
    for (std::size_t i = 0; i < experiment.before.stations.size(); ++i) {
        const StationError& before = experiment.before.stations[i];
        const StationError& after = experiment.after.stations[i];
        const Eigen::Vector3d& k = before.known_in_left_mm;
        const Eigen::Vector3d& m = before.measured_in_left_mm;
        const Eigen::Vector3d& c = after.measured_in_left_mm;
        table += std::to_string(i + 1);
        for (const double value :
             {k.x(), k.y(), k.z(), m.x(), m.y(), m.z(), before.scatter_mm, before.spread_mm,
              before.range_error_pct, before.depth_error_pct, before.position_error_mm, c.x(),
              c.y(), c.z(), after.range_error_pct, after.depth_error_pct,
              after.position_error_mm}) {
            table += "," + number(value, 4);
        }
        table += "\n";
    }
    return table;
}

std::string range_test_page(const RangeExperiment& experiment, double baseline_mm) {
    HtmlReport page("Range experiment");
    page.paragraph(
        std::to_string(experiment.before.stations.size()) +
        " known places against the positions measured there, in the left camera's frame "
        "(x to the right, y down, z forward), before and after a correction of the "
        "baseline. Errors are positive where the target was measured too far away; means "
        "are of their amounts.");
    page.table({"", "baseline mm", "range, mean %", "worst %", "depth, mean %", "worst %",
                "position, mean mm", "worst mm"},
               {summary_row("before", baseline_mm, experiment.before),
                summary_row("after", experiment.corrected_baseline_mm, experiment.after)});
    page.paragraph(range_verdict_sentence(experiment));
    if (!experiment.baseline_found) {
        page.paragraph("The corrected baseline was measured by other means.");
    } else if (experiment.before.stations.size() == 1) {
        page.paragraph("The corrected baseline rests on one place alone.");
    } else {
        page.paragraph(
            "The corrected baseline is the one that suits these places best, with a "
            "deviation of " +
            number(experiment.corrected_baseline_sigma_mm, 3) +
            " mm: what is left after it says nothing of scale.");
    }
    page.heading("Estimates, level by level");
    std::vector<std::size_t> all;
    for (const auto& [level, stations] : levels_of(experiment.before)) {
        double height = 0.0;
        for (const std::size_t i : stations) {
            height += experiment.before.stations[i].known_in_left_mm.y() /
                      static_cast<double>(stations.size());
            all.push_back(i);
        }
        add_estimates(page, experiment.before, "before", "Height y = " + number(height, 0) + " mm",
                      stations);
    }
    add_estimates(page, experiment.after, "corrected", "All levels, corrected baseline", all);
    page.heading("Range error");
    const std::pair<const char*, Coordinate> coordinates[] = {
        {"depth z", [](const StationError& one) { return one.known_in_left_mm.z(); }},
        {"height y", [](const StationError& one) { return one.known_in_left_mm.y(); }},
        {"side x", [](const StationError& one) { return one.known_in_left_mm.x(); }}};
    for (const auto& [name, coordinate] : coordinates) {
        page.scatter(std::string("Range error against ") + name, std::string(name) + ", mm",
                     "error, %",
                     {errors_against("before", experiment.before, coordinate),
                      errors_against("after", experiment.after, coordinate)});
    }
    page.heading("Every place");
    std::vector<std::vector<std::string>> rows;
    for (std::size_t i = 0; i < experiment.before.stations.size(); ++i) {
        const StationError& before = experiment.before.stations[i];
        const StationError& after = experiment.after.stations[i];
        std::vector<std::string> row{std::to_string(i + 1)};
        for (int axis = 0; axis < 3; ++axis) {
            row.push_back(number(before.known_in_left_mm[axis], 1));
        }
        for (int axis = 0; axis < 3; ++axis) {
            row.push_back(number(before.measured_in_left_mm[axis], 1));
        }
        row.push_back(number(before.scatter_mm, 2));
        row.push_back(number(before.spread_mm, 2) + (before.steady ? "" : " (moved?)"));
        row.push_back(number(before.range_error_pct, 3));
        row.push_back(number(after.range_error_pct, 3));
        row.push_back(number(after.position_error_mm, 2));
        rows.push_back(std::move(row));
    }
    page.table({"", "known x mm", "y mm", "z mm", "measured x mm", "y mm", "z mm", "scatter mm",
                "spread mm", "range error %", "corrected %", "position, corrected, mm"},
               rows);
    return page.text();
}

}  // namespace kambara::cli
