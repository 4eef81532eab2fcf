// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/calibration_statistics_command.h"

#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/base/text_file.h"
#include "core/calibration/record_table.h"
#include "core/calibration/sample_statistics.h"

namespace kambara::cli {
namespace {

using Json = nlohmann::json;

const char* const printed_form_note =
    "norm(T0 - T2) is the baseline only where both cameras have the same rotation";

Json statistics_json(const SampleStatistics& s) {
    return {{"n", s.n},
            {"mean", s.mean},
            {"deviation", s.deviation},
            {"t", s.t},
            {"half_width", s.half_width},
            {"lower", s.mean - s.half_width},
            {"upper", s.mean + s.half_width},
            {"percentage_error", s.percentage_error}};
}

Json parameter_json(const std::vector<double>& values, const std::vector<double>& distinct) {
    Json json = statistics_json(statistics_of(values));
    json["with_t_2_776"] = statistics_json(statistics_of(values, t_of_1999));
    if (distinct.size() < values.size()) {
        json["without_duplicates"] = statistics_json(statistics_of(distinct));
    }
    return json;
}

Json duplicates_json(const RecordGroup& group) {
    Json sets = Json::array();
    for (const auto& set : duplicates_in(group)) {
        Json labels = Json::array();
        for (const std::size_t i : set) {
            labels.push_back(group.labels[i]);
        }
        sets.push_back(std::move(labels));
    }
    return sets;
}

void add_baselines(const RecordTable& table, const RecordGroup& group, Json& json) {
    const auto baselines = baselines_of(table, group);
    if (baselines.empty()) {
        return;
    }
    std::vector<double> printed;
    std::vector<double> true_ones;
    for (const BaselineRecord& record : baselines) {
        Json one{{table.label_column.empty() ? "record" : table.label_column, record.label},
                 {"norm_t0_minus_t2_mm", record.norm_t0_minus_t2_mm}};
        printed.push_back(record.norm_t0_minus_t2_mm);
        if (record.baseline_mm) {
            true_ones.push_back(*record.baseline_mm);
            one["baseline_mm"] = *record.baseline_mm;
            one["turn_between_deg"] = *record.turn_between_deg;
        }
        json["baselines"].push_back(std::move(one));
    }
    json["norm_t0_minus_t2_statistics"] = statistics_json(statistics_of(printed));
    json["norm_t0_minus_t2_note"] = printed_form_note;
    if (!true_ones.empty()) {
        json["baseline_statistics"] = statistics_json(statistics_of(true_ones));
    }
}

Json group_json(const RecordTable& table, const RecordGroup& group) {
    Json json{{"environment", group.environment},
              {"camera", group.camera},
              {"records", group.rows.size()},
              {"duplicates", duplicates_json(group)}};
    const RecordGroup distinct = without_duplicates(group);
    for (std::size_t i = 0; i < table.parameters.size(); ++i) {
        json["parameters"][table.parameters[i]] =
            parameter_json(column_of(group, i), column_of(distinct, i));
    }
    add_baselines(table, group, json);
    return json;
}

Json water_json(const WaterComparison& one, double index_of_water) {
    return {{"camera", one.camera},
            {"index_of_water", index_of_water},
            {"f_ratio", one.f_ratio},
            {"f_ratio_half_width", one.f_ratio_half_width},
            {"predicted_f_ratio", one.predicted_f_ratio},
            {"kappa1_in_water_per_mm2", one.kappa1_in_water_per_mm2},
            {"predicted_kappa1_per_mm2", one.predicted_kappa1_per_mm2}};
}

template <class... Values>
std::string line_of(const char* form, Values... values) {
    char text[240];
    std::snprintf(text, sizeof text, form, values...);
    return text;
}

std::string title_of(const RecordGroup& group) {
    std::string title = group.environment;
    if (!group.camera.empty()) {
        title += (title.empty() ? "camera " : ", camera ") + group.camera;
    }
    return (title.empty() ? "All" : title) + ": " + std::to_string(group.rows.size()) +
           (group.rows.size() == 1 ? " record\n" : " records\n");
}

std::string duplicates_text(const RecordGroup& group) {
    std::string text;
    for (const auto& set : duplicates_in(group)) {
        text += "  Duplicates:";
        for (const std::size_t i : set) {
            text += " " + group.labels[i];
        }
        text += " are identical; they make the interval too small.\n";
    }
    return text;
}

std::string baselines_text(const RecordTable& table, const RecordGroup& group) {
    const auto baselines = baselines_of(table, group);
    std::string text;
    for (const BaselineRecord& record : baselines) {
        text += line_of("  %-8s norm(T0 - T2) %11.5f mm", record.label.c_str(),
                        record.norm_t0_minus_t2_mm);
        if (record.baseline_mm) {
            text += line_of(", baseline %11.5f mm, turned by %.3f deg", *record.baseline_mm,
                            *record.turn_between_deg);
        }
        text += "\n";
    }
    return baselines.empty() ? text : text + "  " + printed_form_note + ".\n";
}

std::string group_text(const RecordTable& table, const RecordGroup& group) {
    std::string text = title_of(group) + duplicates_text(group);
    if (group.rows.size() < 2) {
        return text + "  One record has no deviation: give two or more of this kind.\n" +
               baselines_text(table, group) + "\n";
    }
    text += line_of("  %-22s %13s %12s %12s %8s   %s\n", "parameter", "mean", "deviation",
                    "+- 95 %", "% error", "with t = 2.776");
    for (std::size_t i = 0; i < table.parameters.size(); ++i) {
        const auto values = column_of(group, i);
        const auto s = statistics_of(values);
        const auto old = statistics_of(values, t_of_1999);
        text += line_of("  %-22s %13.6f %12.6f %12.6f %8.3f   %.6f, %.3f %%\n",
                        table.parameters[i].substr(0, 60).c_str(), s.mean, s.deviation,
                        s.half_width, s.percentage_error, old.half_width, old.percentage_error);
    }
    const auto n = static_cast<double>(group.rows.size());
    return text +
           line_of("  t = %.4f for %.0f records; 1999 took %.3f, which is that of 5\n",
                   statistics_of(column_of(group, 0)).t, n, t_of_1999) +
           baselines_text(table, group) + "\n";
}

std::string water_text(const WaterComparison& one) {
    return line_of(
        "Camera %s, water against air: f ratio %.4f +- %.4f, predicted %.4f; kappa1 in water "
        "%.6f, predicted %.6f /mm^2\n",
        one.camera.substr(0, 40).c_str(), one.f_ratio, one.f_ratio_half_width,
        one.predicted_f_ratio, one.kappa1_in_water_per_mm2, one.predicted_kappa1_per_mm2);
}

Outcome failed(const Error& error) {
    return {error, Json{{"error", error.text()}}.dump(2), ""};
}

}  // namespace

Outcome run_calibration_statistics(const CalibrationStatisticsOptions& options) {
    const auto text = read_text_file(options.records);
    if (!text) {
        return failed(text.error());
    }
    const auto table = record_table_from_text(*text);
    if (!table) {
        return failed(
            {options.records.string() + ": " + table.error().cause, table.error().remedy});
    }
    Outcome outcome;
    Json json{{"groups", Json::array()}, {"air_and_water", Json::array()}};
    for (const RecordGroup& group : table->groups) {
        json["groups"].push_back(group_json(*table, group));
        outcome.summary += group_text(*table, group);
    }
    for (const WaterComparison& one : water_comparisons(*table, options.index_of_water)) {
        json["air_and_water"].push_back(water_json(one, options.index_of_water));
        outcome.summary += water_text(one);
    }
    // Text of the file that is no UTF-8 is shown as it can be.
    outcome.json = json.dump(2, ' ', false, Json::error_handler_t::replace);
    return outcome;
}

}  // namespace kambara::cli
