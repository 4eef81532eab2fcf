// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/track_command.h"

#include <atomic>
#include <cmath>
#include <condition_variable>
#include <mutex>
#include <nlohmann/json.hpp>

#include "app/cli/terminal.h"
#include "app/cli/track_table.h"
#include "app/cli/truth_comparison.h"
#include "core/base/angles.h"
#include "core/base/text_file.h"
#include "core/camera/position_frame.h"
#include "core/image/rectangle.h"
#include "core/matching/match_method.h"
#include "hardware/simulated/simulated_world.h"

namespace kambara::cli {
namespace {

// What the run gathers, frame by frame, on the pipeline's thread.
class TrackLog {
  public:
    TrackLog(std::size_t targets, std::optional<TruthComparison> truth, std::int64_t end_ns,
             const RigidTransform& T_frame_from_left)
        : tracked_of_(targets, 0),
          truth_(std::move(truth)),
          end_ns_(end_ns),
          T_frame_from_left_(T_frame_from_left) {}

    void add(const Snapshot& snapshot) {
        {
            std::lock_guard lock(mutex_);
            last_ = {snapshot.run, snapshot.failure, snapshot.frame};
            if (snapshot.frame != last_row_ && !past_end(snapshot)) {
                add_row(snapshot);
            }
            over_ = over_ || past_end(snapshot) || snapshot.run == RunState::ended ||
                    snapshot.run == RunState::failed;
        }
        changed_.notify_all();
    }

    // Shows progress until the source is over or the operator has had enough.
    void wait(ProgressLine& progress) {
        std::unique_lock lock(mutex_);
        while (!over_ && !interrupted()) {
            changed_.wait_for(lock, std::chrono::milliseconds(200));
            progress.show("frame " + std::to_string(last_.frame) + ", " + std::to_string(tracked_) +
                          " of " + std::to_string(frames_) + " tracked");
        }
    }

    std::optional<Error> failure() const {
        std::lock_guard lock(mutex_);
        return last_.failure;
    }
    std::int64_t frames() const {
        std::lock_guard lock(mutex_);
        return frames_;
    }
    std::string table() const {
        std::lock_guard lock(mutex_);
        return (several() ? targets_table_header() : track_table_header()) + rows_;
    }

    nlohmann::json report() const {
        std::lock_guard lock(mutex_);
        nlohmann::json json{
            {"frames", frames_},
            {"tracked_frames", tracked_},
            {"tracked_fraction", share(tracked_)},
            {"first_frame", first_row_},
            {"last_frame", last_row_},
            {"processing_ms_mean", frames_ > 0 ? processing_ms_ / double(frames_) : 0.0}};
        if (several()) {
            json["steered_target"] = steered_;
            for (std::size_t i = 0; i < tracked_of_.size(); ++i) {
                json["targets"].push_back({{"target", i + 1},
                                           {"tracked_frames", tracked_of_[i]},
                                           {"tracked_fraction", share(tracked_of_[i])}});
            }
        }
        if (watch_) {
            json["rig_watch"] = {{"matches", watch_->matches},
                                 {"offset_px", watch_->offset_px},
                                 {"sigma_px", watch_->sigma_px},
                                 {"turn_deg", deg_from_rad(watch_->turn_rad)},
                                 {"moved", watch_->moved},
                                 {"text", watch_->moved ? rig_moved_text(*watch_) : ""}};
            if (moved_frame_) {
                json["rig_watch"]["moved_frame"] = *moved_frame_;
            }
        }
        if (truth_) {
            const TruthSummary truth = truth_->summary();
            json["truth"] = {{"tracked_fraction", truth.tracked_fraction},
                             {"range_error_mean_pct", truth.range_error_mean_pct},
                             {"range_error_worst_pct", truth.range_error_worst_pct},
                             {"position_error_mean_mm", truth.position_error_mean_mm},
                             {"head_within_1_deg_fraction", truth.head_within_1_deg_fraction},
                             {"head_error_worst_deg", truth.head_error_worst_deg}};
        }
        return json;
    }

  private:
    bool several() const { return tracked_of_.size() > 1; }
    double share(std::int64_t tracked) const {
        return frames_ > 0 ? double(tracked) / double(frames_) : 0.0;
    }
    bool past_end(const Snapshot& snapshot) const { return snapshot.time_ns >= end_ns_; }

    void add_row(const Snapshot& snapshot) {
        if (frames_ == 0) {
            first_row_ = snapshot.frame;
        }
        last_row_ = snapshot.frame;
        ++frames_;
        steered_ = snapshot.steered_target.value_or(1);
        for (const TrackSnapshot& track : snapshot.tracks) {
            const bool tracked = track.estimate.state == TrackState::tracking;
            tracked_of_.at(static_cast<std::size_t>(track.id - 1)) += tracked ? 1 : 0;
            tracked_ += tracked && track.id == steered_ ? 1 : 0;
        }
        processing_ms_ += snapshot.processing_ms;
        note_rig_watch(snapshot);
        rows_ += several() ? targets_table_rows(snapshot, T_frame_from_left_)
                           : track_table_row(snapshot, T_frame_from_left_);
        if (truth_) {
            truth_->add(snapshot);
        }
    }

