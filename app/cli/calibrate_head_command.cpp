// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/calibrate_head_command.h"

#include <cmath>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/named_table.h"
#include "app/cli/terminal.h"
#include "core/calibration/target.h"
#include "core/camera/rig_file.h"
#include "core/pointing/head_calibration.h"
#include "core/vsystem/head_view.h"
#include "hardware/media/picture_file.h"

namespace kambara::cli {
namespace {

constexpr double worth_saying = 1.15;   // of the RMS with the model: less may be chance
constexpr double near_mm = 700.0;       // where the lever arms cost what a head should not miss by
constexpr double changed_sigmas = 3.5;  // of the most moved of some twenty numbers

int side_of(const NamedRow& row, const char* column) {
    const auto cell = row.cells.find(column);
    return cell == row.cells.end()   ? 0
           : cell->second == "below" ? 1
           : cell->second == "above" ? -1
                                     : 0;
}

// Errors here reject a view, not the command.
Result<HeadView> view_of(const NamedRow& row, const std::filesystem::path& folder, const Rig& rig,
                         const Target& target) {
    const auto angles_deg = row.pair("pan_deg", "tilt_deg");
    if (!angles_deg) {
        return Error{"pan_deg and tilt_deg are not two numbers.", "Write them."};
    }
    HeadPictures pictures;
    const std::pair<const char*, ImagePtr*> files[] = {
        {"left", &pictures.left}, {"right", &pictures.right}, {"pan_tilt", &pictures.pan_tilt}};
    for (const auto& [column, into] : files) {
        auto picture = read_picture(folder / row.cells.at(column));
        if (!picture) {
            return picture.error();
        }
        *into = std::make_shared<const Image>(std::move(*picture));
    }
    return head_view_from(rig, target, pictures,
                          {rad_from_deg(angles_deg->x()), rad_from_deg(angles_deg->y())},
                          {side_of(row, "pan_from"), side_of(row, "tilt_from")});
}

nlohmann::json json_of(const std::vector<RejectedHeadView>& rejected) {
    nlohmann::json json = nlohmann::json::array();
    for (const RejectedHeadView& view : rejected) {
        json.push_back({{"line", view.line}, {"reason", view.reason}});
    }
    return json;
}

nlohmann::json three(const Eigen::Vector3d& v) {
    return {v.x(), v.y(), v.z()};
}

nlohmann::json json_of(const HeadCalibration& result, const nlohmann::json& rejected,
                       bool refined) {
    const HeadModel& model = result.model;
    nlohmann::json json{
        {"rms_px", result.rms_px},
        {"rms_without_model_px", result.rms_without_model_px},
        {"views_used", result.views},
        {"views_rejected", rejected},
        {"points", result.points},
        {"tilt_axis_ahead_mm", model.tilt_axis_ahead_mm},
        {"tilt_axis_ahead_sigma_mm", result.tilt_axis_ahead_sigma_mm},
        {"tilt_axis_skew_deg", deg_from_rad(model.tilt_axis_skew_rad)},
        {"camera_from_tilt_mm", three(model.T_camera_from_tilt.t_mm)},
        {"camera_from_tilt_sigma_mm", three(result.camera_from_tilt_sigma_mm)},
        {"base_from_rig_sigma_mm", three(result.base_from_rig_sigma_mm)},
        {"base_turn_sigma_deg", three(result.base_turn_sigma_rad * deg_from_rad(1.0))},
        {"rig", !result.by_rig ? "held"
                : refined      ? "refined"
                               : "prior"},
        {"pan_backlash_deg", nullptr},
        {"tilt_backlash_deg", nullptr}};
    if (result.pan_backlash_seen) {
        json["pan_backlash_deg"] = deg_from_rad(model.pan_backlash_rad);
        json["pan_backlash_sigma_deg"] = deg_from_rad(result.pan_backlash_sigma_rad);
    }
    if (result.tilt_backlash_seen) {
        json["tilt_backlash_deg"] = deg_from_rad(model.tilt_backlash_rad);
        json["tilt_backlash_sigma_deg"] = deg_from_rad(result.tilt_backlash_sigma_rad);
    }
    if (result.pair_rms_px) {
        json["pair_rms_px"] = *result.pair_rms_px;
    }
    if (result.by_rig) {
        json["pan_tilt_lens_held"] = result.by_rig->pan_tilt_lens_held;
        json["rig_most_moved"] = result.by_rig->most_moved;
        json["rig_most_moved_sigmas"] = result.by_rig->most_moved_sigmas;
    }
    return json;
}

std::string cost_of(const HeadMiss& miss) {
    char text[160];
    std::snprintf(text, sizeof text,
                  "Without the model the head would miss things %.1f m away by %.2f degrees RMS, "
                  "%.2f at most.\n",
                  1e-3 * near_mm, deg_from_rad(miss.rms_rad), deg_from_rad(miss.worst_rad));
    return text;
}

// The levers' worth depends on the rig's; what is done with it is never silent.
std::string about_rig(const HeadCalibration& result, bool refined) {
    if (!result.by_rig) {
        return "The rig is held as it is: its file has no calibration_covariance, so its own error "
               "is in none of the deviations.\n";
    }
    char text[400];
    std::snprintf(text, sizeof text,
                  "Solved with the rig's own calibration: the views move %s most, by %.1f of its "
                  "deviations%s.\n%s\n",
                  result.by_rig->most_moved.c_str(), result.by_rig->most_moved_sigmas,
                  result.by_rig->most_moved_sigmas > changed_sigmas
                      ? ": the rig has changed since, or its covariance is too narrow"
                      : "",
                  refined ? "The rig is written as the views correct it."
                          : "The rig is written as it was, with the head's numbers that steer best "
                            "beside it; --refine-rig writes both as the views correct them.");
    return text + std::string(result.by_rig->pan_tilt_lens_held
                                  ? "The pan-tilt camera's lens is held: its file has no "
                                    "pan_tilt_lens_covariance, so its error is in no deviation.\n"
                                  : "");
}

std::string backlash(const char* axis, bool seen, double rad, double sigma_rad) {
    char text[120];
    std::snprintf(text, sizeof text, "Backlash of %s: %.3f degrees (deviation %.4f).\n", axis,
                  deg_from_rad(rad), deg_from_rad(sigma_rad));
    return seen ? text
                : std::string("Backlash of ") + axis +
                      ": not measured; give views approached from below and from above.\n";
}

std::string summary_of(const HeadCalibration& result, std::size_t rejected, bool refined) {
    const HeadModel& model = result.model;
    const Eigen::Vector2d off = model.T_camera_from_tilt.centre_mm().tail<2>();
    // Along the arm, as if y and z erred apart; the camera is hardly turned on it.
    const double off_sigma_mm =
        off.normalized().cwiseProduct(result.camera_from_tilt_sigma_mm.tail<2>()).norm();
    char text[400];
    std::snprintf(
        text, sizeof text,
        "%d views (%zu rejected), %d points: RMS %.3f px; %.3f px if the camera turned about its "
        "own centre.\nThe tilt axis lies %.1f mm ahead of the pan axis (deviation %.2f), the "
        "camera's centre %.1f mm off the tilt axis (%.2f).\n",
        result.views, rejected, result.points, result.rms_px, result.rms_without_model_px,
        model.tilt_axis_ahead_mm, result.tilt_axis_ahead_sigma_mm, off.norm(), off_sigma_mm);
    std::string worth;
    if (result.rms_without_model_px < worth_saying * result.rms_px) {
        worth = "That hardly differs: the camera may as well turn about its own centre.\n";
    }
    return text + worth +
           backlash("pan", result.pan_backlash_seen, model.pan_backlash_rad,
                    result.pan_backlash_sigma_rad) +
           backlash("tilt", result.tilt_backlash_seen, model.tilt_backlash_rad,
                    result.tilt_backlash_sigma_rad) +
           about_rig(result, refined);
}

// What is written: the rig as given with the head's model for it, or both as the views correct it.
Rig rig_with_head(const Rig& given, const HeadCalibration& result, bool refined) {
    if (!refined) {
        return with_head_model(given, result.model_for_given_rig);
    }
    Rig rig = result.by_rig->refined;
    rig.provenance.method += "; refined by " + std::to_string(result.views) + " views of the head";
    return rig;
}

}  // namespace

Result<HeadRecord> read_head_record(const std::filesystem::path& file, const Rig& rig,
                                    const Target& target,
                                    const std::function<void(double share)>& progress) {
    const auto table = read_named_table(file, {"left", "right", "pan_tilt", "pan_deg", "tilt_deg"});
    if (!table) {
        return table.error();
    }
    HeadRecord record;
    for (std::size_t i = 0; i < table->rows.size(); ++i) {
        progress(static_cast<double>(i) / static_cast<double>(table->rows.size()));
        auto view = view_of(table->rows[i], file.parent_path(), rig, target);
        if (view) {
            record.views.push_back(std::move(*view));
        } else {
            record.rejected.push_back({table->rows[i].line, view.error().cause});
        }
    }
    return record;
}

Outcome run_calibrate_head(const CalibrateHeadOptions& options) {
    nlohmann::json rejected = nlohmann::json::array();
    const auto failed = [&rejected](const Error& error) {
        return Outcome{
            error, nlohmann::json{{"error", error.text()}, {"views_rejected", rejected}}.dump(2),
            ""};
    };
    const auto rig = read_rig_file(options.rig);
    if (!rig) {
        return failed(rig.error());
    }
    if (!rig->right || !rig->pan_tilt) {
        return failed({"The rig file does not hold all three cameras.",
                       "Calibrate them first, with the head at home: calibrate --pan-tilt."});
    }
    const auto target = parse_target(options.target);
    if (!target) {
        return failed(target.error());
    }
    ProgressLine progress;
    const auto all = read_head_record(options.views, *rig, *target, [&progress](double share) {
        progress.show(share, "looking for the target");
    });
    if (!all) {
        return failed(all.error());
    }
    rejected = json_of(all->rejected);
    const auto result = calibrate_head(*rig, all->views);
    if (!result) {
        Error error = result.error();
        if (!rejected.empty()) {
            error.cause += " " + std::to_string(rejected.size()) + " views were rejected; line " +
                           std::to_string(rejected[0]["line"].get<int>()) + ": " +
                           rejected[0]["reason"].get<std::string>();
        }
        return failed(error);
    }
    if (options.refine_rig && !result->by_rig) {
        return failed({"The rig can't be refined: its file does not tell how well it is known.",
                       "Calibrate the cameras with this program, or leave out --refine-rig."});
    }
    if (const auto written =
            write_rig_file(options.out, rig_with_head(*rig, *result, options.refine_rig));
        !written) {
        return failed(written.error());
    }
    Outcome outcome;
    Rig without = *rig;
    without.head.reset();
    const HeadMiss miss = missed_without_model(with_head_model(*rig, result->model_for_given_rig),
                                               without, all->views, near_mm);
    nlohmann::json json = json_of(*result, rejected, options.refine_rig);
    json["missed_at_700_mm_without_model_rms_deg"] = deg_from_rad(miss.rms_rad);
    json["missed_at_700_mm_without_model_worst_deg"] = deg_from_rad(miss.worst_rad);
    outcome.json = json.dump(2);
    outcome.summary = summary_of(*result, rejected.size(), options.refine_rig) + cost_of(miss);
    return outcome;
}

}  // namespace kambara::cli
