// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/calibrate_head_command.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>

#include "app/cli/named_table.h"
#include "app/cli/terminal.h"
#include "core/calibration/target.h"
#include "core/calibration/target_detector.h"
#include "core/camera/rig_file.h"
#include "core/pointing/head_calibration.h"
#include "core/stereo/position.h"
#include "hardware/media/picture_file.h"

namespace kambara::cli {
namespace {

constexpr std::size_t least_corners = 8;

struct Gathered {
    std::vector<HeadView> views;
    nlohmann::json rejected = nlohmann::json::array();
};

// Errors here reject a view, not the command.
Result<DetectedCorners> corners_in(const std::filesystem::path& file, const Target& target,
                                   const Camera& camera) {
    const auto picture = read_picture(file);
    if (!picture) {
        return picture.error();
    }
    if (picture->width() != camera.width_px || picture->height() != camera.height_px) {
        return Error{file.string() + " is not of the size that the rig was calibrated for.",
                     "Give pictures of that size."};
    }
    return detect_target(*picture, target);
}

// The target's pose from its corners in both fixed cameras: each corner's position, then the
// target, whose shape is known, laid upon them.
Result<RigidTransform> target_in_rig(const Rig& rig, const Target& target,
                                     const DetectedCorners& left, const DetectedCorners& right) {
    std::map<int, DetectedCorner> others;
    for (const DetectedCorner& corner : right) {
        others[corner.id] = corner;
    }
    const auto corners = corners_in_target_mm(target);
    const RigidTransform T_rig_from_left = rig.left.T_camera_from_rig.inverse();
    Eigen::Matrix3Xd known(3, static_cast<Eigen::Index>(left.size()));
    Eigen::Matrix3Xd measured = known;
    Eigen::Index count = 0;
    for (const DetectedCorner& corner : left) {
        const auto other = others.find(corner.id);
        if (other == others.end()) {
            continue;
        }
        const auto position = position_from_pair(rig, {corner.px}, {other->second.px});
        if (position) {
            known.col(count) = corners[static_cast<std::size_t>(corner.id)];
            measured.col(count) = T_rig_from_left * position->point_in_left_mm;
            ++count;
        }
    }
    if (count < static_cast<Eigen::Index>(least_corners)) {
        return Error{"The left and the right picture share only " + std::to_string(count) +
                         " corners of the target.",
                     "Show it to both."};
    }
    const Eigen::Matrix4d T =
        Eigen::umeyama(known.leftCols(count), measured.leftCols(count), false);
    return RigidTransform{T.topLeftCorner<3, 3>(), T.topRightCorner<3, 1>()};
}

int side_of(const NamedRow& row, const char* column) {
    const auto cell = row.cells.find(column);
    return cell == row.cells.end()   ? 0
           : cell->second == "below" ? 1
           : cell->second == "above" ? -1
                                     : 0;
}

Result<HeadView> view_of(const NamedRow& row, const std::filesystem::path& folder, const Rig& rig,
                         const Target& target) {
    const auto angles_deg = row.pair("pan_deg", "tilt_deg");
    if (!angles_deg) {
        return Error{"pan_deg and tilt_deg are not two numbers.", "Write them."};
    }
    const auto file = [&](const char* column) { return folder / row.cells.at(column); };
    const auto left = corners_in(file("left"), target, rig.left);
    const auto right = corners_in(file("right"), target, *rig.right);
    const auto head = corners_in(file("pan_tilt"), target, *rig.pan_tilt);
    for (const auto* found : {&left, &right, &head}) {
        if (!*found) {
            return found->error();
        }
    }
    const auto T_rig_from_target = target_in_rig(rig, target, *left, *right);
    if (!T_rig_from_target) {
        return T_rig_from_target.error();
    }
    HeadView view;
    view.encoder = {rad_from_deg(angles_deg->x()), rad_from_deg(angles_deg->y())};
    view.approach = {side_of(row, "pan_from"), side_of(row, "tilt_from")};
    const auto corners = corners_in_target_mm(target);
    for (const DetectedCorner& corner : *head) {
        view.sightings.push_back(
            {*T_rig_from_target * corners[static_cast<std::size_t>(corner.id)], corner.px});
    }
    if (view.sightings.size() < least_corners) {
        return Error{"The head's camera sees too few of the target's corners.",
                     "Turn the head towards it."};
    }
    return view;
}

Result<Gathered> gathered(const CalibrateHeadOptions& options, const Rig& rig,
                          const Target& target) {
    const auto table =
        read_named_table(options.views, {"left", "right", "pan_tilt", "pan_deg", "tilt_deg"});
    if (!table) {
        return table.error();
    }
    const auto folder = std::filesystem::path(options.views).parent_path();
    Gathered all;
    ProgressLine progress;
    for (std::size_t i = 0; i < table->rows.size(); ++i) {
        progress.show(static_cast<double>(i) / static_cast<double>(table->rows.size()),
                      "looking for the target");
        const auto view = view_of(table->rows[i], folder, rig, target);
        if (view) {
            all.views.push_back(*view);
        } else {
            all.rejected.push_back({{"line", table->rows[i].line}, {"reason", view.error().cause}});
        }
    }
    return all;
}

nlohmann::json json_of(const HeadCalibration& result, const nlohmann::json& rejected) {
    const HeadModel& model = result.model;
    const Eigen::Vector3d& arm = model.T_camera_from_tilt.t_mm;
    const Eigen::Vector3d& arm_sigma = result.camera_from_tilt_sigma_mm;
    nlohmann::json json{
        {"rms_px", result.rms_px},
        {"rms_without_model_px", result.rms_without_model_px},
        {"views_used", result.views},
        {"views_rejected", rejected},
        {"points", result.points},
        {"tilt_axis_ahead_mm", model.tilt_axis_ahead_mm},
        {"tilt_axis_ahead_sigma_mm", result.tilt_axis_ahead_sigma_mm},
        {"tilt_axis_skew_deg", deg_from_rad(model.tilt_axis_skew_rad)},
        {"camera_from_tilt_mm", {arm.x(), arm.y(), arm.z()}},
        {"camera_from_tilt_sigma_mm", {arm_sigma.x(), arm_sigma.y(), arm_sigma.z()}},
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
    return json;
}

std::string backlash(const char* axis, bool seen, double rad, double sigma_rad) {
    char text[120];
    std::snprintf(text, sizeof text, "Backlash of %s: %.3f degrees (deviation %.4f).\n", axis,
                  deg_from_rad(rad), deg_from_rad(sigma_rad));
    return seen ? text
                : std::string("Backlash of ") + axis +
                      ": not measured; give views approached from below and from above.\n";
}

std::string summary_of(const HeadCalibration& result, std::size_t rejected) {
    const HeadModel& model = result.model;
    char text[400];
    std::snprintf(
        text, sizeof text,
        "%d views (%zu rejected), %d points: RMS %.3f px; %.3f px if the camera turned about its "
        "own centre.\nThe tilt axis lies %.1f mm ahead of the pan axis, the camera's centre %.1f "
        "mm off the tilt axis.\n",
        result.views, rejected, result.points, result.rms_px, result.rms_without_model_px,
        model.tilt_axis_ahead_mm, model.T_camera_from_tilt.centre_mm().tail<2>().norm());
    return text +
           backlash("pan", result.pan_backlash_seen, model.pan_backlash_rad,
                    result.pan_backlash_sigma_rad) +
           backlash("tilt", result.tilt_backlash_seen, model.tilt_backlash_rad,
                    result.tilt_backlash_sigma_rad);
}

}  // namespace

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
    const auto all = gathered(options, *rig, *target);
    if (!all) {
        return failed(all.error());
    }
    rejected = all->rejected;
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
    if (const auto written = write_rig_file(options.out, with_head_model(*rig, result->model));
        !written) {
        return failed(written.error());
    }
    Outcome outcome;
    outcome.json = json_of(*result, rejected).dump(2);
    outcome.summary = summary_of(*result, rejected.size());
    return outcome;
}

}  // namespace kambara::cli
