// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/track_table.h"

#include <cmath>
#include <cstdio>

#include "core/base/angles.h"

namespace kambara::cli {
namespace {

std::string number(double value, const char* format) {
    char text[64];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

std::string pair(const std::optional<Eigen::Vector2d>& pixel) {
    return pixel ? number(pixel->x(), "%.3f") + "," + number(pixel->y(), "%.3f") : ",";
}

// A reason may hold commas and quotes.
std::string quoted(const std::string& text) {
    if (text.empty()) {
        return text;
    }
    std::string result = "\"";
    for (const char c : text) {
        result += c;
        if (c == '"') {
            result += c;
        }
    }
    return result + "\"";
}

constexpr const char* columns =
    "frame,time_s,state,left_x_px,left_y_px,right_x_px,right_y_px,quality,x_mm,y_mm,z_mm,"
    "sigma_x_mm,sigma_y_mm,sigma_z_mm,pan_deg,tilt_deg,reason,calibration_sigma_x_mm,"
    "calibration_sigma_y_mm,calibration_sigma_z_mm";

Eigen::Vector3d sigmas(const Eigen::Matrix3d& covariance_mm2, const Eigen::Matrix3d& R) {
    return (R * covariance_mm2 * R.transpose()).diagonal().cwiseMax(0.0).cwiseSqrt();
}

std::string row_of(const Snapshot& snapshot, const TrackEstimate& estimate,
                   const RigidTransform& T) {
    std::string row = std::to_string(snapshot.frame) + "," +
                      number(static_cast<double>(snapshot.time_ns) * 1e-9, "%.6f") + "," +
                      to_string(estimate.state) + "," + pair(estimate.left_px) + "," +
                      pair(estimate.right_px) + "," + number(estimate.quality, "%.4f") + ",";
    if (estimate.position) {
        const Eigen::Vector3d p = T * estimate.position->point_in_left_mm;
        const Eigen::Vector3d sigma = sigmas(estimate.position->covariance_mm2, T.R);
        for (const double value : {p.x(), p.y(), p.z(), sigma.x(), sigma.y(), sigma.z()}) {
            row += number(value, "%.4f") + ",";
        }
    } else {
        row += ",,,,,,";
    }
    if (snapshot.head) {
        row += number(deg_from_rad(snapshot.head->angles.pan_rad), "%.3f") + "," +
               number(deg_from_rad(snapshot.head->angles.tilt_rad), "%.3f") + ",";
    } else {
        row += ",,";
    }
    row += quoted(estimate.reason);
    if (!estimate.position || !estimate.position->calibration_covariance_mm2) {
        return row + ",,,";
    }
    for (const double value : sigmas(*estimate.position->calibration_covariance_mm2, T.R)) {
        row += "," + number(value, "%.4f");
    }
    return row;
}

}  // namespace

std::string track_table_header() {
    return std::string(columns) + "\n";
}

std::string track_table_row(const Snapshot& snapshot, const RigidTransform& T_frame_from_left) {
    return row_of(snapshot, steered_estimate(snapshot), T_frame_from_left) + "\n";
}

std::string targets_table_header() {
    return std::string(columns) + ",target\n";
}

std::string targets_table_rows(const Snapshot& snapshot, const RigidTransform& T_frame_from_left) {
    std::string rows;
    for (const TrackSnapshot& track : snapshot.tracks) {
        rows += row_of(snapshot, track.estimate, T_frame_from_left) + "," +
                std::to_string(track.id) + "\n";
    }
    return rows;
}

}  // namespace kambara::cli
