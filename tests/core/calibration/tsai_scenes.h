// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <random>
#include <vector>

#include "core/calibration/seen_point.h"
#include "core/calibration/tsai_calibrator.h"

namespace kambara::testing_support {

using Random = std::mt19937_64;

double uniform(Random& random, double low, double high);

/// Any camera before any target that Tsai's method can work with: 20 to 60 points with depth, in
/// a world frame of any attitude, and what the camera sees of them without noise.
struct TsaiScene {
    TsaiView truth;
    std::vector<SeenPoint> points;
    TsaiOptions options;  ///< the sensor, and a centre up to 20 px off
};
TsaiScene any_scene(Random& random);

/// The nominal left camera before the 24-box target at a distance, within 25 degrees of facing it
/// and 20 of upright; every corner in the picture. Empty where this draw does not show them all.
std::optional<TsaiScene> target_scene(Random& random, double distance_mm);

std::vector<SeenPoint> with_noise(std::vector<SeenPoint> points, double sigma_px, Random& random);

/// What no unbiased estimate of the eleven parameters can better, for so much noise in each
/// coordinate: the diagonal of the inverse information, by differences of the projection.
TsaiVector cramer_rao_sigma(const TsaiScene& scene, double sigma_px);

/// Estimate minus truth, the turn as its rotation vector in the camera's frame, rad.
TsaiVector error_of(const TsaiView& estimate, const TsaiView& truth);

}  // namespace kambara::testing_support
