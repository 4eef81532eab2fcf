// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/triangulate_command.h"

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <sstream>
#include <vector>

#include "core/base/text_file.h"
#include "core/camera/rig_file.h"
#include "core/stereo/position.h"

namespace kambara::cli {
namespace {

struct PixelPair {
    int line = 0;
    Eigen::Vector2d left;
    Eigen::Vector2d right;
};

Result<std::vector<PixelPair>> read_points(const std::filesystem::path& path) {
    const auto text = read_text_file(path);
    if (!text) {
        return text.error();
    }
    std::vector<PixelPair> pairs;
    std::istringstream lines(*text);
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) {
        line = line.substr(0, line.find('#'));
        for (char& c : line) {
            c = c == ',' || c == ';' || c == '\r' ? ' ' : c;
        }
        if (line.find_first_not_of(" \t") == std::string::npos) {
            continue;
        }
        std::istringstream words(line);
        PixelPair pair;
        pair.line = number;
        std::string rest;
        words >> pair.left.x() >> pair.left.y() >> pair.right.x() >> pair.right.y();
        if (!words || (words >> rest)) {
            return Error{"Line " + std::to_string(number) + " of " + path.string() +
                             " does not hold four numbers.",
                         "Write one pair of pixels a line: xl yl xr yr."};
        }
        pairs.push_back(pair);
    }
    if (pairs.empty()) {
        return Error{path.string() + " holds no points.", "Write one pair a line: xl yl xr yr."};
    }
    return pairs;
}

nlohmann::json row_of(const Result<Position>& position) {
    const char* keys[] = {"x_mm",       "y_mm",       "z_mm",       "sigma_x_mm",
                          "sigma_y_mm", "sigma_z_mm", "residual_px"};
    const char* of_calibration[] = {"calibration_sigma_x_mm", "calibration_sigma_y_mm",
                                    "calibration_sigma_z_mm"};
    nlohmann::json row;
    if (!position) {
        for (const char* key : keys) {
            row[key] = nullptr;
        }
        for (const char* key : of_calibration) {
            row[key] = nullptr;
        }
        row["reason"] = position.error().cause;
        return row;
    }
    const Eigen::Vector3d& p = position->point_in_left_mm;
    const Eigen::Vector3d sigma = position->covariance_mm2.diagonal().cwiseSqrt();
    const double values[] = {
        p.x(), p.y(), p.z(), sigma.x(), sigma.y(), sigma.z(), position->residual_px};
    for (std::size_t i = 0; i < std::size(keys); ++i) {
        row[keys[i]] = values[i];
    }
    for (int i = 0; i < 3; ++i) {
        const auto& c = position->calibration_covariance_mm2;
        row[of_calibration[i]] = c ? nlohmann::json(std::sqrt((*c)(i, i))) : nlohmann::json();
    }
    row["reason"] = "";
    return row;
}

std::string line_of(const nlohmann::json& row, int number) {
    if (row["x_mm"].is_null()) {
        return "line " + std::to_string(number) +
               ": no position: " + row["reason"].get<std::string>() + "\n";
    }
    const auto value = [&](const char* key) { return row[key].get<double>(); };
    char line[200];
    std::snprintf(line, sizeof line, "%12.3f %12.3f %12.3f   %9.3f %9.3f %9.3f   %8.3f",
                  value("x_mm"), value("y_mm"), value("z_mm"), value("sigma_x_mm"),
                  value("sigma_y_mm"), value("sigma_z_mm"), value("residual_px"));
    std::string text = line;
    if (!row["calibration_sigma_x_mm"].is_null()) {
        std::snprintf(line, sizeof line, "   %9.3f %9.3f %9.3f", value("calibration_sigma_x_mm"),
                      value("calibration_sigma_y_mm"), value("calibration_sigma_z_mm"));
        text += line;
    }
    return text + "\n";
}

}  // namespace

Outcome run_triangulate(const TriangulateOptions& options) {
    const auto failed = [](const Error& error) {
        return Outcome{error, nlohmann::json{{"error", error.text()}}.dump(2), ""};
    };
    const auto rig = read_rig_file(options.rig);
    if (!rig) {
        return failed(rig.error());
    }
    if (!rig->right) {
        return failed({"The rig file holds no right camera.", "Calibrate both cameras."});
    }
    const auto method = position_method_from(options.method);
    if (!method) {
        return failed(method.error());
    }
    if (const auto suits = check_position_method(*rig, *method); !suits) {
        return failed(suits.error());
    }
    const auto pairs = read_points(options.points);
    if (!pairs) {
        return failed(pairs.error());
    }
    const Eigen::Matrix2d covariance =
        options.sigma_px * options.sigma_px * Eigen::Matrix2d::Identity();
    nlohmann::json rows = nlohmann::json::array();
    Outcome outcome;
    outcome.summary =
        "        x mm         y mm         z mm     1 sigma: x         y         z   residual px";
    outcome.summary += rig->parameter_covariance
                           ? "   by the calibration: x     y         z\n"
                           : "   (the rig file tells no uncertainty of the calibration)\n";
    PositionOptions position_options;
    position_options.method = *method;
    int positions = 0;
    for (const PixelPair& pair : *pairs) {
        rows.push_back(
            row_of(position_from_pair(*rig, PixelMeasurement{pair.left, covariance},
                                      PixelMeasurement{pair.right, covariance}, position_options)));
        outcome.summary += line_of(rows.back(), pair.line);
        positions += rows.back()["x_mm"].is_null() ? 0 : 1;
    }
    if (positions == 0) {
        outcome.failure =
            Error{"None of the " + std::to_string(pairs->size()) + " pairs gives a position.",
                  "The table tells why; check that the rig file is the cameras'."};
    }
    outcome.json = nlohmann::json{{"method", options.method}, {"points", std::move(rows)}}.dump(2);
    return outcome;
}

}  // namespace kambara::cli
