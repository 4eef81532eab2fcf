// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/calibrate_command.h"

#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "app/cli/now.h"
#include "app/cli/terminal.h"
#include "core/calibration/calibrator.h"
#include "core/calibration/chessboard_detector.h"
#include "core/camera/rig_file.h"
#include "hardware/media/picture_file.h"

namespace kambara::cli {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

struct Pictures {
    std::vector<fs::path> left;
    std::vector<fs::path> right;
    int width_px = 0;
    int height_px = 0;
};

struct Job {
    ChessboardTarget board;
    CalibratorOptions options;
    Pictures pictures;
    std::vector<BoardView> views;
};

Error not_yet(const std::string& what, const std::string& remedy) {
    return {what + " is not in this version yet.", remedy};
}

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

Result<Job> planned(const CalibrateOptions& options) {
    Job job;
    const auto target = parse_target(options.target);
    if (!target) {
        return target.error();
    }
    const auto* board = std::get_if<ChessboardTarget>(&*target);
    if (board == nullptr) {
        return not_yet("Calibrating with the target " + options.target, "Use a chessboard.");
    }
    if (options.model == "tsai") {
        return not_yet("The model tsai for calibration", "Use --model brown.");
    }
    if (options.model != "brown") {
        return Error{"There is no model \"" + options.model + "\".", "Use --model brown."};
    }
    if (options.sensor) {
        return Error{"--sensor belongs to the model tsai.", "Leave it out with --model brown."};
    }
    if (!options.pan_tilt.empty()) {
        return not_yet("Calibrating the pan-tilt camera", "Leave --pan-tilt out.");
    }
    if (options.report) {
        return not_yet("The HTML report", "Leave --report out; --json holds every number.");
    }
    if (options.baseline) {
        const auto known = parse_baseline(*options.baseline);
        if (!known) {
            return known.error();
        }
        job.options.baseline = *known;
    }
    job.board = *board;
    job.options.stereo = !options.right.empty();
    auto left = files_of_pattern(options.left);
    if (!left) {
        return left.error();
    }
    job.pictures.left = std::move(*left);
    if (job.options.stereo) {
        auto right = files_of_pattern(options.right);
        if (!right) {
            return right.error();
        }
        job.pictures.right = std::move(*right);
        if (job.pictures.right.size() != job.pictures.left.size()) {
            return Error{"There are " + std::to_string(job.pictures.left.size()) + " left and " +
                             std::to_string(job.pictures.right.size()) + " right pictures.",
                         "Give pairs: the same number on both sides, in the same order."};
        }
    }
    return job;
}

// Reads one picture and looks for the board in it.
Result<Done> look(const fs::path& file, Job& job, std::vector<Eigen::Vector2d>& corners,
                  std::string& fault) {
    const auto picture = read_picture(file);
    if (!picture) {
        return picture.error();
    }
    CalibratorOptions& options = job.options;
    if (options.width_px == 0) {
        options.width_px = picture->width();
        options.height_px = picture->height();
    }
    if (picture->width() != options.width_px || picture->height() != options.height_px) {
        return Error{file.string() + " has " + std::to_string(picture->width()) + " x " +
                         std::to_string(picture->height()) + " pixels, the pictures before it " +
                         std::to_string(options.width_px) + " x " +
                         std::to_string(options.height_px) + ".",
                     "Calibrate from pictures of one size."};
    }
    auto found = detect_chessboard(grey_from(*picture), job.board);
    if (found) {
        corners = std::move(*found);
    } else {
        fault = found.error().cause;
    }
    return Done{};
}

Result<Done> look_at_all(Job& job, ProgressLine& progress) {
    job.views.resize(job.pictures.left.size());
    for (std::size_t i = 0; i < job.views.size(); ++i) {
        progress.show(static_cast<double>(i) / static_cast<double>(job.views.size()),
                      "looking for the target in view " + std::to_string(i + 1));
        BoardView& view = job.views[i];
        if (const auto done = look(job.pictures.left[i], job, view.left_px, view.left_fault);
            !done) {
            return done;
        }
        if (!job.options.stereo) {
            continue;
        }
        if (const auto done = look(job.pictures.right[i], job, view.right_px, view.right_fault);
            !done) {
            return done;
        }
    }
    return Done{};
}

Json camera_json(const CameraResult& result) {
    constexpr std::array names{"fx_px", "fy_px", "cx_px", "cy_px", "k1", "k2",
                               "p1",    "p2",    "k3",    "k4",    "k5", "k6"};
    const auto& lens = std::get<BrownLens>(result.camera.lens);
    Json sigma;
    for (std::size_t i = 0; i < 9; ++i) {
        sigma[names[i]] = result.sigma[i];
    }
    return {{"fx_px", lens.fx_px()}, {"fy_px", lens.fy_px()},           {"cx_px", lens.cx_px()},
            {"cy_px", lens.cy_px()}, {"distortion", lens.distortion()}, {"rms_px", result.rms_px},
            {"sigma", sigma}};
}

Json report_json(const CalibrationReport& report, const Pictures& pictures) {
    const bool accepted = report.verdict != CalibrationReport::Verdict::refused;
    Json rejected = Json::array();
    for (const RejectedView& view : report.views_rejected) {
        const bool right = view.reason.starts_with("right");
        const auto& files = right ? pictures.right : pictures.left;
        rejected.push_back({{"file", files[static_cast<std::size_t>(view.view)].string()},
                            {"reason", view.reason}});
    }
    Json json{{"verdict", to_string(report.verdict)},
              {"accepted", accepted},
              {"reasons", report.reasons},
              {"rms_px", report.rms_px},
              {"corners_used", report.corners_used},
              {"corners_total", report.corners_total},
              {"views_used", report.views_used},
              {"views_rejected", rejected}};
    if (report.views_used == 0) {
        return json;
    }
    json["cameras"]["left"] = camera_json(report.left);
    if (report.right && report.stereo_rms_px) {
        json["stereo_rms_px"] = *report.stereo_rms_px;
        json["cameras"]["right"] = camera_json(*report.right);
        Json R = Json::array();
        for (int i = 0; i < 3; ++i) {
            R.push_back({report.T_right_from_left.R(i, 0), report.T_right_from_left.R(i, 1),
                         report.T_right_from_left.R(i, 2)});
        }
        const Eigen::Vector3d& t = report.T_right_from_left.t_mm;
        const Eigen::Vector3d& s = report.sigma_T_mm;
        json["pairs"]["left_right"] = {{"baseline_mm", t.norm()},
                                       {"baseline_sigma_mm", report.baseline_sigma_mm},
                                       {"R", R},
                                       {"T_mm", {t.x(), t.y(), t.z()}},
                                       {"T_sigma_mm", {s.x(), s.y(), s.z()}}};
    }
    return json;
}

std::string summary_of(const CalibrationReport& report, const fs::path& out) {
    char line[240];
    std::snprintf(line, sizeof line,
                  "Verdict: %s. %d views, %d of %d corners, residuals %.3f px.\n",
                  to_string(report.verdict).c_str(), report.views_used, report.corners_used,
                  report.corners_total, report.rms_px);
    std::string text = line;
    if (report.right) {
        std::snprintf(line, sizeof line, "Baseline %.3f mm, 1 sigma %.3f mm.\n",
                      report.T_right_from_left.t_mm.norm(), report.baseline_sigma_mm);
        text += line;
    }
    for (const RejectedView& view : report.views_rejected) {
        text += "View " + std::to_string(view.view + 1) + " left out: " + view.reason + "\n";
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
    auto job = planned(options);
    if (!job) {
        return failed(job.error(), Json::object());
    }
    ProgressLine progress;
    if (const auto looked = look_at_all(*job, progress); !looked) {
        return failed(looked.error(), Json::object());
    }
    CalibrationReport report =
        calibrate_chessboard(job->views, job->board, job->options, {},
                             [&progress](double share) { progress.show(share, "adjusting"); });
    const Json json = report_json(report, job->pictures);
    if (report.verdict == CalibrationReport::Verdict::refused) {
        std::string why;
        for (const std::string& reason : report.reasons) {
            why += " " + reason;
        }
        return failed({"The calibration is refused." + why,
                       "No rig file was written. Take more views, sharp and at several angles, "
                       "and check the target's numbers."},
                      json);
    }
    report.rig.provenance.method =
        options.target + ", brown, " + std::to_string(report.views_used) + " views";
    report.rig.provenance.created = now_iso8601();
    report.rig.provenance.program = program_name;
    if (const auto written = write_rig_file(options.out, report.rig); !written) {
        return failed(written.error(), json);
    }
    return {std::nullopt, json.dump(2), summary_of(report, options.out)};
}

}  // namespace kambara::cli
