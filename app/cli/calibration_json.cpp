// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/calibration_json.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace kambara::cli {
namespace {

using Json = nlohmann::json;

Json camera_json(const CameraResult& result) {
    Json json;
    for (const NamedValue& parameter : result.parameters) {
        json[parameter.name] = parameter.value;
        json["sigma"][parameter.name] = parameter.sigma;
    }
    const auto p = pinhole_parameters(result.camera.lens);
    json["fx_px"] = p.fx_px;
    json["fy_px"] = p.fy_px;
    if (const auto* brown = std::get_if<BrownLens>(&result.camera.lens)) {
        json["distortion"] = brown->distortion();
    }
    json["rms_px"] = result.rms_px;
    json["corners_used"] = result.corners_used;
    json["views_used"] = result.views_used;
    json["picture_share"] = result.picture_share;
    json["systematic_px"] = result.systematic_px;
    json["blur_px"] = result.blur_px;
    return json;
}

Json pair_json(const PairResult& pair) {
    Json R = Json::array();
    for (int i = 0; i < 3; ++i) {
        const Eigen::RowVector3d row = pair.T_other_from_left.R.row(i);
        R.push_back({row[0], row[1], row[2]});
    }
    const Eigen::Vector3d& t = pair.T_other_from_left.t_mm;
    const Eigen::Vector3d& s = pair.sigma_T_mm;
    return {{"baseline_mm", pair.baseline_mm},
            {"baseline_sigma_mm", pair.baseline_sigma_mm},
            {"R", R},
            {"T_mm", {t.x(), t.y(), t.z()}},
            {"T_sigma_mm", {s.x(), s.y(), s.z()}}};
}

Json range_json(const CalibrationReport& report) {
    Json points = Json::array();
    double sum = 0.0;
    double worst = 0.0;
    double total = 0.0;
    for (const RangeErrorPoint& p : report.range_errors) {
        const double share = p.sigma_calibration_mm / p.range_mm;
        sum += share;
        worst = std::max(worst, share);
        total += p.sigma_total_mm / p.range_mm;
        points.push_back({{"azimuth_deg", p.azimuth_deg},
                          {"height_mm", p.height_mm},
                          {"depth_mm", p.depth_mm},
                          {"range_mm", p.range_mm},
                          {"sigma_calibration_mm", p.sigma_calibration_mm},
                          {"sigma_total_mm", p.sigma_total_mm}});
    }
    const double n = std::max<double>(1.0, static_cast<double>(report.range_errors.size()));
    return {{"nearest_mm", report.range_options.nearest_mm},
            {"farthest_mm", report.range_options.farthest_mm},
            {"noise_px", report.range_options.noise_px},
            {"mean_percent", 100.0 * sum / n},
            {"worst_percent", 100.0 * worst},
            {"mean_with_noise_percent", 100.0 * total / n},
            {"points", points}};
}

Json rejected_json(const CalibrationReport& report, const CalibrationFiles& files) {
    Json rejected = Json::array();
    for (const RejectedView& view : report.views_rejected) {
        const auto camera = std::find(camera_names.begin(), camera_names.end(), view.camera);
        const auto c = camera == camera_names.end()
                           ? std::size_t{0}
                           : static_cast<std::size_t>(camera - camera_names.begin());
        rejected.push_back(
            {{"file", files.of_camera[c].at(static_cast<std::size_t>(view.view)).string()},
             {"camera", view.camera},
             {"reason", (view.camera.empty() ? "" : view.camera + ": ") + view.reason}});
    }
    return rejected;
}

void add_checks(const CalibrationReport& report, Json& json) {
    json["depth"] = {{"nearest_mm", report.nearest_mm}, {"farthest_mm", report.farthest_mm}};
    if (const auto& check = report.held_out) {
        json["held_out"] = {{"views", check->views},
                            {"lengths", check->lengths},
                            {"mean_error_mm", check->mean_error_mm},
                            {"largest_error_mm", check->largest_error_mm},
                            {"scale_error_percent", 100.0 * check->scale_error}};
    }
    if (const auto& check = report.baseline) {
        json["baseline_check"] = {{"measured_mm", check->measured_mm},
                                  {"measured_sigma_mm", check->measured_sigma_mm},
                                  {"found_mm", check->found_mm},
                                  {"found_sigma_mm", check->found_sigma_mm},
                                  {"pull", check->pull}};
    }
}

}  // namespace

Json calibration_json(const CalibrationReport& report, const CalibrationFiles& files) {
    Json json{{"verdict", to_string(report.verdict)},
              {"accepted", report.verdict != Verdict::refused},
              {"reasons", report.reasons},
              {"notes", report.notes},
              {"rms_px", report.rms_px},
              {"corners_used", report.corners_used},
              {"corners_total", report.corners_total},
              {"views_used", report.views_used},
              {"views_rejected", rejected_json(report, files)}};
    if (!report.cameras[0]) {
        return json;
    }
    for (std::size_t c = 0; c < most_cameras; ++c) {
        if (report.cameras[c]) {
            json["cameras"][camera_names[c]] = camera_json(*report.cameras[c]);
        }
        if (report.pairs[c]) {
            json["pairs"][std::string("left_") + camera_names[c]] = pair_json(*report.pairs[c]);
        }
    }
    if (report.stereo_rms_px) {
        json["stereo_rms_px"] = *report.stereo_rms_px;
        json["range_error"] = range_json(report);
    }
    add_checks(report, json);
    return json;
}

}  // namespace kambara::cli
