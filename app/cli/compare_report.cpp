// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/compare_report.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <utility>

#include "app/cli/compare_verdict.h"
#include "core/report/html_report.h"

namespace kambara::cli {
namespace {

using Cells = std::vector<std::string>;

std::string decimals(int places, double value) {
    char text[48];
    std::snprintf(text, sizeof text, "%.*f", places, value);
    return std::isfinite(value) ? text : "-";
}

std::string percent(double share) {
    return decimals(1, 100.0 * share);
}

nlohmann::json known(double value) {
    return std::isfinite(value) ? nlohmann::json(value) : nlohmann::json();
}

nlohmann::json json_of(const MatchMethod& method) {
    return {{"measure", to_string(method.measure)},
            {"transform", to_string(method.transform)},
            {"step", method.step}};
}

bool all_refused(const SceneResult& result) {
    return std::all_of(result.runs.begin(), result.runs.end(),
                       [](const CompareRun& run) { return run.refused.has_value(); });
}

std::string extent_of(const SceneResult& result) {
    std::string text = std::to_string(result.frames) +
                       (result.scene.rig.right ? " stereo pairs." : " pictures of one camera.");
    const auto& lengths = result.scene.attenuation_lengths;
    if (!lengths.empty() && *std::max_element(lengths.begin(), lengths.end()) > 0.0) {
        text += " Target and camera are " +
                decimals(1, *std::min_element(lengths.begin(), lengths.end())) + " to " +
                decimals(1, *std::max_element(lengths.begin(), lengths.end())) +
                " attenuation lengths apart.";
    }
    return text;
}

// What the shares and errors are measured against.
std::string explained(const SceneResult& result) {
    if (result.scene.has_truth()) {
        return "On target: Tracking, and within 3 px of the truth in every picture. Off target: "
               "Tracking, but farther away. Found: the place given in the left picture, "
               "Tracking or Doubtful, is on target. Errors: means over the frames on target.";
    }
    return "There is no truth. Kept: what the method itself says. There and back: followed "
           "forward and, by a fresh template from where it was last seen, back to within 3 px of "
           "the same places, which drift and leaps fail but a steady mistake may pass. Agrees: "
           "within 3 px of the median of all methods, which may err together. Apart: said to be "
           "tracked, but farther from that median. Found: the place given, Tracking or "
           "Doubtful, agrees.";
}

Cells header_of(const SceneResult& result) {
    if (result.scene.has_truth()) {
        return {"method",  "kept %",   "on target %",   "off target %",
                "found %", "error px", "range error %", "ms a pair"};
    }
    return {"method",  "kept %",  "there+back %",   "agrees %",
            "apart %", "found %", "from median px", "ms a pair"};
}

std::string label_in(const SceneResult& result, std::size_t i, const MatchMethod& shipped) {
    return label_of(result.runs[i].method) + (result.runs[i].method == shipped ? " (default)" : "");
}

Cells row_of(const SceneResult& result, std::size_t i, const MatchMethod& shipped) {
    const CompareScore& score = result.scores[i];
    const std::string label = label_in(result, i, shipped);
    if (result.runs[i].refused) {
        return {label, "refused", "-", "-", "-", "-", "-", "-"};
    }
    const std::string ms = decimals(2, result.runs[i].ms_median);
    if (result.scene.has_truth()) {
        return {label,
                percent(score.kept),
                percent(score.on_target),
                percent(score.off_target),
                percent(score.found),
                decimals(2, score.error_px),
                decimals(3, score.range_error_pct),
                ms};
    }
    return {label,
            percent(score.kept),
            percent(score.there_and_back.value_or(0.0)),
            percent(score.on_target),
            percent(score.off_target),
            percent(score.found),
            decimals(2, score.error_px),
            ms};
}

std::vector<Cells> rows_of(const SceneResult& result, const MatchMethod& shipped) {
    std::vector<Cells> rows;
    for (std::size_t i = 0; i < result.runs.size(); ++i) {
        rows.push_back(row_of(result, i, shipped));
    }
    return rows;
}

// Why methods could not take the template; empty where all could.
std::string refusals_of(const SceneResult& result) {
    for (const CompareRun& run : result.runs) {
        if (run.refused) {
            return std::string(all_refused(result) ? "Every method" : "Refused, first ") +
                   (all_refused(result) ? " refused the template: "
                                        : "by " + label_of(run.method) + ": ") +
                   run.refused->text();
        }
    }
    return "";
}

struct Table {
    Cells header;
    std::vector<Cells> rows;
};

// Methods, the best first, with their robustness in every scene.
Table overall(const std::vector<SceneResult>& results, const MatchMethod& shipped) {
    Table table{{"method", "mean %", "worst %", "off target %", "ms a pair"}, {}};
    for (std::size_t i = 0; i < results.size(); ++i) {
        table.header.push_back(std::to_string(i + 1) + " %");
    }
    for (const Standing& standing : standings(results)) {
        Cells row{label_in(results.front(), standing.method, shipped), percent(standing.robustness),
                  percent(standing.worst), percent(standing.off_target), decimals(2, standing.ms)};
        for (const SceneResult& result : results) {
            row.push_back(percent(robustness(result, standing.method)));
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

std::string numbered_scenes(const std::vector<SceneResult>& results) {
    std::string text;
    for (std::size_t i = 0; i < results.size(); ++i) {
        text += (text.empty() ? "" : ", ") + std::to_string(i + 1) + " " + results[i].scene.name;
    }
    return text;
}

// Share on target by attenuation lengths; the ranges are the columns.
Table by_attenuation(const std::vector<SceneResult>& results, const MatchMethod& shipped) {
    Table table{{"lengths"}, {}};
    for (std::size_t i = 0; !results.empty() && i < results.front().runs.size(); ++i) {
        Cells row{label_in(results.front(), i, shipped)};
        for (const AttenuationBin& bin : bins_of(results, i)) {
            if (i == 0) {
                table.header.push_back(decimals(1, bin.from_lengths) + "-" +
                                       decimals(1, bin.from_lengths + attenuation_bin_lengths));
            }
            row.push_back(percent(bin.share()));
        }
        table.rows.push_back(std::move(row));
    }
    if (table.header.size() == 1) {
        return {};
    }
    table.header.front() = "on target %, by lengths";
    return table;
}

std::string text_of(const Table& table) {
    std::vector<std::size_t> widths;
    const auto widen = [&](const Cells& cells) {
        widths.resize(std::max(widths.size(), cells.size()), 0);
        for (std::size_t i = 0; i < cells.size(); ++i) {
            widths[i] = std::max(widths[i], cells[i].size());
        }
    };
    widen(table.header);
    std::for_each(table.rows.begin(), table.rows.end(), widen);
    std::string text;
    const auto add = [&](const Cells& cells) {
        for (std::size_t i = 0; i < cells.size(); ++i) {
            const std::string blanks(widths[i] - cells[i].size(), ' ');
            text += i == 0 ? "  " + cells[i] + blanks : "  " + blanks + cells[i];
        }
        text += "\n";
    };
    add(table.header);
    std::for_each(table.rows.begin(), table.rows.end(), add);
    return text;
}

// The lines of the plot: the default, the classic ones, and the best of the others.
std::vector<HtmlReport::Series> attenuation_lines(const std::vector<SceneResult>& results,
                                                  const MatchMethod& shipped) {
    std::vector<std::size_t> chosen;
    const auto add = [&](std::optional<std::size_t> index) {
        if (index && std::find(chosen.begin(), chosen.end(), *index) == chosen.end()) {
            chosen.push_back(*index);
        }
    };
    add(index_of(results, shipped));
    for (const Measure measure : {Measure::sad, Measure::ncc, Measure::zncc}) {
        add(index_of(results, {measure, Transform::none, 1}));
    }
    for (const Standing& standing : standings(results)) {
        if (chosen.size() < 6) {
            add(standing.method);
        }
    }
    std::vector<HtmlReport::Series> series;
    for (const std::size_t method : chosen) {
        HtmlReport::Series one{label_in(results.front(), method, shipped), {}};
        for (const AttenuationBin& bin : bins_of(results, method)) {
            one.points.push_back(
                {bin.from_lengths + 0.5 * attenuation_bin_lengths, 100.0 * bin.share(), 0.0});
        }
        series.push_back(std::move(one));
    }
    return series;
}

void add_scene(HtmlReport& report, const SceneResult& result, const MatchMethod& shipped) {
    report.heading(result.scene.name);
    report.paragraph(result.scene.what);
    report.paragraph(extent_of(result) + " " + explained(result));
    if (const std::string refusals = refusals_of(result); !refusals.empty()) {
        report.paragraph(refusals);
    }
    if (all_refused(result)) {
        return;
    }
    report.table(header_of(result), rows_of(result, shipped));
    const bool truth = result.scene.has_truth();
    std::vector<HtmlReport::Bar> robust;
    std::vector<HtmlReport::Bar> error;
    std::vector<HtmlReport::Bar> time;
    for (std::size_t i = 0; i < result.runs.size(); ++i) {
        const std::string label = label_in(result, i, shipped);
        const CompareScore& score = result.scores[i];
        const bool is_shipped = result.runs[i].method == shipped;
        robust.push_back({label, 100.0 * robustness(result, i), is_shipped});
        error.push_back({label,
                         truth && result.scene.rig.right ? score.range_error_pct : score.error_px,
                         is_shipped});
        time.push_back({label, result.runs[i].ms_median, is_shipped});
    }
    report.bars(truth ? "Frames on target (second colour: the default)"
                      : "Frames followed there and back (second colour: the default)",
                "%", robust, 1);
    if (truth && result.scene.rig.right) {
        report.bars("Mean range error of the frames on target", "%", error, 3);
    } else {
        report.bars(truth ? "Mean error of the frames on target"
                          : "Mean distance from the median of all methods",
                    "px", error, 2);
    }
    report.bars("Median processor time of a pair while Tracking", "ms", time, 2);
}

}  // namespace

nlohmann::json compare_json(const std::vector<SceneResult>& results, const MatchMethod& shipped) {
    nlohmann::json scenes = nlohmann::json::array();
    for (const SceneResult& result : results) {
        const bool truth = result.scene.has_truth();
        nlohmann::json methods = nlohmann::json::array();
        for (std::size_t i = 0; i < result.runs.size(); ++i) {
            const CompareScore& score = result.scores[i];
            nlohmann::json entry = json_of(result.runs[i].method);
            entry["refused"] = result.runs[i].refused
                                   ? nlohmann::json(result.runs[i].refused->text())
                                   : nlohmann::json();
            entry["kept_fraction"] = score.kept;
            entry["on_reference_fraction"] = score.on_target;
            entry["off_reference_fraction"] = score.off_target;
            entry["found_fraction"] = score.found;
            entry["there_and_back_fraction"] =
                score.there_and_back ? nlohmann::json(*score.there_and_back) : nlohmann::json();
            entry["error_mean_px"] = known(score.error_px);
            entry["range_error_mean_pct"] = known(score.range_error_pct);
            entry["ms_median"] = known(result.runs[i].ms_median);
            methods.push_back(std::move(entry));
        }
        scenes.push_back({{"name", result.scene.name},
                          {"what", result.scene.what},
                          {"reference", truth ? "truth" : "median of all methods"},
                          {"frames", result.frames},
                          {"methods", std::move(methods)}});
    }
    nlohmann::json bins = nlohmann::json::array();
    for (std::size_t i = 0; !results.empty() && i < results.front().runs.size(); ++i) {
        for (const AttenuationBin& bin : bins_of(results, i)) {
            nlohmann::json entry = json_of(results.front().runs[i].method);
            entry["from_lengths"] = bin.from_lengths;
            entry["to_lengths"] = bin.from_lengths + attenuation_bin_lengths;
            entry["frames"] = bin.frames;
            entry["on_target_fraction"] = known(bin.share());
            bins.push_back(std::move(entry));
        }
    }
    return {{"default", json_of(shipped)},
            {"verdict", verdict_on(results, shipped)},
            {"scenes", std::move(scenes)},
            {"attenuation", std::move(bins)}};
}

std::string compare_tables(const std::vector<SceneResult>& results, const MatchMethod& shipped) {
    std::string text;
    std::string last_terms;
    for (const SceneResult& result : results) {
        text +=
            "\n" + result.scene.name + ": " + result.scene.what + "\n  " + extent_of(result) + "\n";
        if (std::string terms = explained(result); terms != last_terms) {
            text += "  " + terms + "\n";
            last_terms = std::move(terms);
        }
        if (const std::string refusals = refusals_of(result); !refusals.empty()) {
            text += "  " + refusals + "\n";
        }
        if (!all_refused(result)) {
            text += text_of({header_of(result), rows_of(result, shipped)});
        }
    }
    if (const Table table = by_attenuation(results, shipped); !table.rows.empty()) {
        text +=
            "\nSimulated water, by attenuation lengths from target to camera\n" + text_of(table);
    }
    if (results.size() > 1) {
        text +=
            "\nAll scenes: " + numbered_scenes(results) + "\n" + text_of(overall(results, shipped));
    }
    text += "\n";
    for (const std::string& sentence : verdict_on(results, shipped)) {
        text += sentence + "\n";
    }
    return text;
}

std::string compare_html(const std::vector<SceneResult>& results, const MatchMethod& shipped) {
    HtmlReport report("Matching methods side by side");
    report.paragraph(
        "One target is followed through the same pictures by every measure after every transform. "
        "Times are processor time of one thread while nothing else runs in the program.");
    report.heading("In short");
    for (const std::string& sentence : verdict_on(results, shipped)) {
        report.paragraph(sentence);
    }
    if (results.size() > 1) {
        const Table table = overall(results, shipped);
        report.heading("All scenes");
        report.paragraph(
            "Robustness in each: frames on target, or of recordings without a truth those followed "
            "there and back. Scenes: " +
            numbered_scenes(results) + ".");
        report.table(table.header, table.rows);
    }
    if (const Table table = by_attenuation(results, shipped); !table.rows.empty()) {
        report.heading("By attenuation lengths");
        report.paragraph(
            "Frames on target in all simulated water, by the beam attenuation times the way from "
            "target to camera. A target that was lost farther out and is not found again counts "
            "against the range that it is in.");
        report.lines("Frames on target", "attenuation lengths", "%", 100.0,
                     attenuation_lines(results, shipped));
        report.table(table.header, table.rows);
    }
    for (const SceneResult& result : results) {
        add_scene(report, result, shipped);
    }
    return report.text();
}

}  // namespace kambara::cli
