// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/calibrate_command.h"

#include <cstdio>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "app/cli/calibration_json.h"
#include "app/cli/calibration_page.h"
#include "app/cli/calibration_pictures.h"
#include "app/cli/now.h"
#include "app/cli/terminal.h"
#include "core/base/text_file.h"
#include "core/calibration/rig_calibrator.h"
#include "core/camera/rig_file.h"

namespace kambara::cli {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

struct Job {
    Target target;
    RigCalibratorOptions options;
    CalibrationFiles files;
};

Result<KnownBaseline> parse_baseline(const std::string& text) {
    KnownBaseline known;
    char rest = 0;
    if (std::sscanf(text.c_str(), "%lf,%lf%c", &known.baseline_mm, &known.sigma_mm, &rest) != 2 ||
        !(known.baseline_mm > 0.0) || !(known.sigma_mm > 0.0)) {
        return Error{"The known baseline \"" + text + "\" is not understood.",
                     "Give it as MM,SIGMA, both positive, for example 450,0.5."};
    }
    return known;
}

Result<Sensor> parse_sensor(const std::string& text) {
    Sensor sensor;
    char rest = 0;
    if (std::sscanf(text.c_str(), "%lf,%lf,%lf,%lf%c", &sensor.dx_mm, &sensor.dy_mm, &sensor.ncx,
                    &sensor.nfx, &rest) != 4 ||
        !(sensor.dx_mm > 0.0) || !(sensor.dy_mm > 0.0) || !(sensor.ncx > 0.0) ||
        !(sensor.nfx > 0.0)) {
        return Error{"The sensor \"" + text + "\" is not understood.",
                     "Give dx,dy,Ncx,Nfx, all positive, for example 0.00635,0.0074,768,640."};
    }
    return sensor;
}

Result<Done> plan_model(const CalibrateOptions& options, RigCalibratorOptions& plan) {
    if (options.model == "tsai") {
        if (!options.sensor) {
            return Error{"The model tsai needs the sensor.",
                         "Give --sensor dx,dy,Ncx,Nfx, for example 0.00635,0.0074,768,640."};
        }
        const auto sensor = parse_sensor(*options.sensor);
        if (!sensor) {
            return sensor.error();
        }
        plan.sensor = *sensor;
        plan.model = LensModel::tsai;
    } else if (options.model != "brown") {
        return Error{"There is no model \"" + options.model + "\".", "Use --model brown or tsai."};
    } else if (options.sensor) {
        return Error{"--sensor belongs to the model tsai.", "Leave it out with --model brown."};
    }
    if (options.medium != "air" && options.medium != "water") {
        return Error{"There is no medium \"" + options.medium + "\".",
                     "Use --medium air or water."};
    }
    plan.medium = options.medium == "air" ? Medium::air : Medium::water;
    return Done{};
}

// What the options say by themselves, without a look at any file.
Result<RigCalibratorOptions> understood(const CalibrateOptions& options) {
    RigCalibratorOptions plan;
    if (const auto done = plan_model(options, plan); !done) {
        return done.error();
    }
    plan.estimate_target = options.estimate_target;
    if (options.baseline) {
        const auto known = parse_baseline(*options.baseline);
        if (!known) {
            return known.error();
        }
        if (options.right.empty()) {
            return Error{"--baseline needs a right camera.", "Give --right, or leave it out."};
        }
        plan.baseline = *known;
    }
    return plan;
}

Result<Job> planned(const CalibrateOptions& options, RigCalibratorOptions plan) {
    Job job;
    job.options = std::move(plan);
    auto target = parse_target(options.target);
    if (!target) {
        return target.error();
    }
    job.target = std::move(*target);
    if (options.expected) {
        auto expected = read_rig_file(*options.expected);
        if (!expected) {
            return expected.error();
        }
        job.options.expected = std::move(*expected);
    }
    auto files = calibration_files({options.left, options.right, options.pan_tilt});
    if (!files) {
        return files.error();
    }
    job.files = std::move(*files);
    return job;
}

// The options in words, for the rig file and the report.
std::string settings_of(const CalibrateOptions& options) {
    std::string text =
        "target " + options.target + ", model " + options.model + ", medium " + options.medium;
    if (options.sensor) {
        text += ", sensor " + *options.sensor;
    }
    if (options.baseline) {
        text += ", baseline " + *options.baseline;
    }
    if (options.expected) {
        text += ", expected " + options.expected->filename().string();
    }
    return text + (options.estimate_target ? ", target estimated" : "");
}

std::string summary_of(const CalibrationReport& report, const fs::path& out) {
    char line[240];
    std::snprintf(line, sizeof line,
                  "Verdict: %s. %d views, %d of %d corners, residuals %.3f px.\n",
                  to_string(report.verdict).c_str(), report.views_used, report.corners_used,
                  report.corners_total, report.rms_px);
    std::string text = line;
    for (std::size_t c = 0; c < most_cameras; ++c) {
        if (report.pairs[c]) {
            std::snprintf(line, sizeof line, "Left to %s: %.3f mm, 1 sigma %.3f mm.\n",
                          camera_names[c], report.pairs[c]->baseline_mm,
                          report.pairs[c]->baseline_sigma_mm);
            text += line;
        }
    }
    for (const RejectedView& view : report.views_rejected) {
        text += "View " + std::to_string(view.view + 1) +
                " left out: " + (view.camera.empty() ? "" : view.camera + ": ") + view.reason +
                "\n";
    }
    for (const std::string& reason : report.reasons) {
        text += reason + "\n";
    }
    return text + "Rig file: " + out.string() + "\n";
}

Outcome failed(const Error& error, Json json) {
    json["verdict"] = "refused";
    json["accepted"] = false;
    if (!json.contains("reasons") || json["reasons"].empty()) {
        json["reasons"] = {error.text()};
    }
    return {error, json.dump(2), ""};
}

}  // namespace

Outcome run_calibrate(const CalibrateOptions& options) {
    auto plan = understood(options);
    if (!plan) {
        Outcome outcome = failed(plan.error(), Json::object());
        outcome.wrong_usage = true;
        return outcome;
    }
    auto job = planned(options, std::move(*plan));
    if (!job) {
        return failed(job.error(), Json::object());
    }
    ProgressLine progress;
    auto seen = look_at_all(job->files, job->target, progress);
    if (!seen) {
        return failed(seen.error(), Json::object());
    }
    job->options.cameras = seen->sizes;
    CalibrationReport report =
        calibrate_rig(seen->views, job->target, job->options, {},
                      [&progress](double share) { progress.show(share, "adjusting"); });
    const Json json = calibration_json(report, job->files);
    if (options.report) {
        const auto page = calibration_page(json, report, settings_of(options));
        if (const auto written = write_text_file_atomically(*options.report, page); !written) {
            return failed(written.error(), json);
        }
    }
    if (report.verdict == Verdict::refused) {
        std::string why;
        for (const std::string& reason : report.reasons) {
            why += " " + reason;
        }
        return failed({"The calibration is refused." + why,
                       "No rig file was written. Take more views, sharp and at several angles, "
                       "and check the target's numbers."},
                      json);
    }
    Provenance& from = report.rig.provenance;
    from.method =
        options.target + ", " + options.model + ", " + std::to_string(report.views_used) + " views";
    from.created = now_iso8601();
    from.program = program_name;
    from.settings = settings_of(options);
    from.pictures = seen->marks;
    if (const auto written = write_rig_file(options.out, report.rig); !written) {
        return failed(written.error(), json);
    }
    return {std::nullopt, json.dump(2), summary_of(report, options.out)};
}

}  // namespace kambara::cli
