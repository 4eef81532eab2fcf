// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/stereo/position_method.h"

#include <cmath>
#include <cstdio>

#include "core/base/angles.h"

namespace kambara {
namespace {

constexpr const char* names[] = {"reprojection", "sine", "midpoint", "parallel"};
constexpr double most_off_parallel_deg = 0.1;

}  // namespace

std::string to_string(PositionMethod method) {
    return names[static_cast<int>(method)];
}

Result<PositionMethod> position_method_from(std::string_view name) {
    for (int i = 0; i < 4; ++i) {
        if (name == names[i]) {
            return static_cast<PositionMethod>(i);
        }
    }
    return Error{"There is no position method \"" + std::string(name) + "\".",
                 "Give reprojection, sine, midpoint or parallel."};
}

Result<Done> check_position_method(const Rig& rig, PositionMethod method) {
    if (!rig.right) {
        return Error{"The rig file holds no right camera: one camera alone gives no position.",
                     "Calibrate both cameras."};
    }
    if (method != PositionMethod::parallel) {
        return Done{};
    }
    const RigidTransform T = T_right_from_left(rig);
    const double cosine = std::min(1.0, std::max(-1.0, 0.5 * (T.R.trace() - 1.0)));
    const double turned_deg = deg_from_rad(std::acos(cosine));
    const Eigen::Vector3d along = T.centre_mm().normalized();
    const double ahead_deg = deg_from_rad(std::acos(std::min(1.0, std::abs(along.x()))));
    if (turned_deg <= most_off_parallel_deg && ahead_deg <= most_off_parallel_deg) {
        return Done{};
    }
    char text[200];
    std::snprintf(text, sizeof text,
                  "The method parallel needs parallel cameras side by side: these are turned by "
                  "%.2f degrees against each other, and the baseline by %.2f degrees against the "
                  "picture's x axis (at most %.1f each).",
                  turned_deg, ahead_deg, most_off_parallel_deg);
    return Error{text, "Choose another method, or a rectified pair of pictures with its rig."};
}

}  // namespace kambara
