// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <random>

#include "core/base/angles.h"
#include "core/camera/rig.h"
#include "core/geometry/triangulate.h"

namespace kambara::testing_support {

// Ranges of 75 places over the working volume, by a rig that calibration found, against the truth.
struct RangeErrors {
    double mean = 0.0;
    double worst = 0.0;
};

inline RangeErrors range_errors(const Rig& truth, const Rig& found, double noise_px,
                                std::mt19937& random) {
    std::normal_distribution<double> noise(0.0, 1.0);
    RangeErrors errors;
    int n = 0;
    for (const double azimuth_deg : {-26.0, -13.0, 0.0, 13.0, 26.0}) {
        for (const double height : {-200.0, 0.0, 200.0}) {
            for (const double depth : {1000.0, 1250.0, 1500.0, 1750.0, 2000.0}) {
                const Eigen::Vector3d at(225.0 + depth * std::tan(rad_from_deg(azimuth_deg)),
                                         height, depth);
                const Eigen::Vector2d l(noise(random), noise(random));
                const Eigen::Vector2d r(noise(random), noise(random));
                const auto a = found.left.unproject(*truth.left.project(at) + noise_px * l);
                const auto b = found.right->unproject(*truth.right->project(at) + noise_px * r);
                const double error =
                    std::abs(meeting_of(*a, *b)->midpoint_mm.norm() / at.norm() - 1.0);
                errors.mean += error;
                errors.worst = std::max(errors.worst, error);
                ++n;
            }
        }
    }
    errors.mean /= n;
    return errors;
}

}  // namespace kambara::testing_support
