// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/calibrate_points_command.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <set>
#include <vector>

#include "app/cli/now.h"
#include "core/base/angles.h"
#include "core/base/text_file.h"
#include "core/calibration/point_list.h"
#include "core/calibration/tsai_calibrator.h"
#include "core/camera/rig_file.h"

namespace kambara::cli {
namespace {

using Json = nlohmann::json;

struct PictureSize {
    int width_px = 0;
    int height_px = 0;
};

struct Job {
    PointList list;
    TsaiOptions options;
    PictureSize size;
};

// Exactly N numbers, apart by commas.
template <std::size_t N>
Result<std::array<double, N>> numbers(const std::string& text, const std::string& option,
                                      const std::string& form) {
    std::array<double, N> values{};
    std::size_t begin = 0;
    bool good = true;
    for (std::size_t i = 0; i < N && good; ++i) {
        const auto end = std::min(text.find(',', begin), text.size());
        const std::string word = text.substr(begin, end - begin);
        char* stop = nullptr;
        values[i] = std::strtod(word.c_str(), &stop);
        const bool last = i + 1 == N;
        good = !word.empty() && *stop == '\0' && std::isfinite(values[i]) &&
               (end == text.size()) == last;
        begin = end + 1;
    }
    if (!good) {
        return Error{option + " \"" + text + "\" is not understood.", "Give it as " + form + "."};
    }
    return values;
}

// Where no size is given: the sensor's columns and twice the centre's row, made even, unless a
// point lies beyond.
PictureSize likely_size(const PointList& list, const TsaiOptions& options) {
    double width = std::round(options.sensor.nfx);
    double height = 2.0 * std::ceil(options.cy_px);
    for (const auto* points : {&list.left, &list.right}) {
        for (const SeenPoint& point : *points) {
            width = std::max(width, std::ceil(point.seen_px.x()) + 1.0);
            height = std::max(height, std::ceil(point.seen_px.y()) + 1.0);
        }
    }
    constexpr double largest = 100000.0;
    return {static_cast<int>(std::min(width, largest)),
            static_cast<int>(std::min(height, largest))};
}

Result<Job> planned(const CalibratePointsOptions& options) {
    Job job;
    if (options.method != "basic" && options.method != "full") {
        return Error{"There is no method \"" + options.method + "\".",
                     "Use --method basic or full."};
    }
    job.options.method = options.method == "basic" ? TsaiMethod::basic : TsaiMethod::full;
    job.options.coplanar = options.coplanar;
    const auto sensor =
        numbers<4>(options.sensor, "--sensor", "dx,dy,Ncx,Nfx, for example 0.00635,0.0074,768,640");
    if (!sensor) {
        return sensor.error();
    }
    if (*std::min_element(sensor->begin(), sensor->end()) <= 0.0) {
        return Error{"A number of --sensor is not positive.",
                     "Give the pixel's width and height in mm, the sensor's columns and the "
                     "picture's columns."};
    }
    job.options.sensor = {(*sensor)[0], (*sensor)[1], (*sensor)[2], (*sensor)[3]};
    const auto center = numbers<2>(options.center, "--center", "Cx,Cy in px");
    if (!center) {
        return center.error();
    }
    job.options.cx_px = (*center)[0];
    job.options.cy_px = (*center)[1];
    const auto text = read_text_file(options.points);
    if (!text) {
        return text.error();
    }
    auto list = point_list_from_text(*text);
    if (!list) {
        return Error{options.points.string() + ": " + list.error().cause, list.error().remedy};
    }
    job.list = std::move(*list);
    job.size = likely_size(job.list, job.options);
    if (options.size) {
        const auto size = numbers<2>(*options.size, "--size", "W,H in px");
        if (!size) {
            return size.error();
        }
        if ((*size)[0] < 1.0 || (*size)[1] < 1.0 || (*size)[0] > 1e5 || (*size)[1] > 1e5) {
            return Error{"--size is no picture's size.", "Give it as W,H in px."};
        }
        job.size = {static_cast<int>((*size)[0]), static_cast<int>((*size)[1])};
    }
    return job;
}

Json matrix_json(const Eigen::Matrix3d& R) {
    Json rows = Json::array();
    for (int i = 0; i < 3; ++i) {
        rows.push_back({R(i, 0), R(i, 1), R(i, 2)});
    }
    return rows;
}

Json vector_json(const Eigen::Vector3d& v) {
    return {v.x(), v.y(), v.z()};
}

// Turns about x, then y, then z: R = Rz Ry Rx, in degrees.
Eigen::Vector3d angles_deg(const Eigen::Matrix3d& R) {
    return {deg_from_rad(std::atan2(R(2, 1), R(2, 2))),
            deg_from_rad(std::atan2(-R(2, 0), std::hypot(R(0, 0), R(1, 0)))),
            deg_from_rad(std::atan2(R(1, 0), R(0, 0)))};
}

Json uncertainty_json(const TsaiVector& v) {
    return {{"f_mm", v[tsai::f]},
            {"kappa1_per_mm2", v[tsai::kappa1]},
            {"cx_px", v[tsai::c_x]},
            {"cy_px", v[tsai::c_y]},
            {"sx", v[tsai::s_x]},
            {"T_mm", vector_json(v.segment<3>(tsai::t_x))},
            {"turn_deg",
             vector_json(v.head<3>().unaryExpr([](double rad) { return deg_from_rad(rad); }))}};
}

std::vector<int> lines_of(const TsaiReport& report, const PointList& list) {
    std::vector<int> lines;
    for (const int i : report.outliers) {
        lines.push_back(list.lines[static_cast<std::size_t>(i)]);
    }
    return lines;
}

Json camera_json(const TsaiReport& report, const PointList& list) {
    const TsaiLens& lens = report.view.lens;
    const RigidTransform& T = report.view.T_camera_from_world;
    Json json{{"f_mm", lens.f_mm},
              {"kappa1_per_mm2", lens.kappa1_per_mm2},
              {"cx_px", lens.cx_px},
              {"cy_px", lens.cy_px},
              {"sx", lens.sx},
              {"R", matrix_json(T.R)},
              {"angles_deg", vector_json(angles_deg(T.R))},
              {"T_mm", vector_json(T.t_mm)},
              {"sse_px2", report.sse_px2},
              {"mean_error_px", report.mean_error_px},
              {"max_error_px", report.max_error_px},
              {"noise_px", report.noise_px},
              {"points_used", report.points_used},
              {"degrees_of_freedom", report.degrees_of_freedom},
              {"f_bound_percent", report.f_bound_percent},
              {"poorly_determined", report.poorly_determined},
              {"outliers", lines_of(report, list)}};
    if (report.covariance) {
        json["sigma"] = uncertainty_json(report.sigma);
        json["interval_95"] = uncertainty_json(report.interval_95);
    }
    return json;
}

std::string summary_of(const std::string& name, const TsaiReport& report) {
    const TsaiLens& lens = report.view.lens;
    char text[400];
    std::snprintf(text, sizeof text,
                  "%s: f %.6f mm (1 sigma %.2g %%), kappa1 %.6g /mm^2, centre %.3f, %.3f px, "
                  "s_x %.6f; %d points, mean error %.4f px, %zu outliers.\n",
                  name.c_str(), lens.f_mm, report.f_bound_percent, lens.kappa1_per_mm2, lens.cx_px,
                  lens.cy_px, lens.sx, report.points_used, report.mean_error_px,
                  report.outliers.size());
    std::string summary = text;
    for (const std::string& reason : report.reasons) {
        summary += reason + "\n";
    }
    return summary;
}

Outcome failed(const Error& error) {
    const Json json{{"accepted", false}, {"reasons", {error.text()}}, {"error", error.text()}};
    return {error, json.dump(2), ""};
}

// A fault of one of two cameras says whose.
Error of_side(Error error, const char* side) {
    error.cause = std::string("The ") + side + " camera: " + error.cause;
    return error;
}

Camera camera_of(const TsaiReport& report, const PictureSize& size) {
    return {report.view.lens, size.width_px, size.height_px, {}};
}

}  // namespace

Outcome run_calibrate_points(const CalibratePointsOptions& options) {
    const auto job = planned(options);
    if (!job) {
        return failed(job.error());
    }
    const PointList& list = job->list;
    const bool two = !list.right.empty();
    const auto left = calibrate_tsai(list.left, job->options, list.lines);
    if (!left) {
        return failed(two ? of_side(left.error(), "left") : left.error());
    }
    Outcome outcome;
    Json json{{"method", options.method}, {"accepted", true}};
    Json reasons = left->reasons;
    std::vector<int> outliers = lines_of(*left, list);
    Rig rig;
    rig.left = camera_of(*left, job->size);
    if (!two) {
        json["camera"] = camera_json(*left, list);
        outcome.summary = summary_of("Camera", *left);
    } else {
        const auto right = calibrate_tsai(list.right, job->options, list.lines);
        if (!right) {
            return failed(of_side(right.error(), "right"));
        }
        for (const std::string& reason : right->reasons) {
            reasons.push_back(reason);
        }
        const auto more = lines_of(*right, list);
        std::set<int> either(outliers.begin(), outliers.end());
        either.insert(more.begin(), more.end());
        outliers.assign(either.begin(), either.end());
        const RigidTransform T_right_from_left =
            right->view.T_camera_from_world * left->view.T_camera_from_world.inverse();
        rig = rig_from_pair(rig.left, camera_of(*right, job->size), T_right_from_left);
        json["cameras"] = {{"left", camera_json(*left, list)},
                           {"right", camera_json(*right, list)}};
        json["pairs"]["left_right"] = {{"baseline_mm", baseline_mm(rig)},
                                       {"R", matrix_json(T_right_from_left.R)},
                                       {"T_mm", vector_json(T_right_from_left.t_mm)}};
        char line[80];
        std::snprintf(line, sizeof line, "Baseline %.3f mm.\n", baseline_mm(rig));
        outcome.summary = summary_of("Left", *left) + summary_of("Right", *right) + line;
    }
    json["reasons"] = reasons;
    json["outliers"] = outliers;
    for (const int line : outliers) {
        outcome.summary += "Line " + std::to_string(line) + " left out: it does not fit.\n";
    }
    if (options.out) {
        rig.provenance.method =
            "tsai, " + options.method + ", " + std::to_string(list.lines.size()) + " points";
        rig.provenance.created = now_iso8601();
        rig.provenance.program = program_name;
        if (const auto written = write_rig_file(*options.out, rig); !written) {
            return failed(written.error());
        }
        outcome.summary += "Rig file: " + options.out->string() + ", for pictures of " +
                           std::to_string(job->size.width_px) + " x " +
                           std::to_string(job->size.height_px) + " px.\n";
    }
    outcome.json = json.dump(2);
    return outcome;
}

}  // namespace kambara::cli