    // The most suspect state of the run, by its deviations.
    void note_rig_watch(const Snapshot& snapshot) {
        if (!snapshot.rig_watch) {
            return;
        }
        const auto deviations = [](const RigWatchState& state) {
            return (state.moved ? 1e6 : 0.0) + std::abs(state.offset_px) / state.sigma_px;
        };
        if (snapshot.rig_watch->moved && !moved_frame_) {
            moved_frame_ = snapshot.frame;
        }
        if (!watch_ || deviations(*snapshot.rig_watch) > deviations(*watch_)) {
            watch_ = snapshot.rig_watch;
        }
    }

    struct Last {
        RunState run = RunState::paused;
        std::optional<Error> failure;
        std::int64_t frame = -1;
    };

    mutable std::mutex mutex_;
    std::condition_variable changed_;
    std::vector<std::int64_t> tracked_of_;  // by number, from 1 on
    std::optional<TruthComparison> truth_;
    const std::int64_t end_ns_;
    const RigidTransform T_frame_from_left_;
    std::string rows_;
    std::int64_t frames_ = 0;
    std::int64_t tracked_ = 0;  // of the steered target
    int steered_ = 1;
    std::int64_t first_row_ = -1;
    std::int64_t last_row_ = -1;
    double processing_ms_ = 0.0;
    std::optional<RigWatchState> watch_;
    std::optional<std::int64_t> moved_frame_;
    Last last_;
    bool over_ = false;
};

std::optional<Error> misused(const TrackOptions& options) {
    if (options.record) {
        return Error{"Recording a session is not in this version yet.", "Leave --record out."};
    }
    const int count = static_cast<int>(options.templates.size());
    if (count < 1 || count > most_targets) {
        return Error{std::to_string(count) + " templates were given; 1 to " +
                         std::to_string(most_targets) + " targets can be followed at once.",
                     "Give --template once for each target."};
    }
    if (options.steer < 1 || options.steer > count) {
        return Error{"There is no target " + std::to_string(options.steer) + " to steer to: " +
                         std::to_string(count) + (count == 1 ? " was" : " were") + " given.",
                     "Give --steer the number of one of the --template options."};
    }
    return std::nullopt;
}

Result<Rectangle> chosen_template(const std::string& templ, const Sources& sources) {
    if (templ != "auto") {
        return parse_rectangle(templ);
    }
    if (!sources.world) {
        return Error{"Only a simulated rig can choose its template itself.",
                     "Give --template X,Y,W,H."};
    }
    return sources.world->suggested_template(31);
}

// A target for each template, numbered from 1 on.
Result<std::vector<Rectangle>> chosen_templates(const TrackOptions& options,
                                                const Sources& sources) {
    std::vector<Rectangle> rectangles;
    for (const std::string& templ : options.templates) {
        const auto rectangle = chosen_template(templ, sources);
        if (!rectangle) {
            return rectangle.error();
        }
        rectangles.push_back(*rectangle);
    }
    return rectangles;
}

std::vector<Command> commands_choosing(const std::vector<Rectangle>& rectangles, int steer) {
    std::vector<Command> commands;
    for (const Rectangle& rectangle : rectangles) {
        const int id = static_cast<int>(commands.size()) + 1;
        commands.emplace_back(SelectTemplate{rectangle, std::nullopt, id});
    }
    commands.emplace_back(SteerTo{steer});
    return commands;
}

Result<Done> execute_all(VsystemInterface& system, const std::vector<Command>& commands) {
    for (const Command& command : commands) {
        if (const auto done = system.execute(command); !done) {
            return done.error();
        }
    }
    return Done{};
}

// The part of the work that has no outcome of its own yet.
Result<nlohmann::json> track(const TrackOptions& options, const MatchMethod& method) {
    std::optional<TemporalOptions> temporal;
    if (!options.temporal.empty()) {
        const auto parsed = parse_temporal(options.temporal);
        if (!parsed) {
            return parsed.error();
        }
        temporal = *parsed;
    }
    SteadyClock clock;
    SourceOptions source_options = options.sources;
    source_options.pan_tilt_pictures = options.servo;
    auto sources = open_sources(source_options, clock);
    if (!sources) {
        return sources.error();
    }
    const auto T_frame = T_frame_from_left(sources->parts.rig, options.frame);
    if (!T_frame) {
        return T_frame.error();
    }
    const auto rectangles = chosen_templates(options, *sources);
    if (!rectangles) {
        return rectangles.error();
    }
    const auto position_method = position_method_from(options.position_method);
    if (!position_method) {
        return position_method.error();
    }
    VisionSystemOptions system_options;
    system_options.tracker.search.method = method;
    system_options.tracker.position.method = *position_method;
    system_options.temporal = temporal;
    system_options.every_frame = sources->every_frame;
    system_options.in_real_time = sources->real_head;
    system_options.start_paused = true;
    auto opened = open_vision_system(std::move(sources->parts), system_options, clock);
    if (!opened) {
        return opened.error();
    }
    VsystemInterface& system = **opened;
    if (const auto done = execute_all(system, commands_choosing(*rectangles, options.steer));
        !done) {
        return done.error();
    }
    if (options.servo) {
        if (const auto done = system.execute(ServoHead{}); !done) {
            return done.error();
        }
    }
    const SnapshotPtr first = system.latest();
    std::optional<TruthComparison> truth;
    if (sources->world) {
        const Rectangle& steered = rectangles->at(static_cast<std::size_t>(options.steer - 1));
        truth.emplace(sources->world, Eigen::Vector2d(steered.centre_x_px(), steered.centre_y_px()),
                      first->frame);
        if (!truth->on_target()) {
            truth.reset();
        }
    }
    const double seconds = options.seconds.value_or(1e9);
    TrackLog log(rectangles->size(), std::move(truth),
                 first->time_ns + static_cast<std::int64_t>(seconds * 1e9), *T_frame);
    const auto observation =
        system.observe([&log](const SnapshotPtr& snapshot) { log.add(*snapshot); });
    if (const auto done = execute_all(system, {StartTracking{}, Flow{Flow::Kind::run}}); !done) {
        return done.error();
    }
    {
        ProgressLine progress;
        log.wait(progress);
    }
    if (options.csv && (!log.failure() || log.frames() > 0)) {
        if (const auto written = write_text_file_atomically(*options.csv, log.table()); !written) {
            return written.error();
        }
    }
    if (auto failure = log.failure()) {
        if (options.csv && log.frames() > 0) {
            failure->remedy += " What was tracked before, " + std::to_string(log.frames()) +
                               " frames, is in " + options.csv->string() + ".";
        }
        return *failure;
    }
    nlohmann::json report = log.report();
    report["position_method"] = options.position_method;
    return report;
}

std::string summary_of(const nlohmann::json& report, const TrackOptions& options) {
    char line[256];
    std::string text = report.contains("targets") ? "The steered target: " : "";
    std::snprintf(line, sizeof line, "%lld of %lld frames tracked (%.1f %%), %.2f ms a pair.\n",
                  report["tracked_frames"].get<long long>(), report["frames"].get<long long>(),
                  100.0 * report["tracked_fraction"].get<double>(),
                  report["processing_ms_mean"].get<double>());
    text += line;
    if (options.sources.right.empty() && !options.sources.rig.empty()) {
        text += "Without --right pictures there are no positions.\n";
    }
    if (report.contains("truth") && report["tracked_frames"].get<long long>() > 0) {
        const auto& truth = report["truth"];
        std::snprintf(line, sizeof line,
                      "Against the truth: range error mean %.3f %%, worst %.3f %%; %s.\n",
                      truth["range_error_mean_pct"].get<double>(),
                      truth["range_error_worst_pct"].get<double>(),
                      head_sentence(truth["head_within_1_deg_fraction"].get<double>()).c_str());
        text += line;
    }
    for (const auto& target : report.value("targets", nlohmann::json::array())) {
        std::snprintf(line, sizeof line, "Target %d: %.1f %% tracked.\n",
                      target["target"].get<int>(),
                      100.0 * target["tracked_fraction"].get<double>());
        text += line;
    }
    if (report.contains("rig_watch")) {
        const auto& watch = report["rig_watch"];
        if (watch["moved"].get<bool>()) {
            text += "From frame " + std::to_string(watch["moved_frame"].get<long long>()) +
                    " on: " + watch["text"].get<std::string>() + "\n";
        } else {
            std::snprintf(line, sizeof line,
                          "The cameras stand as calibrated: at most %.2f px beside the epipolar "
                          "curve (%.2f px would be usual).\n",
                          std::abs(watch["offset_px"].get<double>()),
                          watch["sigma_px"].get<double>());
            text += line;
        }
    }
    if (options.csv) {
        text += "Table: " + options.csv->string() + "\n";
    }
    return text;
}

}  // namespace

Outcome run_track(const TrackOptions& options) {
    const auto failed = [](const Error& error, bool wrong_usage) {
        return Outcome{error, nlohmann::json{{"error", error.text()}}.dump(2), "", wrong_usage};
    };
    const auto method = parse_method(options.measure, options.transform);
    if (!method) {
        return failed(method.error(), true);
    }
    if (const auto fault = misused(options)) {
        return failed(*fault, true);
    }
    const auto report = track(options, *method);
    if (!report) {
        return failed(report.error(), false);
    }
    return {std::nullopt, report->dump(2), summary_of(*report, options)};
}

}  // namespace kambara::cli
