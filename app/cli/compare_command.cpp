// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/compare_command.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <nlohmann/json.hpp>
#include <utility>

#include "app/cli/compare_report.h"
#include "app/cli/compare_run.h"
#include "app/cli/compare_scene.h"
#include "app/cli/compare_score.h"
#include "app/cli/compare_verdict.h"
#include "app/cli/terminal.h"
#include "core/base/text_file.h"
#include "core/base/worker_pool.h"

namespace kambara::cli {
namespace {

constexpr double usual_seconds = 7.0;  // the light goes at 3 s and is back at 6 s
constexpr const char* stopped = "The comparison was stopped before it came to its end.";

// A scene to be made when its turn comes, so that the pictures of one are in memory at a time.
struct PlannedScene {
    std::string name;
    std::string profile;                   // of a simulated one
    std::optional<CompareScene> recorded;  // or this
};

std::vector<MatchMethod> methods_of(const CompareOptions& options) {
    std::vector<MatchMethod> methods = all_methods();
    if (options.sparse) {
        const auto dense = methods;
        for (MatchMethod method : dense) {
            method.step = 2;
            methods.push_back(method);
        }
    }
    if (std::find(methods.begin(), methods.end(), default_method()) == methods.end()) {
        methods.push_back(default_method());
    }
    return methods;
}

Result<std::vector<PlannedScene>> planned(const CompareOptions& options) {
    std::vector<PlannedScene> plan;
    if (!options.recording.left.empty()) {
        auto recorded =
            recorded_scenes({options.recording, options.truth, options.seconds}, options.templates);
        if (!recorded) {
            return recorded.error();
        }
        for (CompareScene& scene : *recorded) {
            plan.push_back({scene.name, "", std::move(scene)});
        }
    } else if (!options.templates.empty() || !options.truth.empty() ||
               !options.recording.right.empty() || !options.recording.rig.empty()) {
        return Error{"There are options for a recording, and no recording.",
                     "Name its pictures with --left."};
    }
    const bool all = plan.empty() && options.profiles.empty() && options.scenes.empty();
    if (all || !options.scenes.empty()) {
        const auto named = parse_scenes(all ? "all" : options.scenes);
        if (!named) {
            return named.error();
        }
        for (const NamedScene& scene : *named) {
            plan.push_back({scene.name, scene.profile, {}});
        }
    }
    for (const std::string& profile : options.profiles) {
        plan.push_back({profile, profile, {}});
    }
    return plan;
}

Result<CompareScene> made(PlannedScene planned, const CompareOptions& options, WorkerPool& pool) {
    return planned.recorded ? Result<CompareScene>(std::move(*planned.recorded))
                            : simulated_scene(planned.name, planned.profile,
                                              options.seconds.value_or(usual_seconds),
                                              options.template_px, pool);
}

// Progress over all scenes; any thread.
class Progress {
  public:
    explicit Progress(std::size_t steps) : steps_(static_cast<double>(steps)) {}

    void done(const std::string& what) {
        std::lock_guard lock(mutex_);
        line_.show(++done_ / steps_, what);
    }

  private:
    std::mutex mutex_;
    ProgressLine line_;
    const double steps_;
    double done_ = 0.0;
};

SceneResult compare(CompareScene scene, const std::vector<MatchMethod>& methods, WorkerPool& pool,
                    Progress& progress) {
    SceneResult result;
    result.frames = scene.pairs.size();
    result.runs.resize(methods.size());
    pool.for_each(methods.size(), [&](std::size_t i) {
        if (!interrupted()) {
            result.runs[i] = run_method(scene, methods[i]);
            progress.done(scene.name + ": " + label_of(methods[i]));
        }
    });
    for (CompareRun& run : result.runs) {
        if (!interrupted()) {
            run.ms_median = time_of_method_ms(scene, run.method);
            progress.done(scene.name + ": time of " + label_of(run.method));
        }
    }
    if (!interrupted()) {
        const auto reference = reference_of(scene, result.runs);
        for (const CompareRun& run : result.runs) {
            result.scores.push_back(score_of(scene, run, reference));
        }
    }
    scene.pairs.clear();
    result.scene = std::move(scene);
    return result;
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
    auto plan = planned(options);
    if (!plan) {
        return {plan.error()};
    }
    const auto methods = methods_of(options);
    std::vector<SceneResult> results;
    {
        WorkerPool pool;
        Progress progress(plan->size() * 2 * methods.size());
        for (PlannedScene& planned_scene : *plan) {
            auto scene = made(std::move(planned_scene), options, pool);
            if (!scene) {
                return {scene.error()};
            }
            if (temporal) {
                low_pass(*scene, *temporal);
            }
            auto result = compare(std::move(*scene), methods, pool, progress);
            if (interrupted()) {
                return {Error{stopped, "Give it fewer --scenes or --seconds."}};
            }
            results.push_back(std::move(result));
        }
    }
    Outcome outcome;
    outcome.summary = compare_tables(results, default_method());
    nlohmann::json json = compare_json(results, default_method());
    if (temporal) {
        json["temporal"] = to_string(*temporal);
    }
    // Names come from the command line, in whatever encoding.
    outcome.json = json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace);
    if (options.report) {
        const auto written =
            write_text_file_atomically(*options.report, compare_html(results, default_method()));
        if (!written) {
            return {written.error()};
        }
        outcome.summary += "\nReport: " + options.report->string() + "\n";
    }
    if (standings(results).front().robustness <= 0.0) {
        outcome.failure = Error{"No method follows the target.",
                                "Choose a larger template with marks or corners on it."};
    }
    return outcome;
}

}  // namespace kambara::cli
