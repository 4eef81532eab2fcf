// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/compare_command.h"

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <utility>

#include "app/cli/compare_scene.h"
#include "app/cli/terminal.h"
#include "core/base/text_file.h"
#include "core/report/html_report.h"

namespace kambara::cli {
namespace {

// From clear air to what lies at the end of sight, then what else happens under water. Beam
// attenuation of 0.35 and 1 per metre: coastal water, and on the way to that of a harbour.
const std::vector<std::string> usual_profiles{
    "default?seed=2&haze=0&particles=0",
    "default?seed=2&haze=0.35&blur=0.3&particles=200&medium=water",
    "default?seed=2&haze=1&blur=0.3&particles=200&medium=water",
    "default?seed=2&haze=0.35&blur=0.3&particles=600&medium=water&step=0.4&swap=2",
};

std::string label_of(const MatchMethod& method) {
    return to_string(method.measure) +
           (method.transform == Transform::none ? "" : " after " + to_string(method.transform));
}

std::string decimals(const char* format, double value) {
    char text[48];
    std::snprintf(text, sizeof text, format, value);
    return std::isfinite(value) ? std::string(text) : std::string("-");
}

struct SceneResult {
    CompareScene scene;  // without its pictures
    std::vector<CompareRun> runs;
    std::vector<CompareScore> scores;
};

SceneResult compare(CompareScene scene, ProgressLine& progress) {
    SceneResult result;
    for (const MatchMethod& method : all_methods()) {
        progress.show(scene.name + ": " + label_of(method));
        if (interrupted()) {
            break;
        }
        result.runs.push_back(run_method(scene, method));
    }
    const auto reference = reference_of(scene, result.runs);
    for (const CompareRun& run : result.runs) {
        result.scores.push_back(score_of(run, reference));
    }
    scene.pairs.clear();
    result.scene = std::move(scene);
    return result;
}

bool has_truth(const CompareScene& scene) {
    return !scene.truth_in_left_mm.empty() && scene.truth_in_left_mm.front().has_value();
}

std::string reference_text(const CompareScene& scene) {
    return has_truth(scene) ? "the simulation's truth" : "the median of all methods";
}

nlohmann::json json_of(const SceneResult& result) {
    nlohmann::json methods = nlohmann::json::array();
    for (std::size_t i = 0; i < result.runs.size(); ++i) {
        const CompareScore& score = result.scores[i];
        nlohmann::json entry{{"measure", to_string(result.runs[i].method.measure)},
                             {"transform", to_string(result.runs[i].method.transform)},
                             {"right_fraction", score.right},
                             {"wrong_fraction", score.wrong},
                             {"lost_fraction", 1.0 - score.right - score.wrong},
                             {"ms_median", result.runs[i].ms_median}};
        if (std::isfinite(score.error_mean_pct)) {
            entry["error_mean_pct"] = score.error_mean_pct;
        }
        methods.push_back(std::move(entry));
    }
    return {{"name", result.scene.name},
            {"reference", reference_text(result.scene)},
            {"frames", result.scene.truth_in_left_mm.size()},
            {"methods", std::move(methods)}};
}

std::vector<std::string> row_of(const SceneResult& result, std::size_t i) {
    const CompareScore& score = result.scores[i];
    return {label_of(result.runs[i].method), decimals("%.1f", 100.0 * score.right),
            decimals("%.1f", 100.0 * score.wrong), decimals("%.3f", score.error_mean_pct),
            decimals("%.2f", result.runs[i].ms_median)};
}

// Why a template was not taken, where that is the same for all methods; empty where it was taken.
std::string refusal_of(const SceneResult& result) {
    return !result.runs.empty() && result.runs.front().refused ? result.runs.front().refused->text()
                                                               : std::string();
}

std::string table_of(const SceneResult& result) {
    char line[160];
    std::string text =
        "\n" + result.scene.name + " (against " + reference_text(result.scene) + ")\n";
    if (const std::string refusal = refusal_of(result); !refusal.empty()) {
        return text + "  " + refusal + "\n";
    }
    std::snprintf(line, sizeof line, "  %-22s %9s %9s %9s %9s\n", "", "right %", "wrong %",
                  "error %", "ms");
    text += line;
    for (std::size_t i = 0; i < result.runs.size(); ++i) {
        const auto row = row_of(result, i);
        std::snprintf(line, sizeof line, "  %-22s %9s %9s %9s %9s\n", row[0].c_str(),
                      row[1].c_str(), row[2].c_str(), row[3].c_str(), row[4].c_str());
        text += line;
    }
    return text;
}

std::string html_of(const std::vector<SceneResult>& results) {
    HtmlReport report("Matching methods side by side");
    report.paragraph(
        "One target is followed through the same pictures by every measure after every transform. "
        "Right: tracked, and within 1 % of range of the reference. Wrong: said to be tracked, but "
        "farther away. The rest was doubtful or lost. Error: mean over the right frames, share of "
        "range. Time: median of a stereo pair, left and right search and position.");
    for (const SceneResult& result : results) {
        report.heading(result.scene.name);
        std::string what = std::to_string(result.scene.truth_in_left_mm.size()) +
                           " stereo pairs, against " + reference_text(result.scene) + ".";
        if (has_truth(result.scene)) {
            what += " Up to " + decimals("%.1f", result.scene.attenuation_lengths_most) +
                    " attenuation lengths from camera to target.";
        }
        report.paragraph(what);
        if (const std::string refusal = refusal_of(result); !refusal.empty()) {
            report.paragraph(refusal);
            continue;
        }
        std::vector<std::vector<std::string>> rows;
        std::vector<HtmlReport::Bar> right;
        std::vector<HtmlReport::Bar> error;
        std::vector<HtmlReport::Bar> time;
        for (std::size_t i = 0; i < result.runs.size(); ++i) {
            rows.push_back(row_of(result, i));
            const std::string label = label_of(result.runs[i].method);
            right.push_back({label, 100.0 * result.scores[i].right, result.scores[i].wrong > 0.01});
            error.push_back({label, result.scores[i].error_mean_pct, false});
            time.push_back({label, result.runs[i].ms_median, false});
        }
        report.table({"method", "right %", "wrong %", "error %", "ms a pair"}, rows);
        report.bars("Frames right (the second colour: more than 1 % silently wrong)", "%", right,
                    1);
        report.bars("Mean error, share of range", "%", error, 3);
        report.bars("Time of a stereo pair", "ms", time, 2);
    }
    return report.text();
}

}  // namespace

Outcome run_compare(const CompareOptions& options) {
    std::optional<TemporalOptions> temporal;
    if (!options.temporal.empty()) {
        const auto parsed = parse_temporal(options.temporal);
        if (!parsed) {
            return {parsed.error()};
        }
        temporal = *parsed;
    }
    std::vector<SceneResult> results;
    {
        ProgressLine progress;
        const bool recorded = !options.recording.left.empty();
        if (recorded) {
            auto scene = recorded_scene(options);
            if (!scene) {
                return {scene.error()};
            }
            if (temporal) {
                low_pass(*scene, *temporal);
            }
            results.push_back(compare(std::move(*scene), progress));
        }
        const auto& profiles =
            options.profiles.empty() && !recorded ? usual_profiles : options.profiles;
        for (const std::string& profile : profiles) {
            progress.show(profile + ": drawing");
            auto scene = simulated_scene(profile, options.frames, options.template_px);
            if (!scene) {
                return {scene.error()};
            }
            if (temporal) {
                low_pass(*scene, *temporal);
            }
            results.push_back(compare(std::move(*scene), progress));
        }
    }
    Outcome outcome;
    nlohmann::json scenes = nlohmann::json::array();
    for (const SceneResult& result : results) {
        scenes.push_back(json_of(result));
        outcome.summary += table_of(result);
    }
    nlohmann::json json{{"scenes", std::move(scenes)}};
    if (temporal) {
        json["temporal"] = to_string(*temporal);
    }
    outcome.json = json.dump(2);
    if (options.report) {
        const auto written = write_text_file_atomically(*options.report, html_of(results));
        if (!written) {
            return {written.error()};
        }
        outcome.summary += "\nReport: " + options.report->string() + "\n";
    }
    return outcome;
}

}  // namespace kambara::cli
